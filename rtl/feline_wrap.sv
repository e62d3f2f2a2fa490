// SPDX-License-Identifier: Apache-2.0
// A position into the range that its wrap mode leaves.
//
// Takes  position S20.24 textures; the wrap code, one that the configuration supports (feline_supported_wrap).
// Gives  wrapped S1.24 textures: 0 .. 1, clamp to border -1 .. 2 - 2^-24.
// Rounds nothing.
// Edges  repeat: modulo 1. mirrored repeat: modulo 2, then 2 - x from 1 on, so that 1 itself is reached. Clamps
//        saturate.
// Source OpenGL 4.6, 8.14.2 (wrap modes).
`default_nettype none

module feline_wrap (
  input  wire logic signed [feline_pkg::PositionWidth-1:0]      position_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]                 wrap_i,
  output logic signed [feline_pkg::PositionFraction+1:0]        wrapped_o
);
  localparam int unsigned Fraction     = feline_pkg::PositionFraction;
  localparam int unsigned WrappedWidth = Fraction + 2;
  localparam int unsigned WholeWidth   = feline_pkg::PositionWidth - Fraction;
  localparam logic [WrappedWidth-1:0] One      = {2'b01, {Fraction{1'b0}}};
  localparam logic [WrappedWidth-1:0] MinusOne = {2'b11, {Fraction{1'b0}}};
  localparam logic [WrappedWidth-1:0] BelowTwo = {2'b01, {Fraction{1'b1}}};

  logic signed [WholeWidth-1:0] whole;
  logic [WrappedWidth-1:0]      repeated;
  logic [WrappedWidth-1:0]      mirrored;
  logic [WrappedWidth-1:0]      to_edge;
  logic [WrappedWidth-1:0]      to_border;

  assign whole    = position_i[feline_pkg::PositionWidth-1:Fraction];
  assign repeated = {2'b00, position_i[Fraction-1:0]};
  assign to_edge  = whole < 0 ? '0 : whole > 0 ? One : repeated;

  // From 1 to 2, 2 - x is 1 less the fraction of x.
  if (feline_pkg::FeatureMirroredRepeat) begin : gen_mirrored
    assign mirrored = position_i[Fraction] ? One - repeated : repeated;
  end else begin : gen_no_mirrored
    assign mirrored = repeated;
  end

  if (feline_pkg::FeatureClampToBorder) begin : gen_to_border
    assign to_border = whole < -1 ? MinusOne : whole > 1 ? BelowTwo : position_i[WrappedWidth-1:0];
  end else begin : gen_no_to_border
    assign to_border = to_edge;
  end

  always_comb begin
    unique case (wrap_i)
      feline_pkg::WrapRepeat:         wrapped_o = repeated;
      feline_pkg::WrapMirroredRepeat: wrapped_o = mirrored;
      feline_pkg::WrapClampToEdge:    wrapped_o = to_edge;
      feline_pkg::WrapClampToBorder:  wrapped_o = to_border;
    endcase
  end
endmodule

`default_nettype wire
