// SPDX-License-Identifier: Apache-2.0
// address: a probe to the texels, fractions and memory lines of two levels.
//
// Takes  s, t S20.24 textures; level_of_detail U4.8; linear; wrap modes, sizes, level bases.
// Gives  fine level floor(level_of_detail), coarse level one more, its weight level_fraction U0.8; for each two
//        columns, two rows U14.0 after wrapping, outside bits, fractions U0.8, and the line of each of four texels.
// Rounds linear: texel coordinate position * size to 8 fraction bits, nearest, ties up, then less half a texel.
//        nearest: down to the texel that holds the position.
// Edges  repeat: modulo 1. mirrored repeat: modulo 2, then 2 - x beyond 1. clamp to edge: to 0 .. 1. clamp to border:
//        to -1 .. 2 - 2^-24; texels outside the level are border. Sizes are max(1, size >> level). coarse_used is
//        whether level_fraction is not 0: a coarse level that weighs nothing is not touched, its fields are 0.
// Timing four registers: wrapped position | then, of each level, texel coordinate | texels | lines
//        (feline_level_address). A beat each cycle.
// Source CS248A lecture 4, step 5; OpenGL 4.6, 8.14 (wrap modes). A line is a 4 x 4 tile of texels, lines of a level in
//        rows of tiles: line = base + (y/4) * tiles a row + x/4.
`default_nettype none

module feline_address (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 walk_valid_i,
  output logic                      walk_ready_o,
  input  wire feline_pkg::walk_t    walk_i,
  output logic                      address_valid_o,
  input  wire logic                 address_ready_i,
  output feline_pkg::address_t      address_o
);
  localparam int unsigned WrappedWidth = feline_pkg::PositionFraction + 2;
  localparam int unsigned SizeWidth    = feline_pkg::SizeWidth;
  localparam int unsigned LevelWidth   = feline_pkg::LevelWidth;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]           tag;
    logic [feline_pkg::StatusWidth-1:0]        status;
    logic [feline_pkg::ProbeIndexWidth-1:0]    probe;
    logic                                      first;
    logic                                      last;
    logic [feline_pkg::WeightWidth-1:0]        weight;
    logic                                      linear;
    logic [LevelWidth-1:0]                     level;
    logic [feline_pkg::LevelFractionWidth-1:0] level_fraction;
  } header_t;
  typedef struct packed {
    header_t                        header;
    logic signed [WrappedWidth-1:0] s;
    logic signed [WrappedWidth-1:0] t;
    logic [SizeWidth-1:0]           fine_width;
    logic [SizeWidth-1:0]           fine_height;
    logic [SizeWidth-1:0]           coarse_width;
    logic [SizeWidth-1:0]           coarse_height;
  } wrapped_beat_t;

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;

  // Wrapped position and the sizes of both levels.
  logic [feline_pkg::WrapWidth-1:0] wrap_s;
  logic [feline_pkg::WrapWidth-1:0] wrap_t;
  logic [LevelWidth:0]              fine_level;
  logic [LevelWidth:0]              coarse_level;
  wrapped_beat_t                    wrapped_d;
  wrapped_beat_t                    wrapped_q;
  logic                             wrapped_valid;
  logic                             wrapped_ready;

  assign fine_level   = {1'b0, walk_i.level_of_detail[feline_pkg::SampledLevelFraction +: LevelWidth]};
  assign coarse_level = fine_level + 1'b1;

  feline_supported_wrap u_supported_wrap_s (.wrap_i(sampler_i.wrap_s), .wrap_o(wrap_s));
  feline_supported_wrap u_supported_wrap_t (.wrap_i(sampler_i.wrap_t), .wrap_o(wrap_t));

  feline_wrap u_wrap_s (.position_i(walk_i.s), .wrap_i(wrap_s), .wrapped_o(wrapped_d.s));
  feline_wrap u_wrap_t (.position_i(walk_i.t), .wrap_i(wrap_t), .wrapped_o(wrapped_d.t));

  feline_level_size u_fine_width (.size_i(sampler_i.width), .level_i(fine_level), .size_o(wrapped_d.fine_width));
  feline_level_size u_fine_height (.size_i(sampler_i.height), .level_i(fine_level), .size_o(wrapped_d.fine_height));
  feline_level_size u_coarse_width (.size_i(sampler_i.width), .level_i(coarse_level), .size_o(wrapped_d.coarse_width));
  feline_level_size u_coarse_height (
    .size_i(sampler_i.height), .level_i(coarse_level), .size_o(wrapped_d.coarse_height)
  );

  assign wrapped_d.header.tag            = walk_i.tag;
  assign wrapped_d.header.status         = walk_i.status;
  assign wrapped_d.header.probe          = walk_i.probe;
  assign wrapped_d.header.first          = walk_i.first;
  assign wrapped_d.header.last           = walk_i.last;
  assign wrapped_d.header.weight         = walk_i.weight;
  assign wrapped_d.header.linear         = walk_i.linear;
  assign wrapped_d.header.level          = fine_level[LevelWidth-1:0];
  assign wrapped_d.header.level_fraction = walk_i.level_of_detail[feline_pkg::SampledLevelFraction-1:0];

  feline_stream_register #(.Width($bits(wrapped_d))) u_wrapped (
    .clk_i, .rst_i,
    .valid_i(walk_valid_i), .ready_o(walk_ready_o), .data_i(wrapped_d),
    .valid_o(wrapped_valid), .ready_i(wrapped_ready), .data_o(wrapped_q)
  );

  // Both levels move in step, having the same valid and the same ready; the fine one carries the header.
  header_t               header;
  feline_pkg::address_t  beat;
  logic                  fine_used;
  logic                  coarse_ready;
  logic                  coarse_valid;
  logic                  coarse_sideband;
  logic [LevelWidth-1:0] level_after;

  assign level_after = wrapped_q.header.level + 1'b1;

  feline_level_address #(.SidebandWidth($bits(header))) u_fine (
    .clk_i, .rst_i, .wrap_s_i(wrap_s), .wrap_t_i(wrap_t), .level_base_i(sampler_i.level_base),
    .wrapped_valid_i(wrapped_valid), .wrapped_ready_o(wrapped_ready),
    .sideband_i(wrapped_q.header), .s_i(wrapped_q.s), .t_i(wrapped_q.t), .linear_i(wrapped_q.header.linear),
    .used_i(1'b1), .level_i(wrapped_q.header.level), .width_i(wrapped_q.fine_width), .height_i(wrapped_q.fine_height),
    .lines_valid_o(address_valid_o), .lines_ready_i(address_ready_i), .sideband_o(header), .used_o(fine_used),
    .x_o(beat.fine_x), .y_o(beat.fine_y), .border_o(beat.fine_border),
    .fraction_x_o(beat.fine_fraction_x), .fraction_y_o(beat.fine_fraction_y), .line_o(beat.fine_line)
  );

  feline_level_address #(.SidebandWidth(1)) u_coarse (
    .clk_i, .rst_i, .wrap_s_i(wrap_s), .wrap_t_i(wrap_t), .level_base_i(sampler_i.level_base),
    .wrapped_valid_i(wrapped_valid), .wrapped_ready_o(coarse_ready),
    .sideband_i(1'b0), .s_i(wrapped_q.s), .t_i(wrapped_q.t), .linear_i(wrapped_q.header.linear),
    .used_i(feline_pkg::FeatureLevelBlend && wrapped_q.header.level_fraction != '0), .level_i(level_after),
    .width_i(wrapped_q.coarse_width), .height_i(wrapped_q.coarse_height),
    .lines_valid_o(coarse_valid), .lines_ready_i(address_ready_i), .sideband_o(coarse_sideband),
    .used_o(beat.coarse_used), .x_o(beat.coarse_x), .y_o(beat.coarse_y), .border_o(beat.coarse_border),
    .fraction_x_o(beat.coarse_fraction_x), .fraction_y_o(beat.coarse_fraction_y), .line_o(beat.coarse_line)
  );

  logic unused_levels;
  assign unused_levels = ^{fine_used, coarse_ready, coarse_valid, coarse_sideband};

  assign beat.tag            = header.tag;
  assign beat.status         = header.status;
  assign beat.probe          = header.probe;
  assign beat.first          = header.first;
  assign beat.last           = header.last;
  assign beat.weight         = header.weight;
  assign beat.linear         = header.linear;
  assign beat.level          = header.level;
  assign beat.level_fraction = header.level_fraction;

  assign address_o = beat;
endmodule

`default_nettype wire
