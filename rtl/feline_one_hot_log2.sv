// SPDX-License-Identifier: Apache-2.0
// The logarithm of a power of two.
//
// Takes  value, one bit of which is set.
// Gives  log2, the place of that bit.
`default_nettype none

module feline_one_hot_log2 #(
  parameter int unsigned Width     = 2,
  parameter int unsigned Log2Width = 1
) (
  input  wire logic [Width-1:0]     value_i,
  output logic [Log2Width-1:0]      log2_o
);
  always_comb begin
    log2_o = '0;
    for (int i = 0; i < Width; i++) begin
      if (value_i[i]) log2_o = log2_o | Log2Width'(i);
    end
  end
endmodule

`default_nettype wire
