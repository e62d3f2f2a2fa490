// SPDX-License-Identifier: Apache-2.0
// Drops fraction bits of a magnitude (round_away_ties and round_outward of tables/rounding.h), and one bit more.
//
// Takes  a magnitude, how many of its bits to drop, any number being legal, and which rounding.
// Gives  the magnitude in units of 2^bits, and in units of 2^(bits + 1), each rounded from the magnitude itself; the
//        kept bits fit into ResultWidth - 1, the rounded ones into ResultWidth.
// Rounds nearest, ties up, or outward: up, unless every dropped bit is 0.
// Edges  Dropping every bit of a value other than 0 gives 1 outward; nearest, 0 beyond the highest bit.
`default_nettype none

module feline_round_magnitude #(
  parameter int unsigned Width = 2,
  parameter int unsigned BitsWidth = 2,
  parameter int unsigned ResultWidth = 2
) (
  input  wire logic                 nearest_i,
  input  wire logic [Width-1:0]     value_i,
  input  wire logic [BitsWidth-1:0] bits_i,
  output logic [ResultWidth-1:0]    rounded_o,
  output logic [ResultWidth-1:0]    rounded_more_o
);
  logic [Width-1:0]       dropped_mask;
  logic [Width:0]         halves;
  logic [ResultWidth-1:0] kept;
  logic                   inexact;
  logic                   half;
  logic                   half_more;
  logic                   up;
  logic                   up_more;

  assign dropped_mask = ~({Width{1'b1}} << bits_i);
  assign inexact      = (value_i & dropped_mask) != '0;
  // The lowest bit of the halves is the highest one that is dropped.
  assign halves       = {value_i, 1'b0} >> bits_i;
  assign kept         = ResultWidth'(halves >> 1);
  assign half         = halves[0];
  assign half_more    = kept[0];
  assign up           = nearest_i ? half : inexact;
  assign up_more      = half_more || (inexact && !nearest_i);

  assign rounded_o      = kept + ResultWidth'(up);
  assign rounded_more_o = (kept >> 1) + ResultWidth'(up_more);
endmodule

`default_nettype wire
