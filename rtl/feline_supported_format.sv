// SPDX-License-Identifier: Apache-2.0
// What a configuration makes of a texel format that it leaves out: the widest that it has (tables/supported.h).
`default_nettype none

module feline_supported_format (
  input  wire logic [feline_pkg::TexelFormatWidth-1:0] texel_format_i,
  output logic [feline_pkg::TexelFormatWidth-1:0]      texel_format_o
);
  always_comb begin
    unique case (texel_format_i)
      feline_pkg::TexelFormatR8:  texel_format_o = feline_pkg::SupportedTexelFormatR8;
      feline_pkg::TexelFormatRg8: texel_format_o = feline_pkg::SupportedTexelFormatRg8;
      default:                    texel_format_o = feline_pkg::SupportedTexelFormatRgba8;
    endcase
  end
endmodule

`default_nettype wire
