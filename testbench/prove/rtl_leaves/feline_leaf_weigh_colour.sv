// SPDX-License-Identifier: Apache-2.0
// The pixel of one probe (testbench/prove/leaves.h, WeighColour).
`default_nettype none

module feline_leaf_weigh_colour #(
  localparam int unsigned InputWidth = feline_pkg::WeightWidth + feline_pkg::FilteredWidth,
  localparam int unsigned OutputWidth = feline_pkg::PixelWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::WeightWidth-1:0]   weight;
  logic [feline_pkg::FilteredWidth-1:0] colour;
  logic [feline_pkg::PixelWidth-1:0]    pixel;

  assign {weight, colour} = inputs_i;
  assign outputs_o = {pixel};

  feline_pkg::filter_t     filter;
  feline_pkg::accumulate_t accumulate;
  logic                    ready;
  logic                    valid;

  always_comb begin
    filter           = '0;
    filter.first     = 1'b1;
    filter.last      = 1'b1;
    filter.weight    = weight;
    filter.colour[0] = colour;
  end

  feline_accumulate u_accumulate (
    .clk_i(1'b0), .rst_i(1'b0),
    .filter_valid_i(1'b1), .filter_ready_o(ready), .filter_i(filter),
    .accumulate_valid_o(valid), .accumulate_ready_i(1'b1), .accumulate_o(accumulate)
  );

  assign pixel = accumulate.colour[0];

  logic unused_accumulate;
  assign unused_accumulate = ^{ready, valid, accumulate};
endmodule

`default_nettype wire
