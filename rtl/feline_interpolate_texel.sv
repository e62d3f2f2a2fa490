// SPDX-License-Identifier: Apache-2.0
// Four channels from a towards b by one fraction: feline_interpolate of each, the first channel lowest.
`default_nettype none

module feline_interpolate_texel #(
  parameter int unsigned ValueWidth    = 1,
  parameter int unsigned FractionWidth = 1
) (
  input  wire logic [4*ValueWidth-1:0]             a_i,
  input  wire logic [4*ValueWidth-1:0]             b_i,
  input  wire logic [FractionWidth-1:0]            fraction_i,
  output logic [4*(ValueWidth+FractionWidth)-1:0]  value_o
);
  localparam int unsigned ResultWidth = ValueWidth + FractionWidth;

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    if (feline_pkg::HasChannel[c]) begin : gen_interpolate
      feline_interpolate #(.ValueWidth(ValueWidth), .FractionWidth(FractionWidth)) u_interpolate (
        .a_i(a_i[c*ValueWidth +: ValueWidth]), .b_i(b_i[c*ValueWidth +: ValueWidth]), .fraction_i,
        .value_o(value_o[c*ResultWidth +: ResultWidth])
      );
    end else begin : gen_constant
      // Of a channel that the configuration has no place for: 0, alpha one.
      assign value_o[c*ResultWidth +: ResultWidth] = c == 3 ? {8'hff, (ResultWidth - 8)'(0)} : '0;

      logic unused_inputs;
      assign unused_inputs = ^{a_i[c*ValueWidth +: ValueWidth], b_i[c*ValueWidth +: ValueWidth], fraction_i};
    end
  end
endmodule

`default_nettype wire
