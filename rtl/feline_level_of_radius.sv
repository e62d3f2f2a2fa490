// SPDX-License-Identifier: Apache-2.0
// log2(radius * 2^exponent) in texels, saturated (level_of_radius of model/plan.h).
//
// Takes  radius U8.7 texel * 2^exponent; exponent S6.0.
// Gives  the level of detail before its bias, S5.8.
// Rounds the radius: nearest, ties up, to 9 significant bits; log2 of it: to nearest.
// Edges  Saturates at -32 and 31.996; radius 0 gives -32.
// Source WRL 99/1, 3.1.
`default_nettype none

module feline_level_of_radius (
  input  wire logic [feline_pkg::RadiusWidth-1:0]          radius_i,
  input  wire logic signed [feline_pkg::ExponentWidth-1:0] exponent_i,
  output logic signed [feline_pkg::LevelOfDetailWidth-1:0] level_o
);
  localparam int unsigned RadiusWidth   = feline_pkg::RadiusWidth;
  localparam int unsigned LevelWidth    = feline_pkg::LevelOfDetailWidth;
  localparam int unsigned FractionBits  = feline_pkg::LevelOfDetailFraction;
  localparam int unsigned LengthWidth   = $clog2(RadiusWidth + 1);
  localparam int unsigned IntegerWidth  = LevelWidth - FractionBits;
  localparam int unsigned WholeWidth    =
      (feline_pkg::ExponentWidth > IntegerWidth ? feline_pkg::ExponentWidth : IntegerWidth) + 1;
  // Room for the leading one, the fraction and at least one bit to round by.
  localparam int unsigned DroppedBits   = RadiusWidth > FractionBits + 2 ? RadiusWidth - FractionBits - 1 : 1;
  localparam int unsigned AlignedWidth  = FractionBits + 1 + DroppedBits;
  localparam int unsigned ShiftWidth    = $clog2(AlignedWidth + 1);
  localparam logic signed [WholeWidth-1:0] MaxWhole = (WholeWidth'(1) << (IntegerWidth - 1)) - WholeWidth'(1);
  localparam logic signed [WholeWidth-1:0] MinWhole = ~MaxWhole;

  logic [LengthWidth-1:0]       length;
  logic [AlignedWidth-1:0]      aligned;
  logic [FractionBits+1:0]      normalized;
  logic                         carries;
  logic signed [WholeWidth-1:0] whole;
  logic [FractionBits-1:0]      fraction;

  feline_bit_length #(.Width(RadiusWidth)) u_bit_length (.value_i(radius_i), .length_o(length));

  // 1.x, its leading one at the top, then to FractionBits; rounding can carry into 2.
  assign aligned    = AlignedWidth'(radius_i) << (ShiftWidth'(AlignedWidth) - ShiftWidth'(length));
  assign normalized = (FractionBits + 2)'(aligned[AlignedWidth-1:DroppedBits]) +
                      (FractionBits + 2)'(aligned[DroppedBits-1]);
  assign carries    = normalized[FractionBits+1];

  feline_rom_log2 u_rom_log2 (.index_i(normalized[FractionBits-1:0]), .data_o(fraction));

  // The leading one's place is length - 1.
  assign whole = WholeWidth'(exponent_i) + $signed(WholeWidth'(length)) + $signed(WholeWidth'(carries)) -
                 $signed(WholeWidth'(feline_pkg::RadiusFraction + 1));

  always_comb begin
    if (radius_i == '0 || whole < MinWhole) begin
      level_o = {1'b1, {(LevelWidth-1){1'b0}}};
    end else if (whole > MaxWhole) begin
      level_o = {1'b0, {(LevelWidth-1){1'b1}}};
    end else begin
      level_o = {whole[IntegerWidth-1:0], fraction};
    end
  end

  logic unused_bits;
  assign unused_bits = ^{aligned, normalized};
endmodule

`default_nettype wire
