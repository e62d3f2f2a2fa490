// SPDX-License-Identifier: Apache-2.0
// Drops fraction bits away from zero (round_outward of tables/rounding.h): the magnitude never gets smaller.
//
// Takes  a magnitude and how many of its bits to drop; any number is legal.
// Gives  the magnitude in units of 2^bits; the kept bits fit into ResultWidth - 1, the rounded ones into ResultWidth.
// Rounds outward: up, unless every dropped bit is 0.
// Edges  Dropping every bit of a value other than 0 gives 1.
`default_nettype none

module feline_round_outward #(
  parameter int unsigned Width = 2,
  parameter int unsigned BitsWidth = 2,
  parameter int unsigned ResultWidth = 2
) (
  input  wire logic [Width-1:0]     value_i,
  input  wire logic [BitsWidth-1:0] bits_i,
  output logic [ResultWidth-1:0]    rounded_o
);
  logic [Width-1:0] dropped_mask;
  logic             inexact;

  assign dropped_mask = ~({Width{1'b1}} << bits_i);
  assign inexact      = (value_i & dropped_mask) != '0;
  assign rounded_o    = ResultWidth'(value_i >> bits_i) + ResultWidth'(inexact);
endmodule

`default_nettype wire
