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
// Timing four registers: wrapped position | texel coordinate | texels | lines. A beat each cycle.
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
  localparam int unsigned WrappedWidth    = feline_pkg::PositionFraction + 2;
  localparam int unsigned CoordinateWidth = feline_pkg::SizeWidth + feline_pkg::SubtexelBits + 2;
  localparam int unsigned IndexWidth      = feline_pkg::TexelIndexWidth;
  localparam int unsigned FractionWidth   = feline_pkg::TexelFractionWidth;
  localparam int unsigned LineWidth       = feline_pkg::LineWidth;
  localparam int unsigned SizeWidth       = feline_pkg::SizeWidth;
  localparam int unsigned BaseSlots       = 1 << feline_pkg::LevelWidth;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]           tag;
    logic [feline_pkg::StatusWidth-1:0]        status;
    logic [feline_pkg::ProbeIndexWidth-1:0]    probe;
    logic                                      first;
    logic                                      last;
    logic [feline_pkg::WeightWidth-1:0]        weight;
    logic                                      linear;
    logic [feline_pkg::LevelWidth-1:0]         level;
    logic [feline_pkg::LevelFractionWidth-1:0] level_fraction;
  } header_t;

  // Of two levels, fine and coarse: the fine one is element 0.
  typedef struct packed {
    header_t                 header;
    logic [WrappedWidth-1:0] s;
    logic [WrappedWidth-1:0] t;
    logic [2*SizeWidth-1:0]  width;
    logic [2*SizeWidth-1:0]  height;
  } wrapped_beat_t;

  typedef struct packed {
    header_t                      header;
    logic [2*CoordinateWidth-1:0] x;
    logic [2*CoordinateWidth-1:0] y;
    logic [2*SizeWidth-1:0]       width;
    logic [2*SizeWidth-1:0]       height;
  } scaled_beat_t;

  typedef struct packed {
    header_t                    header;
    logic [2*2*IndexWidth-1:0]  x;
    logic [2*2*IndexWidth-1:0]  y;
    logic [2*4-1:0]             border;
    logic [2*FractionWidth-1:0] fraction_x;
    logic [2*FractionWidth-1:0] fraction_y;
    logic [2*SizeWidth-1:0]     width;
  } resolved_beat_t;

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;

  logic [feline_pkg::WrapWidth-1:0] wrap_s;
  logic [feline_pkg::WrapWidth-1:0] wrap_t;

  feline_supported_wrap u_supported_wrap_s (.wrap_i(sampler_i.wrap_s), .wrap_o(wrap_s));
  feline_supported_wrap u_supported_wrap_t (.wrap_i(sampler_i.wrap_t), .wrap_o(wrap_t));

  // Wrapped position and the sizes of both levels.
  logic signed [WrappedWidth-1:0]    wrapped_s;
  logic signed [WrappedWidth-1:0]    wrapped_t;
  logic [2*SizeWidth-1:0]            width;
  logic [2*SizeWidth-1:0]            height;
  logic [feline_pkg::LevelWidth-1:0] level;
  wrapped_beat_t                     wrapped_d;
  wrapped_beat_t                     wrapped_q;
  logic                              wrapped_valid;
  logic                              wrapped_ready;

  assign level = walk_i.level_of_detail[feline_pkg::SampledLevelWidth-1:feline_pkg::SampledLevelFraction];

  feline_wrap u_wrap_s (.position_i(walk_i.s), .wrap_i(wrap_s), .wrapped_o(wrapped_s));
  feline_wrap u_wrap_t (.position_i(walk_i.t), .wrap_i(wrap_t), .wrapped_o(wrapped_t));

  for (genvar i = 0; i < 2; i++) begin : gen_size
    logic [feline_pkg::LevelWidth:0] level_i;

    assign level_i = {1'b0, level} + (feline_pkg::LevelWidth + 1)'(i);

    feline_level_size u_width (
      .size_i(sampler_i.width), .level_i(level_i), .size_o(width[i*SizeWidth +: SizeWidth])
    );
    feline_level_size u_height (
      .size_i(sampler_i.height), .level_i(level_i), .size_o(height[i*SizeWidth +: SizeWidth])
    );
  end

  always_comb begin
    wrapped_d.header.tag            = walk_i.tag;
    wrapped_d.header.status         = walk_i.status;
    wrapped_d.header.probe          = walk_i.probe;
    wrapped_d.header.first          = walk_i.first;
    wrapped_d.header.last           = walk_i.last;
    wrapped_d.header.weight         = walk_i.weight;
    wrapped_d.header.linear         = walk_i.linear;
    wrapped_d.header.level          = level;
    wrapped_d.header.level_fraction = walk_i.level_of_detail[feline_pkg::SampledLevelFraction-1:0];
    wrapped_d.s                     = wrapped_s;
    wrapped_d.t                     = wrapped_t;
    wrapped_d.width                 = width;
    wrapped_d.height                = height;
  end

  feline_stream_register #(.Width($bits(wrapped_d))) u_wrapped (
    .clk_i, .rst_i,
    .valid_i(walk_valid_i), .ready_o(walk_ready_o), .data_i(wrapped_d),
    .valid_o(wrapped_valid), .ready_i(wrapped_ready), .data_o(wrapped_q)
  );

  // Texel coordinate on both levels.
  logic [2*CoordinateWidth-1:0] coordinate_x;
  logic [2*CoordinateWidth-1:0] coordinate_y;
  scaled_beat_t                 scaled_d;
  scaled_beat_t                 scaled_q;
  logic                         scaled_valid;
  logic                         scaled_ready;

  for (genvar i = 0; i < 2; i++) begin : gen_coordinate
    feline_texel_coordinate u_x (
      .wrapped_i(wrapped_q.s), .size_i(wrapped_q.width[i*SizeWidth +: SizeWidth]), .linear_i(wrapped_q.header.linear),
      .coordinate_o(coordinate_x[i*CoordinateWidth +: CoordinateWidth])
    );
    feline_texel_coordinate u_y (
      .wrapped_i(wrapped_q.t), .size_i(wrapped_q.height[i*SizeWidth +: SizeWidth]), .linear_i(wrapped_q.header.linear),
      .coordinate_o(coordinate_y[i*CoordinateWidth +: CoordinateWidth])
    );
  end

  always_comb begin
    scaled_d.header = wrapped_q.header;
    scaled_d.x      = coordinate_x;
    scaled_d.y      = coordinate_y;
    scaled_d.width  = wrapped_q.width;
    scaled_d.height = wrapped_q.height;
  end

  feline_stream_register #(.Width($bits(scaled_d))) u_scaled (
    .clk_i, .rst_i,
    .valid_i(wrapped_valid), .ready_o(wrapped_ready), .data_i(scaled_d),
    .valid_o(scaled_valid), .ready_i(scaled_ready), .data_o(scaled_q)
  );

  // Texels of both levels.
  logic [2*2*IndexWidth-1:0]  x;
  logic [2*2*IndexWidth-1:0]  y;
  logic [2*4-1:0]             border;
  logic [2*FractionWidth-1:0] fraction_x;
  logic [2*FractionWidth-1:0] fraction_y;
  resolved_beat_t             resolved_d;
  resolved_beat_t             resolved_q;
  logic                       resolved_valid;
  logic                       resolved_ready;

  for (genvar i = 0; i < 2; i++) begin : gen_texels
    feline_axis_texels u_x (
      .coordinate_i(scaled_q.x[i*CoordinateWidth +: CoordinateWidth]),
      .size_i(scaled_q.width[i*SizeWidth +: SizeWidth]),
      .wrap_i(wrap_s), .linear_i(scaled_q.header.linear),
      .index_o(x[2*i*IndexWidth +: 2*IndexWidth]), .outside_o(border[4*i +: 2]),
      .fraction_o(fraction_x[i*FractionWidth +: FractionWidth])
    );
    feline_axis_texels u_y (
      .coordinate_i(scaled_q.y[i*CoordinateWidth +: CoordinateWidth]),
      .size_i(scaled_q.height[i*SizeWidth +: SizeWidth]),
      .wrap_i(wrap_t), .linear_i(scaled_q.header.linear),
      .index_o(y[2*i*IndexWidth +: 2*IndexWidth]), .outside_o(border[4*i + 2 +: 2]),
      .fraction_o(fraction_y[i*FractionWidth +: FractionWidth])
    );
  end

  always_comb begin
    resolved_d.header     = scaled_q.header;
    resolved_d.x          = x;
    resolved_d.y          = y;
    resolved_d.border     = border;
    resolved_d.fraction_x = fraction_x;
    resolved_d.fraction_y = fraction_y;
    resolved_d.width      = scaled_q.width;
  end

  feline_stream_register #(.Width($bits(resolved_d))) u_resolved (
    .clk_i, .rst_i,
    .valid_i(scaled_valid), .ready_o(scaled_ready), .data_i(resolved_d),
    .valid_o(resolved_valid), .ready_i(resolved_ready), .data_o(resolved_q)
  );

  // Lines of both levels. A base for every code of a level, so that the level after the last is legal, if unused.
  logic [BaseSlots*LineWidth-1:0] level_base;
  logic [2*4*LineWidth-1:0]       line;
  logic                           coarse_used;
  feline_pkg::address_t           beat;

  assign level_base = (BaseSlots*LineWidth)'(sampler_i.level_base);

  for (genvar i = 0; i < 2; i++) begin : gen_lines
    logic [feline_pkg::LevelWidth-1:0] level_i;

    assign level_i = resolved_q.header.level + feline_pkg::LevelWidth'(i);

    feline_level_lines u_lines (
      .x_i(resolved_q.x[2*i*IndexWidth +: 2*IndexWidth]), .y_i(resolved_q.y[2*i*IndexWidth +: 2*IndexWidth]),
      .width_i(resolved_q.width[i*SizeWidth +: SizeWidth]), .base_i(level_base[level_i*LineWidth +: LineWidth]),
      .line_o(line[4*i*LineWidth +: 4*LineWidth])
    );
  end

  assign coarse_used = resolved_q.header.level_fraction != '0;

  always_comb begin
    beat.tag               = resolved_q.header.tag;
    beat.status            = resolved_q.header.status;
    beat.probe             = resolved_q.header.probe;
    beat.first             = resolved_q.header.first;
    beat.last              = resolved_q.header.last;
    beat.weight            = resolved_q.header.weight;
    beat.linear            = resolved_q.header.linear;
    beat.level             = resolved_q.header.level;
    beat.level_fraction    = resolved_q.header.level_fraction;
    beat.fine_x            = resolved_q.x[0 +: 2*IndexWidth];
    beat.fine_y            = resolved_q.y[0 +: 2*IndexWidth];
    beat.fine_border       = resolved_q.border[0 +: 4];
    beat.fine_fraction_x   = resolved_q.fraction_x[0 +: FractionWidth];
    beat.fine_fraction_y   = resolved_q.fraction_y[0 +: FractionWidth];
    beat.fine_line         = line[0 +: 4*LineWidth];
    beat.coarse_used       = coarse_used;
    beat.coarse_x          = coarse_used ? resolved_q.x[2*IndexWidth +: 2*IndexWidth] : '0;
    beat.coarse_y          = coarse_used ? resolved_q.y[2*IndexWidth +: 2*IndexWidth] : '0;
    beat.coarse_border     = coarse_used ? resolved_q.border[4 +: 4] : '0;
    beat.coarse_fraction_x = coarse_used ? resolved_q.fraction_x[FractionWidth +: FractionWidth] : '0;
    beat.coarse_fraction_y = coarse_used ? resolved_q.fraction_y[FractionWidth +: FractionWidth] : '0;
    beat.coarse_line       = coarse_used ? line[4*LineWidth +: 4*LineWidth] : '0;
  end

  feline_stream_register #(.Width(feline_pkg::AddressBeatWidth)) u_address (
    .clk_i, .rst_i,
    .valid_i(resolved_valid), .ready_o(resolved_ready), .data_i(beat),
    .valid_o(address_valid_o), .ready_i(address_ready_i), .data_o(address_o)
  );
endmodule

`default_nettype wire
