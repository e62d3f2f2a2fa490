// SPDX-License-Identifier: Apache-2.0
// feline_wrap by arithmetic on whole positions: remainders and comparisons instead of bits.
`default_nettype none

module feline_proof_wrap (
  input  wire logic signed [feline_pkg::PositionWidth-1:0] position_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]            wrap_i,
  output logic broken_o
);
  localparam int unsigned Width    = feline_pkg::PositionWidth;
  localparam int unsigned Fraction = feline_pkg::PositionFraction;
  localparam logic signed [Width-1:0] One = Width'(1) << Fraction;

  logic signed [Fraction+1:0] wrapped;
  logic signed [Width-1:0]    expected;
  logic signed [Width-1:0]    twice;

  feline_wrap u_wrap (.position_i, .wrap_i, .wrapped_o(wrapped));

  always_comb begin
    // The remainder by 2, of negative positions too.
    twice = position_i - ((position_i >>> (Fraction + 1)) <<< (Fraction + 1));
    unique case (wrap_i)
      feline_pkg::WrapRepeat:         expected = twice >= One ? twice - One : twice;
      feline_pkg::WrapMirroredRepeat: expected = twice >= One ? One + One - twice : twice;
      feline_pkg::WrapClampToEdge:    expected = position_i < 0 ? '0 : position_i > One ? One : position_i;
      feline_pkg::WrapClampToBorder:  expected = position_i < -One ? -One
                                                 : position_i >= One + One ? One + One - Width'(1) : position_i;
    endcase
  end

  assign broken_o = Width'(wrapped) != expected;
endmodule

`default_nettype wire
