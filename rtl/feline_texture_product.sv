// SPDX-License-Identifier: Apache-2.0
// A vector's component from texels to the texture (to_half_step of model/plan.h), exact but for its scale.
//
// Takes  vector S8.8 texel * 2^exponent; reciprocal U1.15, the mantissa of 1/width or 1/height.
// Gives  their product, S9.23 texture * 2^(exponent - size_shift).
// Rounds nothing.
// Edges  where all sizes are powers of two, the mantissa is 1.
// Source WRL 99/1, 3.1.
`default_nettype none

module feline_texture_product (
  input  wire logic signed [feline_pkg::VectorWidth-1:0]                           vector_i,
  input  wire logic [feline_pkg::SizeReciprocalWidth-1:0]                          reciprocal_i,
  output logic signed [feline_pkg::VectorWidth+feline_pkg::SizeReciprocalWidth-1:0] product_o
);
  localparam int unsigned ProductWidth = feline_pkg::VectorWidth + feline_pkg::SizeReciprocalWidth;

  if (feline_pkg::FeatureAnySize) begin : gen_any_size
    assign product_o = ProductWidth'(vector_i) * $signed(ProductWidth'(reciprocal_i));
  end else begin : gen_power_of_two
    assign product_o = ProductWidth'(vector_i) <<< feline_pkg::SizeReciprocalFraction;

    logic unused_reciprocal;
    assign unused_reciprocal = ^reciprocal_i;
  end
endmodule

`default_nettype wire
