// SPDX-License-Identifier: Apache-2.0
// The bits that a value needs (bit_length of tables/rounding.h): 0 for 0, 1 for 1, 3 for 7.
//
// Takes  an unsigned value.
// Gives  the position of its leading one, plus one.
// Rounds nothing.
// Edges  0 gives 0.
// A binary search: each step halves the part in which the leading one can be.
`default_nettype none

module feline_bit_length #(
  parameter  int unsigned Width = 2,
  localparam int unsigned LengthWidth = $clog2(Width + 1)
) (
  input  wire logic [Width-1:0] value_i,
  output logic [LengthWidth-1:0] length_o
);
  // The value when the search starts, in a power of two of bits.
  localparam int unsigned SearchWidth = 1 << LengthWidth;

  logic [SearchWidth-1:0] rest;

  always_comb begin
    rest = SearchWidth'(value_i);
    for (int i = LengthWidth - 1; i >= 0; i--) begin
      // A length of at least 2^i: the value does not fit into 2^i - 1 bits.
      length_o[i] = (rest >> ((1 << i) - 1)) != '0;
      if (length_o[i]) rest = rest >> (1 << i);
    end
  end
endmodule

`default_nettype wire
