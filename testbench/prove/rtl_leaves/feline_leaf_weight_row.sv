// SPDX-License-Identifier: Apache-2.0
// The row of the weight table (testbench/prove/leaves.h, WeightRow).
`default_nettype none

module feline_leaf_weight_row #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + feline_pkg::ProbeCountWidth + feline_pkg::EighthsWidth,
  localparam int unsigned OutputWidth = feline_pkg::WeightRowWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]       mode;
  logic [feline_pkg::ProbeCountWidth-1:0] probes;
  logic [feline_pkg::EighthsWidth-1:0]    eighths;
  logic [feline_pkg::WeightRowWidth-1:0]  weight_row;

  assign {mode, probes, eighths} = inputs_i;
  assign outputs_o = {weight_row};

  feline_choose_weight_row u_choose_weight_row (
    .mode_i(mode), .probes_i(probes), .eighths_i(eighths), .weight_row_o(weight_row)
  );
endmodule

`default_nettype wire
