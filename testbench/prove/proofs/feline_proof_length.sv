// SPDX-License-Identifier: Apache-2.0
// feline_length, a bit wider than mantissas are, is the greatest of four sums of shifts: each part with either side as a.
`default_nettype none

module feline_proof_length (
  input  wire logic signed [feline_pkg::MantissaWidth:0] u_i,
  input  wire logic signed [feline_pkg::MantissaWidth:0] v_i,
  output logic                                           broken_o
);
  localparam int unsigned Width       = feline_pkg::MantissaWidth + 1;
  localparam int unsigned LengthWidth = Width + feline_pkg::RadiusFraction;

  logic [LengthWidth-1:0] length;
  logic [LengthWidth-1:0] u;
  logic [LengthWidth-1:0] v;
  logic [LengthWidth-1:0] flat_u;
  logic [LengthWidth-1:0] flat_v;
  logic [LengthWidth-1:0] steep_u;
  logic [LengthWidth-1:0] steep_v;
  logic [LengthWidth-1:0] flat;
  logic [LengthWidth-1:0] steep;

  feline_length #(.Width(Width), .LengthWidth(LengthWidth)) u_length (.u_i, .v_i, .length_o(length));

  assign u = LengthWidth'((u_i ^ {Width{u_i[Width-1]}}) + Width'(u_i[Width-1]));
  assign v = LengthWidth'((v_i ^ {Width{v_i[Width-1]}}) + Width'(v_i[Width-1]));
  // 128 and 20, 109 = 128 - 16 - 2 - 1 and 70 = 64 + 4 + 2; the larger side makes the larger sum.
  assign flat_u  = (u << 7) + (v << 4) + (v << 2);
  assign flat_v  = (v << 7) + (u << 4) + (u << 2);
  assign steep_u = (u << 7) - (u << 4) - (u << 1) - u + (v << 6) + (v << 2) + (v << 1);
  assign steep_v = (v << 7) - (v << 4) - (v << 1) - v + (u << 6) + (u << 2) + (u << 1);
  assign flat    = flat_u > flat_v ? flat_u : flat_v;
  assign steep   = steep_u > steep_v ? steep_u : steep_v;

  assign broken_o = length != (flat > steep ? flat : steep);
endmodule

`default_nettype wire
