// SPDX-License-Identifier: Apache-2.0
// filter: eight texels and their fractions to one colour.
//
// Takes  texels U8.4, unit 1/255; fractions U0.8 along x and y of each level; level_fraction U0.8; the kernel.
// Gives  colour U8.28, unit 1/255: exact.
// Rounds nothing: along x U8.4 -> U8.12, along y -> U8.20, between levels -> U8.28. Each step is a convex combination,
//        so the result lies within the texels that have weight, and equal texels come back exactly.
// Edges  gaussian: each fraction is first replaced by the weight of a table; nearest texels take no kernel. A
//        configuration without it is bilinear.
// Timing three registers: x | y | levels. A beat each cycle.
// Source CS248A lecture 4, step 7; WRL 99/1, 3.4 (Gaussian probes, 2 x 2).
`default_nettype none

module feline_filter (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 fetch_valid_i,
  output logic                      fetch_ready_o,
  input  wire feline_pkg::fetch_t   fetch_i,
  output logic                      filter_valid_o,
  input  wire logic                 filter_ready_i,
  output feline_pkg::filter_t       filter_o
);
  localparam int unsigned FractionWidth      = feline_pkg::TexelFractionWidth;
  localparam int unsigned LevelFractionWidth = feline_pkg::LevelFractionWidth;
  localparam int unsigned TexelWidth         = feline_pkg::ChannelWidth;
  localparam int unsigned RowWidth           = TexelWidth + FractionWidth;
  localparam int unsigned LevelWidth         = RowWidth + FractionWidth;
  localparam int unsigned ColourWidth        = feline_pkg::FilteredWidth;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]        tag;
    logic [feline_pkg::StatusWidth-1:0]     status;
    logic [feline_pkg::ProbeIndexWidth-1:0] probe;
    logic                                   first;
    logic                                   last;
    logic [feline_pkg::WeightWidth-1:0]     weight;
    logic [LevelFractionWidth-1:0]          level_fraction;
  } header_t;

  // Rows 0 and 1 of each level, after x; four channels each, red lowest.
  typedef struct packed {
    header_t                  header;
    logic [FractionWidth-1:0] fine_y;
    logic [FractionWidth-1:0] coarse_y;
    logic [4*RowWidth-1:0]    fine_0;
    logic [4*RowWidth-1:0]    fine_1;
    logic [4*RowWidth-1:0]    coarse_0;
    logic [4*RowWidth-1:0]    coarse_1;
  } rows_t;

  // Each level, after y.
  typedef struct packed {
    header_t                 header;
    logic [4*LevelWidth-1:0] fine;
    logic [4*LevelWidth-1:0] coarse;
  } levels_t;

  logic unused_sampler;
  assign unused_sampler = ^{sampler_i, fetch_i.linear};

  // The fractions, or what the kernel makes of them.
  logic [FractionWidth-1:0] fine_x;
  logic [FractionWidth-1:0] fine_y;
  logic [FractionWidth-1:0] coarse_x;
  logic [FractionWidth-1:0] coarse_y;

  if (feline_pkg::FeatureGaussian && feline_pkg::FeatureLinearTexels) begin : gen_gaussian
    logic                     gaussian;
    logic [FractionWidth-1:0] gaussian_fine_x;
    logic [FractionWidth-1:0] gaussian_fine_y;
    logic [FractionWidth-1:0] gaussian_coarse_x;
    logic [FractionWidth-1:0] gaussian_coarse_y;

    feline_rom_gaussian u_fine_x (.index_i(fetch_i.fine_fraction_x), .data_o(gaussian_fine_x));
    feline_rom_gaussian u_fine_y (.index_i(fetch_i.fine_fraction_y), .data_o(gaussian_fine_y));
    feline_rom_gaussian u_coarse_x (.index_i(fetch_i.coarse_fraction_x), .data_o(gaussian_coarse_x));
    feline_rom_gaussian u_coarse_y (.index_i(fetch_i.coarse_fraction_y), .data_o(gaussian_coarse_y));

    assign gaussian = sampler_i.kernel == feline_pkg::KernelGaussian && fetch_i.linear;
    assign fine_x   = gaussian ? gaussian_fine_x : fetch_i.fine_fraction_x;
    assign fine_y   = gaussian ? gaussian_fine_y : fetch_i.fine_fraction_y;
    assign coarse_x = gaussian ? gaussian_coarse_x : fetch_i.coarse_fraction_x;
    assign coarse_y = gaussian ? gaussian_coarse_y : fetch_i.coarse_fraction_y;
  end else begin : gen_no_gaussian
    assign fine_x   = fetch_i.fine_fraction_x;
    assign fine_y   = fetch_i.fine_fraction_y;
    assign coarse_x = fetch_i.coarse_fraction_x;
    assign coarse_y = fetch_i.coarse_fraction_y;
  end

  logic [4*RowWidth-1:0] fine_0;
  logic [4*RowWidth-1:0] fine_1;
  logic [4*RowWidth-1:0] coarse_0;
  logic [4*RowWidth-1:0] coarse_1;
  rows_t                 rows_d;
  rows_t                 rows_q;
  logic                  rows_valid;
  logic                  rows_ready;

  feline_interpolate_texel #(.ValueWidth(TexelWidth), .FractionWidth(FractionWidth)) u_fine_0 (
    .a_i(fetch_i.fine_00), .b_i(fetch_i.fine_10), .fraction_i(fine_x), .value_o(fine_0)
  );
  feline_interpolate_texel #(.ValueWidth(TexelWidth), .FractionWidth(FractionWidth)) u_fine_1 (
    .a_i(fetch_i.fine_01), .b_i(fetch_i.fine_11), .fraction_i(fine_x), .value_o(fine_1)
  );
  if (feline_pkg::FeatureLevelBlend) begin : gen_coarse_rows
    feline_interpolate_texel #(.ValueWidth(TexelWidth), .FractionWidth(FractionWidth)) u_coarse_0 (
      .a_i(fetch_i.coarse_00), .b_i(fetch_i.coarse_10), .fraction_i(coarse_x), .value_o(coarse_0)
    );
    feline_interpolate_texel #(.ValueWidth(TexelWidth), .FractionWidth(FractionWidth)) u_coarse_1 (
      .a_i(fetch_i.coarse_01), .b_i(fetch_i.coarse_11), .fraction_i(coarse_x), .value_o(coarse_1)
    );
  end else begin : gen_no_coarse_rows
    assign coarse_0 = '0;
    assign coarse_1 = '0;

    logic unused_coarse;
    assign unused_coarse = ^{fetch_i.coarse_00, fetch_i.coarse_10, fetch_i.coarse_01, fetch_i.coarse_11, coarse_x};
  end

  always_comb begin
    rows_d.header.tag            = fetch_i.tag;
    rows_d.header.status         = fetch_i.status;
    rows_d.header.probe          = fetch_i.probe;
    rows_d.header.first          = fetch_i.first;
    rows_d.header.last           = fetch_i.last;
    rows_d.header.weight         = fetch_i.weight;
    rows_d.header.level_fraction = fetch_i.level_fraction;
    rows_d.fine_y                = fine_y;
    rows_d.coarse_y              = coarse_y;
    rows_d.fine_0                = fine_0;
    rows_d.fine_1                = fine_1;
    rows_d.coarse_0              = coarse_0;
    rows_d.coarse_1              = coarse_1;
  end

  feline_stream_register #(.Width($bits(rows_d))) u_rows (
    .clk_i, .rst_i,
    .valid_i(fetch_valid_i), .ready_o(fetch_ready_o), .data_i(rows_d),
    .valid_o(rows_valid), .ready_i(rows_ready), .data_o(rows_q)
  );

  logic [4*LevelWidth-1:0] fine;
  logic [4*LevelWidth-1:0] coarse;
  levels_t                 levels_d;
  levels_t                 levels_q;
  logic                    levels_valid;
  logic                    levels_ready;

  feline_interpolate_texel #(.ValueWidth(RowWidth), .FractionWidth(FractionWidth)) u_fine (
    .a_i(rows_q.fine_0), .b_i(rows_q.fine_1), .fraction_i(rows_q.fine_y), .value_o(fine)
  );
  if (feline_pkg::FeatureLevelBlend) begin : gen_coarse
    feline_interpolate_texel #(.ValueWidth(RowWidth), .FractionWidth(FractionWidth)) u_coarse (
      .a_i(rows_q.coarse_0), .b_i(rows_q.coarse_1), .fraction_i(rows_q.coarse_y), .value_o(coarse)
    );
  end else begin : gen_no_coarse
    assign coarse = '0;

    logic unused_coarse;
    assign unused_coarse = ^{rows_q.coarse_0, rows_q.coarse_1, rows_q.coarse_y};
  end

  always_comb begin
    levels_d.header = rows_q.header;
    levels_d.fine   = fine;
    levels_d.coarse = coarse;
  end

  feline_stream_register #(.Width($bits(levels_d))) u_levels (
    .clk_i, .rst_i,
    .valid_i(rows_valid), .ready_o(rows_ready), .data_i(levels_d),
    .valid_o(levels_valid), .ready_i(levels_ready), .data_o(levels_q)
  );

  logic [4*ColourWidth-1:0] colour;
  feline_pkg::filter_t      beat;

  if (feline_pkg::FeatureLevelBlend) begin : gen_blend
    feline_interpolate_texel #(.ValueWidth(LevelWidth), .FractionWidth(LevelFractionWidth)) u_colour (
      .a_i(levels_q.fine), .b_i(levels_q.coarse), .fraction_i(levels_q.header.level_fraction), .value_o(colour)
    );
  end else begin : gen_fine_only
    for (genvar c = 0; c < 4; c++) begin : gen_channel
      assign colour[c*ColourWidth +: ColourWidth] =
          {levels_q.fine[c*LevelWidth +: LevelWidth], LevelFractionWidth'(0)};
    end

    logic unused_coarse;
    assign unused_coarse = ^{levels_q.coarse, levels_q.header.level_fraction};
  end

  always_comb begin
    beat.tag    = levels_q.header.tag;
    beat.status = levels_q.header.status;
    beat.probe  = levels_q.header.probe;
    beat.first  = levels_q.header.first;
    beat.last   = levels_q.header.last;
    beat.weight = levels_q.header.weight;
    beat.colour = colour;
  end

  feline_stream_register #(.Width(feline_pkg::FilterBeatWidth)) u_output (
    .clk_i, .rst_i,
    .valid_i(levels_valid), .ready_o(levels_ready), .data_i(beat),
    .valid_o(filter_valid_o), .ready_i(filter_ready_i), .data_o(filter_o)
  );
endmodule

`default_nettype wire
