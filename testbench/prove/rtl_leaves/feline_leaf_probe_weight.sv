// SPDX-License-Identifier: Apache-2.0
// Where a probe stands, and what it weighs (testbench/prove/leaves.h, ProbeWeight).
`default_nettype none

module feline_leaf_probe_weight #(
  localparam int unsigned InputWidth = feline_pkg::ProbeCountWidth + feline_pkg::WeightRowWidth +
      feline_pkg::ProbeIndexWidth,
  localparam int unsigned OutputWidth = (feline_pkg::ProbeCountWidth + 1) + feline_pkg::WeightWidth + 1
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ProbeCountWidth-1:0]       probes;
  logic [feline_pkg::WeightRowWidth-1:0]        weight_row;
  logic [feline_pkg::ProbeIndexWidth-1:0]       probe;
  logic [(feline_pkg::ProbeCountWidth + 1)-1:0] n;
  logic [feline_pkg::WeightWidth-1:0]           weight;
  logic [1-1:0]                                 present;

  assign {probes, weight_row, probe} = inputs_i;
  assign outputs_o = {n, weight, present};

  feline_probe_weight u_probe_weight (
    .probe_i(probe), .probes_i(probes), .weight_row_i(weight_row), .n_o(n), .weight_o(weight), .present_o(present)
  );
endmodule

`default_nettype wire
