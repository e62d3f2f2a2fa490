// SPDX-License-Identifier: Apache-2.0
// Half the distance of two probes along one axis (testbench/prove/leaves.h, HalfStep).
`default_nettype none

module feline_leaf_half_step #(
  localparam int unsigned InputWidth = (feline_pkg::VectorWidth + feline_pkg::SizeReciprocalWidth) +
      feline_pkg::ReciprocalWidth + feline_pkg::SizeShiftWidth + feline_pkg::ExponentWidth,
  localparam int unsigned OutputWidth = feline_pkg::HalfStepWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  localparam int unsigned ProductWidth = feline_pkg::VectorWidth + feline_pkg::SizeReciprocalWidth;

  logic signed [ProductWidth-1:0]              product;
  logic [feline_pkg::ReciprocalWidth-1:0]      factor;
  logic [feline_pkg::SizeShiftWidth-1:0]       size_shift;
  logic signed [feline_pkg::ExponentWidth-1:0] exponent;
  logic [feline_pkg::HalfStepWidth-1:0]        half_step;

  assign {product, factor, size_shift, exponent} = inputs_i;
  assign outputs_o = {half_step};

  feline_half_step #(.ProductWidth(ProductWidth)) u_half_step (
    .product_i(product), .factor_i(factor), .size_shift_i(size_shift), .exponent_i(exponent), .half_step_o(half_step)
  );
endmodule

`default_nettype wire
