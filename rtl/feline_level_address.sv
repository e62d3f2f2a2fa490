// SPDX-License-Identifier: Apache-2.0
// A wrapped position to the texels, fractions and memory lines of one level.
//
// Takes  s, t S1.24 textures, wrapped; linear; the level, whether it is used, its width and height U15.0; the wrap
//        codes, supported ones; the first line of each level U25.0; what travels along.
// Gives  two columns x and two rows y U14.0, outside bits (of columns, then of rows), fractions U0.8, the lines of
//        texels 00, 10, 01, 11; used; what travelled along.
// Rounds see feline_texel_coordinate and feline_axis_texels.
// Edges  a level that is not used gives zeros.
// Timing three registers: texel coordinate | texels | lines. A beat each cycle.
// Source CS248A lecture 4, step 5; OpenGL 4.6, 8.14 (wrap modes).
`default_nettype none

module feline_level_address #(
  parameter int unsigned SidebandWidth = 1
) (
  input  wire logic                                                clk_i,
  input  wire logic                                                rst_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]                    wrap_s_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]                    wrap_t_i,
  input  wire logic [feline_pkg::Levels*feline_pkg::LineWidth-1:0] level_base_i,
  input  wire logic                                                wrapped_valid_i,
  output logic                                                     wrapped_ready_o,
  input  wire logic [SidebandWidth-1:0]                            sideband_i,
  input  wire logic signed [feline_pkg::PositionFraction+1:0]      s_i,
  input  wire logic signed [feline_pkg::PositionFraction+1:0]      t_i,
  input  wire logic                                                linear_i,
  input  wire logic                                                used_i,
  input  wire logic [feline_pkg::LevelWidth-1:0]                   level_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]                    width_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]                    height_i,
  output logic                                                     lines_valid_o,
  input  wire logic                                                lines_ready_i,
  output logic [SidebandWidth-1:0]                                 sideband_o,
  output logic                                                     used_o,
  output logic [2*feline_pkg::TexelIndexWidth-1:0]                 x_o,
  output logic [2*feline_pkg::TexelIndexWidth-1:0]                 y_o,
  output logic [3:0]                                               border_o,
  output logic [feline_pkg::TexelFractionWidth-1:0]                fraction_x_o,
  output logic [feline_pkg::TexelFractionWidth-1:0]                fraction_y_o,
  output logic [4*feline_pkg::LineWidth-1:0]                       line_o
);
  localparam int unsigned CoordinateWidth = feline_pkg::SizeWidth + feline_pkg::SubtexelBits + 2;
  localparam int unsigned IndexWidth      = feline_pkg::TexelIndexWidth;
  localparam int unsigned FractionWidth   = feline_pkg::TexelFractionWidth;
  localparam int unsigned LineWidth       = feline_pkg::LineWidth;
  localparam int unsigned SizeWidth       = feline_pkg::SizeWidth;
  localparam int unsigned LevelWidth      = feline_pkg::LevelWidth;
  localparam int unsigned BaseSlots       = 1 << LevelWidth;

  typedef struct packed {
    logic [SidebandWidth-1:0]          sideband;
    logic signed [CoordinateWidth-1:0] x;
    logic signed [CoordinateWidth-1:0] y;
    logic                              linear;
    logic [SizeWidth-1:0]              width;
    logic [SizeWidth-1:0]              height;
    logic                              used;
    logic [LevelWidth-1:0]             level;
  } coordinate_t;
  typedef struct packed {
    logic [SidebandWidth-1:0] sideband;
    logic [2*IndexWidth-1:0]  x;
    logic [2*IndexWidth-1:0]  y;
    logic [3:0]               border;
    logic [FractionWidth-1:0] fraction_x;
    logic [FractionWidth-1:0] fraction_y;
    logic [SizeWidth-1:0]     width;
    logic                     used;
    logic [LevelWidth-1:0]    level;
  } texels_t;
  typedef struct packed {
    logic [SidebandWidth-1:0] sideband;
    logic                     used;
    logic [2*IndexWidth-1:0]  x;
    logic [2*IndexWidth-1:0]  y;
    logic [3:0]               border;
    logic [FractionWidth-1:0] fraction_x;
    logic [FractionWidth-1:0] fraction_y;
    logic [4*LineWidth-1:0]   line;
  } lines_t;

  // Texel coordinate.
  coordinate_t coordinate_d;
  coordinate_t coordinate_q;
  logic        coordinate_valid;
  logic        coordinate_ready;

  assign coordinate_d.sideband = sideband_i;
  assign coordinate_d.linear  = linear_i;
  assign coordinate_d.width   = width_i;
  assign coordinate_d.height  = height_i;
  assign coordinate_d.used    = used_i;
  assign coordinate_d.level   = level_i;

  feline_texel_coordinate u_coordinate_x (
    .wrapped_i(s_i), .size_i(width_i), .linear_i, .coordinate_o(coordinate_d.x)
  );
  feline_texel_coordinate u_coordinate_y (
    .wrapped_i(t_i), .size_i(height_i), .linear_i, .coordinate_o(coordinate_d.y)
  );

  feline_stream_register #(.Width($bits(coordinate_d))) u_coordinate (
    .clk_i, .rst_i,
    .valid_i(wrapped_valid_i), .ready_o(wrapped_ready_o), .data_i(coordinate_d),
    .valid_o(coordinate_valid), .ready_i(coordinate_ready), .data_o(coordinate_q)
  );

  // Texels.
  texels_t texels_d;
  texels_t texels_q;
  logic    texels_valid;
  logic    texels_ready;

  assign texels_d.sideband = coordinate_q.sideband;
  assign texels_d.width   = coordinate_q.width;
  assign texels_d.used    = coordinate_q.used;
  assign texels_d.level   = coordinate_q.level;

  feline_axis_texels u_texels_x (
    .coordinate_i(coordinate_q.x), .size_i(coordinate_q.width), .wrap_i(wrap_s_i), .linear_i(coordinate_q.linear),
    .index_o(texels_d.x), .outside_o(texels_d.border[1:0]), .fraction_o(texels_d.fraction_x)
  );
  feline_axis_texels u_texels_y (
    .coordinate_i(coordinate_q.y), .size_i(coordinate_q.height), .wrap_i(wrap_t_i), .linear_i(coordinate_q.linear),
    .index_o(texels_d.y), .outside_o(texels_d.border[3:2]), .fraction_o(texels_d.fraction_y)
  );

  feline_stream_register #(.Width($bits(texels_d))) u_texels (
    .clk_i, .rst_i,
    .valid_i(coordinate_valid), .ready_o(coordinate_ready), .data_i(texels_d),
    .valid_o(texels_valid), .ready_i(texels_ready), .data_o(texels_q)
  );

  // Lines. A base for every code of a level, so that the level after the last is legal, if unused.
  lines_t                         lines_d;
  lines_t                         lines_q;
  logic [BaseSlots*LineWidth-1:0] level_base;
  logic [4*LineWidth-1:0]         line;

  assign level_base = (BaseSlots*LineWidth)'(level_base_i);

  feline_level_lines u_level_lines (
    .x_i(texels_q.x), .y_i(texels_q.y), .width_i(texels_q.width),
    .base_i(level_base[texels_q.level*LineWidth +: LineWidth]), .line_o(line)
  );

  assign lines_d.sideband    = texels_q.sideband;
  assign lines_d.used       = texels_q.used;
  assign lines_d.x          = texels_q.used ? texels_q.x : '0;
  assign lines_d.y          = texels_q.used ? texels_q.y : '0;
  assign lines_d.border     = texels_q.used ? texels_q.border : '0;
  assign lines_d.fraction_x = texels_q.used ? texels_q.fraction_x : '0;
  assign lines_d.fraction_y = texels_q.used ? texels_q.fraction_y : '0;
  assign lines_d.line       = texels_q.used ? line : '0;

  feline_stream_register #(.Width($bits(lines_d))) u_lines (
    .clk_i, .rst_i,
    .valid_i(texels_valid), .ready_o(texels_ready), .data_i(lines_d),
    .valid_o(lines_valid_o), .ready_i(lines_ready_i), .data_o(lines_q)
  );

  assign sideband_o    = lines_q.sideband;
  assign used_o       = lines_q.used;
  assign x_o          = lines_q.x;
  assign y_o          = lines_q.y;
  assign border_o     = lines_q.border;
  assign fraction_x_o = lines_q.fraction_x;
  assign fraction_y_o = lines_q.fraction_y;
  assign line_o       = lines_q.line;
endmodule

`default_nettype wire
