// SPDX-License-Identifier: Apache-2.0
// A saturating quotient by restoring division, unrolled.
//
// Takes  numerator and denominator, unsigned.
// Gives  min(floor(numerator / denominator), 2^QuotientWidth - 1).
// Rounds down, exactly.
// Edges  A denominator of 0 gives 2^QuotientWidth - 1.
// E.g.   100/7 in 4 bits is 14; 7/0 is 15.
`default_nettype none

module feline_quotient #(
  parameter int unsigned NumeratorWidth   = 8,
  parameter int unsigned DenominatorWidth = 4,
  parameter int unsigned QuotientWidth    = 4
) (
  input  wire logic [NumeratorWidth-1:0]   numerator_i,
  input  wire logic [DenominatorWidth-1:0] denominator_i,
  output logic [QuotientWidth-1:0]         quotient_o
);
  localparam int unsigned UpperWidth     = NumeratorWidth - QuotientWidth;
  localparam int unsigned RemainderWidth = (UpperWidth > DenominatorWidth ? UpperWidth : DenominatorWidth) + 1;

  logic                      saturates;
  logic [RemainderWidth-1:0] denominator;
  logic [RemainderWidth-1:0] remainder;
  logic [QuotientWidth-1:0]  quotient;

  assign denominator = RemainderWidth'(denominator_i);

  always_comb begin
    remainder = RemainderWidth'(numerator_i[NumeratorWidth-1:QuotientWidth]);
    saturates = remainder >= denominator;
    // Unless it saturates, the remainder is less than the denominator before each step and after it.
    for (int i = QuotientWidth - 1; i >= 0; i--) begin
      remainder   = {remainder[RemainderWidth-2:0], numerator_i[i]};
      quotient[i] = remainder >= denominator;
      if (quotient[i]) remainder = remainder - denominator;
    end
  end

  assign quotient_o = saturates ? {QuotientWidth{1'b1}} : quotient;
endmodule

`default_nettype wire
