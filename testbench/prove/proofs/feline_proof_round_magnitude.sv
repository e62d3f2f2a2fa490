// SPDX-License-Identifier: Apache-2.0
// feline_round_magnitude of group's widths: to nearest is (value + half a unit) / unit, outward (value + unit - 1) / unit,
// each of the unit and of twice the unit.
`default_nettype none

module feline_proof_round_magnitude (
  input  wire logic [63:0] value_i,
  input  wire logic [8:0]  bits_i,
  input  wire logic        nearest_i,
  output logic broken_o
);
  localparam int unsigned Width       = feline_pkg::Float32Width - 8 + feline_pkg::SizeWidth;
  localparam int unsigned ResultWidth = feline_pkg::MantissaWidth;
  localparam int unsigned WideWidth   = 2 * Width + 4;

  logic [Width-1:0]       value;
  logic [ResultWidth-1:0] rounded;
  logic [ResultWidth-1:0] rounded_more;
  logic [WideWidth-1:0]   unit;
  logic [WideWidth-1:0]   expected;
  logic [WideWidth-1:0]   expected_more;
  logic                   in_domain;
  logic [31:0]            bits;

  assign value = value_i[Width-1:0];

  feline_round_magnitude #(.Width(Width), .BitsWidth(9), .ResultWidth(ResultWidth)) u_round_magnitude (
    .nearest_i, .value_i(value), .bits_i, .rounded_o(rounded), .rounded_more_o(rounded_more)
  );

  // Dropping more than all bits and one is like dropping these: less than half a unit is left, or nothing.
  assign bits = 32'(bits_i) > Width + 1 ? 32'(Width + 1) : 32'(bits_i);
  assign unit = WideWidth'(1) << bits;

  always_comb begin
    if (nearest_i) begin
      expected      = (WideWidth'(value) + (unit >> 1)) >> bits;
      expected_more = (WideWidth'(value) + unit) >> (bits + 1);
    end else begin
      expected      = (WideWidth'(value) + unit - WideWidth'(1)) >> bits;
      expected_more = (WideWidth'(value) + unit + unit - WideWidth'(1)) >> (bits + 1);
    end
  end

  // What is kept fits into one bit less than the result.
  assign in_domain = (WideWidth'(value) >> bits) < (WideWidth'(1) << (ResultWidth - 1));
  assign broken_o  = in_domain && (WideWidth'(rounded) != expected || WideWidth'(rounded_more) != expected_more);
endmodule

`default_nettype wire
