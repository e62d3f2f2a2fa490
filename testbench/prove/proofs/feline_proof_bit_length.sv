// SPDX-License-Identifier: Apache-2.0
// feline_bit_length is the number of the highest bit that is set, found one after the other.
`default_nettype none

module feline_proof_bit_length (
  input  wire logic [63:0] value_i,
  output logic broken_o
);
  localparam int unsigned Width = feline_pkg::Float32Width - 8 + feline_pkg::SizeWidth;

  logic [$clog2(Width+1)-1:0] length;
  logic [$clog2(Width+1)-1:0] expected;

  feline_bit_length #(.Width(Width)) u_bit_length (.value_i(value_i[Width-1:0]), .length_o(length));

  always_comb begin
    expected = '0;
    for (int i = 0; i < Width; i++) begin
      if (value_i[i]) expected = ($clog2(Width+1))'(i + 1);
    end
  end

  assign broken_o = length != expected;
endmodule

`default_nettype wire
