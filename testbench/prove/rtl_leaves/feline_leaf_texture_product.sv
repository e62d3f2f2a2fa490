// SPDX-License-Identifier: Apache-2.0
// A vector's component to the texture (testbench/prove/leaves.h, TextureProduct).
`default_nettype none

module feline_leaf_texture_product #(
  localparam int unsigned InputWidth = feline_pkg::SizeReciprocalWidth + feline_pkg::VectorWidth,
  localparam int unsigned OutputWidth = feline_pkg::SizeReciprocalWidth + feline_pkg::VectorWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::SizeReciprocalWidth-1:0] reciprocal;
  logic signed [feline_pkg::VectorWidth-1:0]  vector;

  assign {reciprocal, vector} = inputs_i;

  feline_texture_product u_texture_product (
    .vector_i(vector), .reciprocal_i(reciprocal), .product_o(outputs_o)
  );
endmodule

`default_nettype wire
