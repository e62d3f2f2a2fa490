// SPDX-License-Identifier: Apache-2.0
// No mantissa of group is -128: whatever the products, their exponents and the largest top that follows from both.
`default_nettype none

module feline_proof_mantissas (
  input  wire logic         nearest_i,
  input  wire logic [3:0]   negative_i,
  input  wire logic [31:0]  biased_i,
  input  wire logic [155:0] product_i,
  output logic              broken_o
);
  localparam int unsigned MantissaWidth = feline_pkg::MantissaWidth;
  localparam int unsigned ProductWidth  = feline_pkg::Float32Width - 8 + feline_pkg::SizeWidth;
  localparam int unsigned LengthWidth   = $clog2(ProductWidth + 1);

  logic signed [feline_pkg::ExponentWidth-1:0] exponent;
  logic [4*MantissaWidth-1:0]                  mantissa;
  logic [35:0]                                 exponents;
  logic [35:0]                                 tops;
  logic [8:0]                                  top;
  logic                                        overflow;
  logic                                        unsupported;
  logic [3:0]                                  broken;

  for (genvar i = 0; i < 4; i++) begin : gen_lane
    logic [LengthWidth-1:0] length;

    feline_bit_length #(.Width(ProductWidth)) u_bit_length (
      .value_i(product_i[i*ProductWidth +: ProductWidth]), .length_o(length)
    );

    assign exponents[i*9 +: 9] = 9'(biased_i[i*8 +: 8]);
    assign tops[i*9 +: 9]      = exponents[i*9 +: 9] + 9'(length);
    assign broken[i]           = mantissa[i*MantissaWidth +: MantissaWidth] == {1'b1, {(MantissaWidth-1){1'b0}}};
  end

  always_comb begin
    top = '0;
    for (int i = 0; i < 4; i++) begin
      if (tops[i*9 +: 9] > top) top = tops[i*9 +: 9];
    end
  end

  feline_group_mantissas u_group_mantissas (
    .nearest_i, .finite_i(1'b1), .top_i(top), .negative_i, .exponent_i(exponents), .product_i,
    .exponent_o(exponent), .mantissa_o(mantissa), .overflow_o(overflow), .unsupported_o(unsupported)
  );

  assign broken_o = broken != '0;
endmodule

`default_nettype wire
