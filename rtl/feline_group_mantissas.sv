// SPDX-License-Identifier: Apache-2.0
// Four products to four mantissas under one group exponent: the second half of model/group.h.
//
// Takes  of ds/dx, dt/dx, ds/dy, dt/dy, the first lowest: sign and |derivative| in texels = product * 2^(exponent -
//        150) (feline_texel_product); the largest top of the four; whether all four were finite; which rounding.
// Gives  dudx, dvdx, dudy, dvdy, the first lowest, S7.0 in texels of level 0 * 2^exponent; exponent S6.0; whether it
//        saturates, though all four were finite; unsupported: a narrower exponent or a missing place is to blame.
// Rounds nearest, ties away from zero, or outward (away from zero); the exponent is the least with which no rounded
//        magnitude exceeds 127; the largest is then 64 .. 127.
// Edges  Not finite: the unbounded footprint (127, 0), (0, 127), exponent 63. exponent > 63 saturates; exponent < -64,
//        which four zeros have too, gives zeros at -64. -128 never occurs.
// Source WRL 99/1, 3.2 (group scaling).
`default_nettype none

module feline_group_mantissas #(
  parameter int unsigned ExponentBits = 8,  // of IEEE 754 binary32
  parameter int unsigned ProductWidth = feline_pkg::Float32Width - ExponentBits + feline_pkg::SizeWidth
) (
  input  wire logic                                   nearest_i,
  input  wire logic                                   finite_i,
  input  wire logic [ExponentBits:0]                  top_i,
  input  wire logic [3:0]                             negative_i,
  input  wire logic [4*ExponentBits+3:0]              exponent_i,
  input  wire logic [4*ProductWidth-1:0]              product_i,
  output logic signed [feline_pkg::ExponentWidth-1:0] exponent_o,
  output logic [4*feline_pkg::MantissaWidth-1:0]      mantissa_o,
  output logic                                        overflow_o,
  output logic                                        unsupported_o
);
  localparam int unsigned MantissaWidth = feline_pkg::MantissaWidth;
  localparam int unsigned MagnitudeBits = MantissaWidth - 1;
  localparam int unsigned TopWidth      = ExponentBits + 1;
  localparam int unsigned SumWidth      = TopWidth + 1;
  // What a biased exponent has more than the exponent of the significand's unit: bias and fraction bits.
  localparam int unsigned UnitExponent = (1 << (ExponentBits - 1)) - 1 + feline_pkg::Float32Width - ExponentBits - 1;
  localparam logic signed [SumWidth-1:0] MaxExponent = (SumWidth'(1) << (feline_pkg::ExponentWidth - 1)) - SumWidth'(1);
  localparam logic signed [SumWidth-1:0] MinExponent = ~MaxExponent;
  // A configuration may have a narrower exponent than a footprint needs.
  localparam logic signed [SumWidth-1:0] FullMaxExponent =
      (SumWidth'(1) << feline_pkg::FullExponentBits) - SumWidth'(1);
  localparam logic signed [SumWidth-1:0] FullMinExponent = ~FullMaxExponent;
  localparam bit                         IsNarrow        = MaxExponent < FullMaxExponent;
  localparam logic [MantissaWidth-1:0]   MaxMantissa = {1'b0, {MagnitudeBits{1'b1}}};

  logic [3:0]                 too_large;
  logic                       halved;
  logic                       vanishes;
  logic                       saturates;
  logic signed [SumWidth-1:0] exponent;

  // 2^MagnitudeBits can come out of rounding; then all four are rounded to a bit less.
  assign halved   = too_large != '0;
  assign exponent = SumWidth'(top_i) - SumWidth'(UnitExponent + MagnitudeBits) + SumWidth'(halved);
  assign vanishes = exponent < MinExponent;

  assign saturates = finite_i && exponent > MaxExponent;

  if (IsNarrow) begin : gen_narrow
    assign overflow_o    = finite_i && exponent > FullMaxExponent;
    assign unsupported_o = !finite_i || saturates || (vanishes && exponent >= FullMinExponent);
  end else begin : gen_full
    assign overflow_o    = saturates;
    assign unsupported_o = !finite_i && !(feline_pkg::FeatureDudx && feline_pkg::FeatureDvdy);
  end

  for (genvar i = 0; i < 4; i++) begin : gen_mantissa
    // Of the four values for an infinite footprint only the first and the last are not 0.
    localparam logic [MantissaWidth-1:0] Unbounded =
        (i == 0 && feline_pkg::FeatureDudx) || (i == 3 && feline_pkg::FeatureDvdy) ? MaxMantissa : '0;

    logic [TopWidth-1:0]      dropped;
    logic [MantissaWidth-1:0] rounded;
    logic [MantissaWidth-1:0] rounded_more;
    logic [MantissaWidth-1:0] magnitude;
    logic [MantissaWidth-1:0] mantissa;

    assign dropped = top_i - TopWidth'(MagnitudeBits) - exponent_i[i*TopWidth +: TopWidth];

    feline_round_magnitude #(
      .Width      (ProductWidth),
      .BitsWidth  (TopWidth),
      .ResultWidth(MantissaWidth)
    ) u_round_magnitude (
      .nearest_i,
      .value_i       (product_i[i*ProductWidth +: ProductWidth]),
      .bits_i        (dropped),
      .rounded_o     (rounded),
      .rounded_more_o(rounded_more)
    );

    assign too_large[i] = rounded[MagnitudeBits];
    assign magnitude    = halved ? rounded_more : rounded;

    always_comb begin
      if (!finite_i) begin
        mantissa = Unbounded;
      end else if (vanishes) begin
        mantissa = '0;
      end else begin
        mantissa = negative_i[i] ? -magnitude : magnitude;
      end
    end
    assign mantissa_o[i*MantissaWidth +: MantissaWidth] = mantissa;
  end

  always_comb begin
    if (!finite_i || saturates) begin
      exponent_o = MaxExponent[feline_pkg::ExponentWidth-1:0];
    end else if (vanishes) begin
      exponent_o = MinExponent[feline_pkg::ExponentWidth-1:0];
    end else begin
      exponent_o = exponent[feline_pkg::ExponentWidth-1:0];
    end
  end
endmodule

`default_nettype wire
