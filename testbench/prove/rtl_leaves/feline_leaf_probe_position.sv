// SPDX-License-Identifier: Apache-2.0
// Where a probe lies along one axis (testbench/prove/leaves.h, ProbePosition).
`default_nettype none

module feline_leaf_probe_position #(
  localparam int unsigned InputWidth = feline_pkg::PositionWidth + feline_pkg::HalfStepWidth +
      (feline_pkg::ProbeCountWidth + 1),
  localparam int unsigned OutputWidth = feline_pkg::PositionWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic signed [feline_pkg::PositionWidth-1:0]         centre;
  logic signed [feline_pkg::HalfStepWidth-1:0]         half_step;
  logic signed [(feline_pkg::ProbeCountWidth + 1)-1:0] n;
  logic [feline_pkg::PositionWidth-1:0]                position;

  assign {centre, half_step, n} = inputs_i;
  assign outputs_o = {position};

  feline_probe_position u_probe_position (
    .centre_i(centre), .half_step_i(half_step), .n_i(n), .position_o(position)
  );
endmodule

`default_nettype wire
