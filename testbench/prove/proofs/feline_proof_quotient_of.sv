// SPDX-License-Identifier: Apache-2.0
// feline_quotient of one set of widths, by multiplying back.
`default_nettype none

module feline_proof_quotient_of #(
  parameter int unsigned NumeratorWidth   = 2,
  parameter int unsigned DenominatorWidth = 1,
  parameter int unsigned QuotientWidth    = 1
) (
  input  wire logic [31:0] numerator_i,
  input  wire logic [15:0] denominator_i,
  output logic             broken_o
);
  localparam int unsigned WideWidth = NumeratorWidth + DenominatorWidth + QuotientWidth + 1;

  logic [QuotientWidth-1:0] quotient;
  logic [WideWidth-1:0]     numerator;
  logic [WideWidth-1:0]     denominator;
  logic [WideWidth-1:0]     part;
  logic                     saturated;

  feline_quotient #(
    .NumeratorWidth(NumeratorWidth), .DenominatorWidth(DenominatorWidth), .QuotientWidth(QuotientWidth)
  ) u_quotient (
    .numerator_i(numerator_i[NumeratorWidth-1:0]), .denominator_i(denominator_i[DenominatorWidth-1:0]),
    .quotient_o(quotient)
  );

  assign numerator   = WideWidth'(numerator_i[NumeratorWidth-1:0]);
  assign denominator = WideWidth'(denominator_i[DenominatorWidth-1:0]);
  assign part        = WideWidth'(quotient) * denominator;
  assign saturated   = quotient == {QuotientWidth{1'b1}};
  assign broken_o    = part > numerator || (!saturated && part + denominator <= numerator);
endmodule

`default_nettype wire
