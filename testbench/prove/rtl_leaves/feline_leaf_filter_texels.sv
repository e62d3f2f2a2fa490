// SPDX-License-Identifier: Apache-2.0
// All of feline_filter, one channel (testbench/prove/leaves.h, FilterTexels).
`default_nettype none

module feline_leaf_filter_texels #(
  localparam int unsigned InputWidth = 2 + feline_pkg::LevelFractionWidth + 4*feline_pkg::TexelFractionWidth +
      8*feline_pkg::ChannelWidth,
  localparam int unsigned OutputWidth = feline_pkg::FilteredWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic                                      kernel;
  logic                                      linear;
  logic [feline_pkg::LevelFractionWidth-1:0] level_fraction;
  logic [feline_pkg::TexelFractionWidth-1:0] fine_x;
  logic [feline_pkg::TexelFractionWidth-1:0] fine_y;
  logic [feline_pkg::TexelFractionWidth-1:0] coarse_x;
  logic [feline_pkg::TexelFractionWidth-1:0] coarse_y;
  logic [feline_pkg::ChannelWidth-1:0]       fine_00;
  logic [feline_pkg::ChannelWidth-1:0]       fine_10;
  logic [feline_pkg::ChannelWidth-1:0]       fine_01;
  logic [feline_pkg::ChannelWidth-1:0]       fine_11;
  logic [feline_pkg::ChannelWidth-1:0]       coarse_00;
  logic [feline_pkg::ChannelWidth-1:0]       coarse_10;
  logic [feline_pkg::ChannelWidth-1:0]       coarse_01;
  logic [feline_pkg::ChannelWidth-1:0]       coarse_11;
  feline_pkg::sampler_t                      sampler;
  feline_pkg::fetch_t                        fetch;
  feline_pkg::filter_t                       filter;
  logic                                      ready;
  logic                                      valid;

  assign {kernel, linear, level_fraction, fine_x, fine_y, coarse_x, coarse_y, fine_00, fine_10, fine_01, fine_11,
          coarse_00, coarse_10, coarse_01, coarse_11} = inputs_i;

  always_comb begin
    sampler                 = '0;
    sampler.kernel          = kernel;
    fetch                   = '0;
    fetch.linear            = linear;
    fetch.level_fraction    = level_fraction;
    fetch.fine_fraction_x   = fine_x;
    fetch.fine_fraction_y   = fine_y;
    fetch.coarse_fraction_x = coarse_x;
    fetch.coarse_fraction_y = coarse_y;
    fetch.fine_00[0]      = fine_00;
    fetch.fine_10[0]      = fine_10;
    fetch.fine_01[0]      = fine_01;
    fetch.fine_11[0]      = fine_11;
    fetch.coarse_00[0]    = coarse_00;
    fetch.coarse_10[0]    = coarse_10;
    fetch.coarse_01[0]    = coarse_01;
    fetch.coarse_11[0]    = coarse_11;
  end

  feline_filter u_filter (
    .clk_i(1'b0), .rst_i(1'b0), .sampler_i(sampler),
    .fetch_valid_i(1'b1), .fetch_ready_o(ready), .fetch_i(fetch),
    .filter_valid_o(valid), .filter_ready_i(1'b1), .filter_o(filter)
  );

  assign outputs_o = filter.colour[0];

  logic unused_filter;
  assign unused_filter = ^{ready, valid, filter};
endmodule

`default_nettype wire
