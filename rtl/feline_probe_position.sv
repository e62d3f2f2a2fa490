// SPDX-License-Identifier: Apache-2.0
// Where a probe lies along one axis.
//
// Takes  centre S20.24 and half_step S19.24 textures; n, a signed count of half steps.
// Gives  centre + n * half_step, S20.24.
// Rounds nothing. Edges: modulo 2^21 textures.
// Source WRL 99/1, 3.1 (figures 10 and 11).
`default_nettype none

module feline_probe_position (
  input  wire logic signed [feline_pkg::PositionWidth-1:0] centre_i,
  input  wire logic signed [feline_pkg::HalfStepWidth-1:0] half_step_i,
  input  wire logic signed [feline_pkg::ProbeCountWidth:0] n_i,
  output logic [feline_pkg::PositionWidth-1:0]             position_o
);
  localparam int unsigned OffsetWidth = feline_pkg::HalfStepWidth + feline_pkg::ProbeCountWidth + 1;
  // Few probes of small textures do not get as far as a position that saturates far away.
  localparam int unsigned SumWidth = OffsetWidth > feline_pkg::PositionWidth ? OffsetWidth : feline_pkg::PositionWidth;

  logic signed [OffsetWidth-1:0] offset;

  assign offset     = half_step_i * n_i;
  assign position_o = feline_pkg::PositionWidth'(SumWidth'(centre_i) + SumWidth'(offset));
endmodule

`default_nettype wire
