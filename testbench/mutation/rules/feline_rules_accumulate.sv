// SPDX-License-Identifier: Apache-2.0
// What reaches accumulate: a beat stays until it is taken; a pixel's probes from first to last, of weights that sum to
// one, of several none above a half (tests weight_rows_sum_to_one, no_probe_of_several_weighs_more_than_a_half; leaf
// walk.probe_weight); colours of at most 255 (leaf filter.texels); nothing unsupported in the full configuration.
`default_nettype none

module feline_rules_accumulate (
  input  wire logic                clk_i,
  input  wire logic                rst_i,
  input  wire logic                filter_valid_i,
  input  wire logic                filter_ready_o,
  input  wire feline_pkg::filter_t filter_i,
  output logic                     legal_o
);
  localparam int unsigned                       White = 255;
  localparam logic [feline_pkg::WeightBits+1:0] One   = 1 << feline_pkg::WeightBits;
  localparam logic [feline_pkg::WeightBits+1:0] Half  = One >> 1;

  logic                               held_q;
  logic                               begun_q;
  feline_pkg::filter_t                filter_q;
  logic [feline_pkg::WeightBits+1:0]  sum_q;
  logic [feline_pkg::WeightBits+1:0]  sum;
  logic [3:0]                         channel_legal;

  assign sum = (begun_q ? sum_q : '0) + (feline_pkg::WeightBits + 2)'(filter_i.weight);

  always_ff @(posedge clk_i) begin
    held_q   <= !rst_i && filter_valid_i && !filter_ready_o;
    filter_q <= filter_i;
    if (rst_i) begin
      begun_q <= 1'b0;
    end else if (filter_valid_i && filter_ready_o) begin
      begun_q <= !filter_i.last;
      sum_q   <= sum;
    end
  end

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    assign channel_legal[c] = 64'(filter_i.colour[c]) <= (64'(White) << (feline_pkg::AccumulatedFraction - feline_pkg::WeightBits));
  end

  assign legal_o = (!held_q || (filter_valid_i && filter_i == filter_q)) &&
                   (!filter_valid_i || (channel_legal == '1 && filter_i.first == !begun_q && sum <= One &&
                                        (!filter_i.last || sum == One) &&
                                        ((filter_i.first && filter_i.last) ||
                                         (feline_pkg::WeightBits + 2)'(filter_i.weight) <= Half) &&
                                        !filter_i.status[feline_pkg::StatusUnsupported]));
endmodule

`default_nettype wire
