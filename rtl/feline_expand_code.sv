// SPDX-License-Identifier: Apache-2.0
// One 8-bit texel code to a channel U8.4, unit 1/255.
//
// Takes  code; whether it is sRGB.
// Rounds sRGB decoding: to nearest, by table. Otherwise exact: code * 16.
// Edges  a configuration without sRGB has no table and takes every code as linear.
// Source IEC 61966-2-1 (sRGB).
`default_nettype none

module feline_expand_code (
  input  wire logic [feline_pkg::ChannelWidth-feline_pkg::ChannelFraction-1:0] code_i,
  input  wire logic                                                            decodes_i,
  output logic [feline_pkg::ChannelWidth-1:0]                                  channel_o
);
  logic [feline_pkg::ChannelWidth-1:0] linear;

  assign linear = {code_i, feline_pkg::ChannelFraction'(0)};

  if (feline_pkg::FeatureSrgb) begin : gen_srgb
    logic [feline_pkg::ChannelWidth-1:0] decoded;

    feline_rom_srgb u_srgb (.index_i(code_i), .data_o(decoded));

    assign channel_o = decodes_i ? decoded : linear;
  end else begin : gen_no_srgb
    logic unused_decodes;

    assign unused_decodes = decodes_i;
    assign channel_o      = linear;
  end
endmodule

`default_nettype wire
