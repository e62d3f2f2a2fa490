// SPDX-License-Identifier: Apache-2.0
// The sum of accumulate never overflows: of colours of at most 255 it is at most 255 times the weights so far, and
// while it grows it never falls. Registers are wires here: what the output shows of the sum is that of every probe.
`default_nettype none

module feline_proof_sum_bound (
  input  wire logic                clk_i,
  input  wire logic                rst_i,
  input  wire logic                valid_i,
  input  wire feline_pkg::filter_t beat_i,
  output logic                     broken_o
);
  localparam int unsigned                        White     = 255;
  localparam logic [feline_pkg::FilteredWidth-1:0] WhiteColour =
      feline_pkg::FilteredWidth'(White) << (feline_pkg::FilteredWidth - 8);
  localparam int unsigned                        SumWidth  = feline_pkg::WeightBits + 2;
  localparam logic [SumWidth-1:0]                One       = SumWidth'(1) << feline_pkg::WeightBits;

  feline_pkg::filter_t     filter;
  feline_pkg::accumulate_t accumulate;
  logic                    ready;
  logic                    valid;
  logic                    rst;
  logic                    begun_q;
  logic [SumWidth-1:0]     weights_q;
  logic [SumWidth-1:0]     weights;
  logic [feline_pkg::PixelWidth-1:0] pixel_q;
  logic                    takes;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    filter       = beat_i;
    filter.first = !begun_q;
    if (beat_i.colour[0] > WhiteColour) filter.colour[0] = WhiteColour;
    if (!takes) filter.weight = '0;
  end

  assign takes   = valid_i && (begun_q ? weights_q : '0) + SumWidth'(beat_i.weight) <= One;
  assign weights = (begun_q ? weights_q : '0) + SumWidth'(filter.weight);

  feline_accumulate u_accumulate (
    .clk_i, .rst_i(rst), .filter_valid_i(takes), .filter_ready_o(ready), .filter_i(filter),
    .accumulate_valid_o(valid), .accumulate_ready_i(1'b1), .accumulate_o(accumulate)
  );

  always_ff @(posedge clk_i) begin
    if (rst) begin
      begun_q <= 1'b0;
    end else if (takes) begin
      begun_q   <= !filter.last;
      weights_q <= weights;
      pixel_q   <= accumulate.colour[0];
    end
  end

  // A pixel is 255 times 2^PixelFraction at most, a weight 2^WeightBits. What waits stays as it is.
  assign broken_o = !rst && (32'(accumulate.colour[0]) > White * 32'(weights) || weights > One ||
      (begun_q && (takes ? accumulate.colour[0] < pixel_q : accumulate.colour[0] != pixel_q)));
endmodule

`default_nettype wire
