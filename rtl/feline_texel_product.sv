// SPDX-License-Identifier: Apache-2.0
// A float32 derivative to texels of level 0: significand times size, exact, and where its leading one stands.
//
// Takes  ds/dx, dt/dx, ds/dy or dt/dy, float32, normalized (1 = the texture's size); the texture's width or height.
// Gives  |derivative| in texels = product * 2^(exponent - 150), exponent biased; top, the place of the leading one:
//        2^(top - 151) <= |derivative| < 2^(top - 150); whether the derivative was finite.
//        Where all sizes are powers of two, the exponent holds the size and the product is the significand.
// Rounds nothing.
// Edges  Denormals are 0: product 0, top 0. Product and top mean nothing when the derivative is not finite. A derivative
//        that the configuration has no place for is 0, and missing if it was not.
// Source WRL 99/1, 3.2 (group scaling); CS248A lecture 4, step 4.
`default_nettype none

module feline_texel_product #(
  parameter bit          HasPlace     = 1'b1,
  parameter int unsigned ExponentBits = 8,  // of IEEE 754 binary32
  parameter int unsigned ProductWidth = feline_pkg::Float32Width - ExponentBits + feline_pkg::SizeWidth
) (
  input  wire logic [feline_pkg::Float32Width-1:0] bits_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]    size_i,
  output logic                                     finite_o,
  output logic                                     missing_o,
  output logic                                     negative_o,
  output logic [ExponentBits:0]                    exponent_o,
  output logic [ProductWidth-1:0]                  product_o,
  output logic [ExponentBits:0]                    top_o
);
  localparam int unsigned SignificandWidth = feline_pkg::Float32Width - ExponentBits;
  localparam int unsigned FractionBits     = SignificandWidth - 1;
  localparam int unsigned TopWidth         = ExponentBits + 1;
  localparam int unsigned LengthWidth      = $clog2(ProductWidth + 1);

  logic [ExponentBits-1:0] biased;

  assign biased    = bits_i[FractionBits +: ExponentBits];
  assign finite_o  = biased != {ExponentBits{1'b1}};
  assign missing_o = !HasPlace && biased != '0;

  if (HasPlace) begin : gen_place
    logic [SignificandWidth-1:0] significand;
    logic [LengthWidth-1:0]      length;

    assign negative_o  = bits_i[feline_pkg::Float32Width-1];
    assign significand = biased == '0 ? '0 : {1'b1, bits_i[FractionBits-1:0]};

    if (feline_pkg::FeatureAnySize) begin : gen_any_size
      assign exponent_o = TopWidth'(biased);
      assign product_o  = ProductWidth'(significand) * ProductWidth'(size_i);
    end else begin : gen_power_of_two
      logic [feline_pkg::SizeShiftWidth-1:0] log2;

      feline_one_hot_log2 #(.Width(feline_pkg::SizeWidth), .Log2Width(feline_pkg::SizeShiftWidth)) u_log2 (
        .value_i(size_i), .log2_o(log2)
      );

      assign exponent_o = biased == '0 ? '0 : TopWidth'(biased) + TopWidth'(log2);
      assign product_o  = ProductWidth'(significand);
    end

    feline_bit_length #(.Width(ProductWidth)) u_bit_length (.value_i(product_o), .length_o(length));

    assign top_o = exponent_o + TopWidth'(length);
  end else begin : gen_no_place
    assign negative_o = 1'b0;
    assign exponent_o = '0;
    assign product_o  = '0;
    assign top_o      = '0;

    logic unused_inputs;
    assign unused_inputs = ^{bits_i, size_i};
  end
endmodule

`default_nettype wire
