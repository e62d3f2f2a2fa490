// SPDX-License-Identifier: Apache-2.0
// The ellipse of two vectors from a word of the ellipse table (table_footprint of model/footprint.h).
//
// Takes  the longer vector S7.0 and its length U8.7; the word's index; whether the vector turns, and which way.
// Gives  major_u, major_v S8.8 and major_radius, minor_radius U8.7.
// Rounds major_u, major_v are exact; both radii nearest, ties up.
// Edges  A vector that does not turn keeps its direction.
// Source WRL 99/1, 3.3, its rotation corrected: a counter-clockwise turn by 90 degrees takes (u, v) to (-v, u).
`default_nettype none

module feline_table_footprint #(
  parameter int unsigned IndexWidth = $clog2(feline_pkg::TableRows * feline_pkg::TableColumns)
) (
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] longer_u_i,
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] longer_v_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          longer_length_i,
  input  wire logic [IndexWidth-1:0]                       index_i,
  input  wire logic                                        turns_i,
  input  wire logic                                        counter_clockwise_i,
  output logic                                             present_o,
  output logic signed [feline_pkg::VectorWidth-1:0]        major_u_o,
  output logic signed [feline_pkg::VectorWidth-1:0]        major_v_o,
  output logic [feline_pkg::RadiusWidth-1:0]               major_radius_o,
  output logic [feline_pkg::RadiusWidth-1:0]               minor_radius_o
);
  localparam int unsigned VectorWidth   = feline_pkg::VectorWidth;
  localparam int unsigned RadiusWidth   = feline_pkg::RadiusWidth;
  localparam int unsigned ScaleWidth    = feline_pkg::TableScaleWidth;
  localparam int unsigned FractionWidth = feline_pkg::TableFractionWidth;
  localparam int unsigned ScaleBits     = feline_pkg::TableScaleFraction;
  localparam int unsigned FractionBits  = feline_pkg::TableFractionFraction;
  localparam int unsigned MajorWidth    = RadiusWidth + ScaleWidth;
  localparam int unsigned MinorWidth    = RadiusWidth + FractionWidth;

  logic [ScaleWidth-1:0]         uv_scale;
  logic [FractionWidth-1:0]      uv_scale_90;
  logic [FractionWidth-1:0]      minor_radius;
  logic [ScaleWidth-1:0]         major_radius;
  logic signed [FractionWidth:0] turned;
  logic signed [VectorWidth-1:0] doubled;
  logic [MajorWidth-1:0]         major;
  logic [MinorWidth-1:0]         minor;

  feline_rom_ellipse u_rom_ellipse (
    .index_i(index_i), .present_o,
    .data_o ({uv_scale, uv_scale_90, minor_radius, major_radius})
  );

  always_comb begin
    if (!turns_i) begin
      turned = '0;
    end else if (counter_clockwise_i) begin
      turned = $signed({1'b0, uv_scale_90});
    end else begin
      turned = -$signed({1'b0, uv_scale_90});
    end
  end

  // uv_scale has one fraction bit less than the vector.
  assign doubled   = $signed(VectorWidth'({uv_scale, 1'b0}));
  assign major_u_o = VectorWidth'(longer_u_i) * doubled - VectorWidth'(longer_v_i) * VectorWidth'(turned);
  assign major_v_o = VectorWidth'(longer_v_i) * doubled + VectorWidth'(longer_u_i) * VectorWidth'(turned);

  assign major = MajorWidth'(longer_length_i) * MajorWidth'(major_radius) + (MajorWidth'(1) << (ScaleBits - 1));
  assign minor = MinorWidth'(longer_length_i) * MinorWidth'(minor_radius) + (MinorWidth'(1) << (FractionBits - 1));
  assign major_radius_o = major[ScaleBits +: RadiusWidth];
  assign minor_radius_o = minor[FractionBits +: RadiusWidth];

  logic unused_bits;
  assign unused_bits = ^{major[MajorWidth-1:ScaleBits+RadiusWidth], major[ScaleBits-1:0], minor[FractionBits-1:0]};
endmodule

`default_nettype wire
