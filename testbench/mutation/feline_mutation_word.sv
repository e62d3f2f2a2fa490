// SPDX-License-Identifier: Apache-2.0
// What a ROM gives, but for one word anything, another thing each time, when the mutant says so (kRomBit of
// testbench/mutation/mutant.h): what holds all the same holds whichever of the word's bits are wrong.
`default_nettype none

module feline_mutation_word #(
  parameter int unsigned Width      = 1,
  parameter int unsigned IndexWidth = 1,
  parameter int unsigned Rom        = 1
) (
  input  wire logic [63:0]           mutant_i,
  input  wire logic [Width-1:0]      any_i,
  input  wire logic [IndexWidth-1:0] index_i,
  input  wire logic [Width-1:0]      data_i,
  output logic [Width-1:0]           data_o
);
  logic is_wrong;

  assign is_wrong = mutant_i[15:0] == 16'(Rom) && mutant_i[19:16] == 4'd5 && mutant_i[47:32] == 16'(index_i);
  assign data_o   = is_wrong ? any_i : data_i;

  logic unused_mutant;
  assign unused_mutant = ^mutant_i;
endmodule

`default_nettype wire
