// SPDX-License-Identifier: Apache-2.0
// The row or half column of the ellipse table for a ratio (table_index of model/footprint.h).
//
// Takes  numerator and denominator, unsigned, numerator <= denominator.
// Gives  min(floor(Steps * numerator / denominator), Steps - 1).
// Rounds down, exactly.
// Edges  A denominator of 0 gives 0.
// Source WRL 99/1, 3.3.
`default_nettype none

module feline_table_index #(
  parameter int unsigned Width      = 8,
  parameter int unsigned Steps      = 4,
  parameter int unsigned IndexWidth = 2  // enough for Steps - 1
) (
  input  wire logic [Width-1:0]     numerator_i,
  input  wire logic [Width-1:0]     denominator_i,
  output logic [IndexWidth-1:0]    index_o
);
  localparam int unsigned StepsWidth     = $clog2(Steps + 1);
  localparam int unsigned NumeratorWidth = Width + StepsWidth;
  // Holds Steps, or saturates at Steps - 1.
  localparam int unsigned QuotientWidth = Steps > 1 ? $clog2(Steps) : 1;

  logic [NumeratorWidth-1:0] numerator;
  logic [QuotientWidth-1:0]  quotient;
  logic [QuotientWidth-1:0]  limited;

  assign numerator = NumeratorWidth'(numerator_i) * NumeratorWidth'(Steps);

  feline_quotient #(
    .NumeratorWidth  (NumeratorWidth),
    .DenominatorWidth(Width),
    .QuotientWidth   (QuotientWidth)
  ) u_quotient (
    .numerator_i  (numerator),
    .denominator_i(denominator_i),
    .quotient_o   (quotient)
  );

  // A quotient above Steps - 1 comes up only where Steps is no power of two.
  assign limited = 32'(quotient) < Steps ? quotient : QuotientWidth'(Steps - 1);
  assign index_o = denominator_i == '0 ? '0 : IndexWidth'(limited);
endmodule

`default_nettype wire
