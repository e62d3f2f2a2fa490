// SPDX-License-Identifier: Apache-2.0
// A float32 texture coordinate to fixed point (to_position of model/group.h).
//
// Takes  s or t, float32, normalized (1 = the texture's size); its wrap mode.
// Gives  the coordinate S20.24 textures; whether it was finite; whether a clamp saturates it, though it was; whether it
//        saturates earlier than the full unit's would.
// Rounds nearest, ties away from zero.
// Edges  Denormals are 0. |s| >= 2^19: the clamps saturate at 2^19, the repeats keep the value modulo 2^21. NaN is 0;
//        infinity is +-2^19 (clamps) or 0 (repeats).
// Source CS248A lecture 4, step 2.
`default_nettype none

module feline_float_to_position #(
  parameter int unsigned ExponentBits = 8  // of IEEE 754 binary32
) (
  input  wire logic [feline_pkg::Float32Width-1:0]    bits_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]       wrap_i,
  output logic signed [feline_pkg::PositionWidth-1:0] position_o,
  output logic                                        finite_o,
  output logic                                        overflow_o,
  output logic                                        early_o
);
  localparam int unsigned SignificandWidth = feline_pkg::Float32Width - ExponentBits;
  localparam int unsigned FractionBits     = SignificandWidth - 1;
  localparam int unsigned Bias             = (1 << (ExponentBits - 1)) - 1;
  // The exponent at which the significand's unit is the position's last bit.
  localparam logic [ExponentBits-1:0] UnitExponent = ExponentBits'(Bias + FractionBits - feline_pkg::PositionFraction);
  localparam logic [ExponentBits-1:0] SaturationExponent = ExponentBits'(Bias + feline_pkg::SaturationLog2);
  // The full unit's, if a smaller one saturates earlier.
  localparam int unsigned FullSaturationLog2 =
      feline_pkg::SaturationLog2 > feline_pkg::FullRangeLog2 ? feline_pkg::SaturationLog2 : feline_pkg::FullRangeLog2;
  localparam logic [ExponentBits-1:0] FullExponent = ExponentBits'(Bias + FullSaturationLog2);
  localparam logic [feline_pkg::PositionWidth-1:0] Limit =
      feline_pkg::PositionWidth'(1) << (feline_pkg::SaturationLog2 + feline_pkg::PositionFraction);

  logic                                 negative;
  logic [ExponentBits-1:0]              exponent;
  logic [FractionBits-1:0]              fraction;
  logic [SignificandWidth-1:0]          significand;
  logic                                 clamps;
  logic                                 is_nan;
  logic                                 saturates;
  logic                                 beyond_full;
  logic [ExponentBits-1:0]              left;
  logic [ExponentBits-1:0]              right_less_one;
  logic [SignificandWidth-1:0]          halves;
  logic [SignificandWidth-1:0]          rounded;
  logic [feline_pkg::PositionWidth-1:0] magnitude;

  assign negative    = bits_i[feline_pkg::Float32Width-1];
  assign exponent    = bits_i[FractionBits +: ExponentBits];
  assign fraction    = bits_i[FractionBits-1:0];
  assign significand = {1'b1, fraction};
  assign finite_o    = exponent != {ExponentBits{1'b1}};
  assign is_nan      = !finite_o && fraction != '0;
  assign clamps      = wrap_i == feline_pkg::WrapClampToEdge || wrap_i == feline_pkg::WrapClampToBorder;
  assign saturates   = clamps && exponent >= SaturationExponent;
  assign beyond_full = clamps && exponent >= FullExponent;
  assign overflow_o  = beyond_full && finite_o;
  assign early_o     = saturates && !beyond_full;

  // Below UnitExponent the significand loses bits, all but the last in one shift; above, it gains zeros, and what
  // leaves the width, an infinity with it, is a multiple of 2^21.
  assign left           = exponent - UnitExponent;
  assign right_less_one = ~left;
  assign halves         = significand >> right_less_one;
  assign rounded        = (halves >> 1) + SignificandWidth'(halves[0]);

  always_comb begin
    if (exponent == '0 || is_nan) begin
      magnitude = '0;
    end else if (saturates) begin
      magnitude = Limit;
    end else if (exponent < UnitExponent) begin
      magnitude = feline_pkg::PositionWidth'(rounded);
    end else begin
      magnitude = feline_pkg::PositionWidth'(significand) << left;
    end
  end

  // Few bits of position cut what lies above them.
  logic unused_rounded;
  assign unused_rounded = ^rounded;

  assign position_o = negative ? -magnitude : magnitude;
endmodule

`default_nettype wire
