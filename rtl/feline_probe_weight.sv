// SPDX-License-Identifier: Apache-2.0
// Where a probe stands on the line, and what it weighs (probe_weight of model/walk.h).
//
// Takes  the number of the probe, 0 .. probes - 1; probes; weight_row.
// Gives  n = 2 probe - (probes - 1), the half steps from the centre, signed; weight U1.8; whether the configuration has
//        the row.
// Rounds nothing; the weights are rounded in their table.
// Edges  a row that is not there: weight 0.
// Source WRL 99/1, 3.1 (positions, figures 10 and 11), 3.2 (weights: row by fProbes, column floor((|n| + 1)/2)).
`default_nettype none

module feline_probe_weight (
  input  wire logic [feline_pkg::ProbeIndexWidth-1:0]      probe_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0]      probes_i,
  input  wire logic [feline_pkg::WeightRowWidth-1:0]       weight_row_i,
  output logic signed [feline_pkg::ProbeCountWidth:0]      n_o,
  output logic [feline_pkg::WeightWidth-1:0]               weight_o,
  output logic                                             present_o
);
  // n from -(probes - 1) to probes - 1, signed.
  localparam int unsigned StepWidth   = feline_pkg::ProbeCountWidth + 1;
  localparam int unsigned ColumnWidth = feline_pkg::WeightColumns > 1 ? $clog2(feline_pkg::WeightColumns) : 1;
  localparam int unsigned WordWidth   = $clog2((feline_pkg::GaussianRows + feline_pkg::MaxProbes) *
                                               feline_pkg::WeightColumns);

  logic [StepWidth-1:0]   distance;
  logic [ColumnWidth-1:0] column;
  logic [WordWidth-1:0]   word;

  assign n_o      = $signed(StepWidth'({probe_i, 1'b0}) - StepWidth'(probes_i) + StepWidth'(1));
  assign distance = n_o < 0 ? StepWidth'(-n_o) : StepWidth'(n_o);
  assign column   = ColumnWidth'((distance + StepWidth'(1)) >> 1);
  assign word     = WordWidth'(weight_row_i) * WordWidth'(feline_pkg::WeightColumns) + WordWidth'(column);

  feline_rom_weight u_rom_weight (.index_i(word), .present_o, .data_o(weight_o));
endmodule

`default_nettype wire
