// SPDX-License-Identifier: Apache-2.0
// The restoring division of the ellipse table's rows and columns and of the ceiling: q * d <= n, and (q + 1) * d > n
// unless q saturates. The wider ones, of eighths and of the line, are enumerated.
`default_nettype none

module feline_proof_quotient (
  input  wire logic [31:0] numerator_i,
  input  wire logic [15:0] denominator_i,
  output logic broken_o
);
  localparam int unsigned RadiusWidth  = feline_pkg::RadiusWidth;
  localparam int unsigned ProductWidth = 2 * feline_pkg::MantissaWidth;
  localparam int unsigned HalfColumns  = feline_pkg::TableColumns / 2;

  logic [2:0] broken;

  feline_proof_quotient_of #(
    .NumeratorWidth(RadiusWidth + $clog2(feline_pkg::TableRows + 1)), .DenominatorWidth(RadiusWidth),
    .QuotientWidth($clog2(feline_pkg::TableRows))
  ) u_row (.numerator_i, .denominator_i, .broken_o(broken[0]));
  feline_proof_quotient_of #(
    .NumeratorWidth(ProductWidth - 1 + $clog2(HalfColumns + 1)), .DenominatorWidth(ProductWidth - 1),
    .QuotientWidth($clog2(HalfColumns))
  ) u_column (.numerator_i, .denominator_i, .broken_o(broken[1]));
  feline_proof_quotient_of #(
    .NumeratorWidth(feline_pkg::DividendWidth), .DenominatorWidth(RadiusWidth),
    .QuotientWidth($clog2(feline_pkg::MaxProbes + 2))
  ) u_ceiling (.numerator_i, .denominator_i, .broken_o(broken[2]));
  assign broken_o = broken != '0;
endmodule

`default_nettype wire
