// SPDX-License-Identifier: Apache-2.0
// The two-part linear length of a vector (vector_length of model/footprint.h).
//
// Takes  u, v, signed integers.
// Gives  the length in units of 1/128: max(a + 5b/32, 109a/128 + 35b/64), a = max(|u|, |v|), b = min(|u|, |v|).
// Rounds nothing.
// Edges  (0, 0) has length 0. The extremes of the error are +1.213 % and -1.116 %.
// Source WRL 99/1, 3.2; the larger part is taken instead of choosing by b < 3a/8.
`default_nettype none

module feline_length #(
  parameter int unsigned Width       = feline_pkg::MantissaWidth,
  parameter int unsigned LengthWidth = Width + feline_pkg::RadiusFraction
) (
  input  wire logic signed [Width-1:0] u_i,
  input  wire logic signed [Width-1:0] v_i,
  output logic [LengthWidth-1:0]       length_o
);
  // The parts' coefficients of a and b, times 128.
  localparam logic [LengthWidth-1:0] FlatA  = LengthWidth'(128);
  localparam logic [LengthWidth-1:0] FlatB  = LengthWidth'(20);
  localparam logic [LengthWidth-1:0] SteepA = LengthWidth'(109);
  localparam logic [LengthWidth-1:0] SteepB = LengthWidth'(70);

  logic [Width-1:0]       size_u;
  logic [Width-1:0]       size_v;
  logic                   u_is_larger;
  logic [LengthWidth-1:0] a;
  logic [LengthWidth-1:0] b;
  logic [LengthWidth-1:0] flat;
  logic [LengthWidth-1:0] steep;

  assign size_u      = u_i[Width-1] ? -u_i : u_i;
  assign size_v      = v_i[Width-1] ? -v_i : v_i;
  assign u_is_larger = size_u > size_v;
  assign a           = u_is_larger ? LengthWidth'(size_u) : LengthWidth'(size_v);
  assign b           = u_is_larger ? LengthWidth'(size_v) : LengthWidth'(size_u);
  assign flat        = FlatA * a + FlatB * b;
  assign steep       = SteepA * a + SteepB * b;
  assign length_o    = flat > steep ? flat : steep;
endmodule

`default_nettype wire
