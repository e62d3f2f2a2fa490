// SPDX-License-Identifier: Apache-2.0
// From a towards b: a * (2^F - f) + b * f.
//
// Takes  a, b of any unsigned format; fraction U0.F.
// Gives  their convex combination with F more fraction bits.
// Rounds nothing: a * 2^F + (b - a) * f is the same number, with one multiplier.
// Edges  fraction 0 gives a, exactly; b alone is never reached. Equal a and b come back.
// Source CS248A lecture 4, step 7.
`default_nettype none

module feline_interpolate #(
  parameter int unsigned ValueWidth    = 1,
  parameter int unsigned FractionWidth = 1
) (
  input  wire logic [ValueWidth-1:0]             a_i,
  input  wire logic [ValueWidth-1:0]             b_i,
  input  wire logic [FractionWidth-1:0]          fraction_i,
  output logic [ValueWidth+FractionWidth-1:0]    value_o
);
  localparam int unsigned ProductWidth = ValueWidth + FractionWidth + 1;

  logic signed [ValueWidth:0]     difference;
  logic signed [ProductWidth-1:0] product;

  always_comb begin
    difference = $signed({1'b0, b_i}) - $signed({1'b0, a_i});
    product    = difference * $signed({1'b0, fraction_i});
    value_o    = (ValueWidth + FractionWidth)'({1'b0, a_i, FractionWidth'(0)} + product);
  end
endmodule

`default_nettype wire
