// SPDX-License-Identifier: Apache-2.0
// A pixel of accumulate is the sum of its probes, each channel by itself: colour times weight, from half of the pixel's
// last bit on. Registers are wires here.
`default_nettype none

module feline_proof_sum (
  input  wire logic                clk_i,
  input  wire logic                rst_i,
  input  wire logic                valid_i,
  input  wire feline_pkg::filter_t beat_i,
  output logic                     broken_o
);
  localparam int unsigned SumWidth = feline_pkg::AccumulatedWidth;
  localparam int unsigned Dropped  = feline_pkg::AccumulatedFraction - feline_pkg::PixelFraction;

  feline_pkg::filter_t     filter;
  feline_pkg::accumulate_t accumulate;
  logic                    ready;
  logic                    valid;
  logic                    rst;
  logic                    begun_q;
  logic [3:0]              broken;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    filter       = beat_i;
    filter.first = !begun_q;
  end

  feline_accumulate u_accumulate (
    .clk_i, .rst_i(rst), .filter_valid_i(valid_i), .filter_ready_o(ready), .filter_i(filter),
    .accumulate_valid_o(valid), .accumulate_ready_i(1'b1), .accumulate_o(accumulate)
  );

  always_ff @(posedge clk_i) begin
    if (rst) begin
      begun_q <= 1'b0;
    end else if (valid_i) begin
      begun_q <= !filter.last;
    end
  end

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    logic [SumWidth-1:0] sum_q;
    logic [SumWidth-1:0] sum;

    assign sum = (begun_q ? sum_q : SumWidth'(1) << (Dropped - 1)) +
                 SumWidth'(filter.colour[c]) * SumWidth'(filter.weight);

    always_ff @(posedge clk_i) begin
      if (valid_i) sum_q <= sum;
    end

    assign broken[c] = accumulate.colour[c] != feline_pkg::PixelWidth'(sum >> Dropped);
  end

  assign broken_o = !rst && (!ready || valid != (valid_i && filter.last) || (valid && broken != '0));
endmodule

`default_nettype wire
