// SPDX-License-Identifier: Apache-2.0
// The second half of plan: probes and their radius to level of detail, step vector and weight row (model/plan.h).
//
// Takes  the footprint's place, exponent, major vector S8.8 and radius; major, fitted U8.7, probes and eighths
//        (feline_count_probes); the mode, a supported one; the sampler state.
// Gives  the plan.
// Timing two registers: level and line | half step. Each leaf says how it rounds.
// Source WRL 99/1, 3.1, 3.2, 3.4; Vulkan 1.3, 16.8 (bias, clamp, magnification).
`default_nettype none

module feline_plan_level_step (
  input  wire logic                                        clk_i,
  input  wire logic                                        rst_i,
  input  wire feline_pkg::sampler_t                        sampler_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]            mode_i,
  input  wire logic                                        count_valid_i,
  output logic                                             count_ready_o,
  input  wire logic [feline_pkg::TagWidth-1:0]             tag_i,
  input  wire logic [feline_pkg::StatusWidth-1:0]          status_i,
  input  wire logic signed [feline_pkg::PositionWidth-1:0] s_i,
  input  wire logic signed [feline_pkg::PositionWidth-1:0] t_i,
  input  wire logic signed [feline_pkg::ExponentWidth-1:0] exponent_i,
  input  wire logic signed [feline_pkg::VectorWidth-1:0]   major_u_i,
  input  wire logic signed [feline_pkg::VectorWidth-1:0]   major_v_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          major_radius_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          fitted_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0]      probes_i,
  input  wire logic                                        limited_i,
  input  wire logic [feline_pkg::EighthsWidth-1:0]         eighths_i,
  output logic                                             plan_valid_o,
  input  wire logic                                        plan_ready_i,
  output feline_pkg::plan_t                                plan_o
);
  localparam int unsigned ProbeCountWidth = feline_pkg::ProbeCountWidth;
  localparam int unsigned LineWidth       = feline_pkg::LineFractionWidth;
  localparam int unsigned LevelWidth      = feline_pkg::LevelOfDetailWidth;
  localparam int unsigned ProductWidth    = feline_pkg::VectorWidth + feline_pkg::SizeReciprocalWidth;
  localparam bit          AnyFeline       = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;
  localparam bit          AnyLine         = feline_pkg::FeatureExt || AnyFeline;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]             tag;
    logic [feline_pkg::StatusWidth-1:0]          status;
    logic signed [feline_pkg::PositionWidth-1:0] s;
    logic signed [feline_pkg::PositionWidth-1:0] t;
    logic signed [feline_pkg::ExponentWidth-1:0] exponent;
    logic signed [ProductWidth-1:0]              product_s;
    logic signed [ProductWidth-1:0]              product_t;
    logic [LineWidth-1:0]                        line;
    logic signed [LevelWidth-1:0]                base_level;
    logic [ProbeCountWidth-1:0]                  probes;
    logic [feline_pkg::EighthsWidth-1:0]         eighths;
  } level_t;

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;

  // Level and line.
  level_t                             level_d;
  level_t                             level_q;
  logic                               level_valid;
  logic                               level_ready;
  logic signed [LevelWidth-1:0]       base_level;
  logic                               beyond_smallest;
  logic [feline_pkg::StatusWidth-1:0] level_status;

  feline_level_of_radius u_level_of_radius (.radius_i(fitted_i), .exponent_i, .level_o(base_level));

  always_comb begin
    level_status = status_i;
    level_status[feline_pkg::StatusUnsupported] =
        level_status[feline_pkg::StatusUnsupported] | (limited_i && sampler_i.probes_cut);
  end

  assign beyond_smallest =
      base_level > $signed(LevelWidth'({sampler_i.smallest_level, {feline_pkg::LevelOfDetailFraction{1'b0}}}));

  assign level_d.tag        = tag_i;
  assign level_d.status     = level_status;
  assign level_d.s          = s_i;
  assign level_d.t          = t_i;
  assign level_d.exponent   = exponent_i;
  assign level_d.base_level = base_level;
  assign level_d.probes     = beyond_smallest ? ProbeCountWidth'(1) : probes_i;
  assign level_d.eighths    = eighths_i;

  if (AnyLine) begin : gen_product
    feline_texture_product u_texture_product_s (
      .vector_i(major_u_i), .reciprocal_i(sampler_i.width_reciprocal), .product_o(level_d.product_s)
    );
    feline_texture_product u_texture_product_t (
      .vector_i(major_v_i), .reciprocal_i(sampler_i.height_reciprocal), .product_o(level_d.product_t)
    );
  end else begin : gen_no_product
    assign level_d.product_s = '0;
    assign level_d.product_t = '0;

    logic unused_vector;
    assign unused_vector = ^{major_u_i, major_v_i};
  end

  if (AnyFeline) begin : gen_line
    feline_line_fraction u_line_fraction (.major_i, .fitted_i, .major_radius_i, .line_o(level_d.line));
  end else begin : gen_no_line
    assign level_d.line = '0;

    logic unused_radii;
    assign unused_radii = ^{major_i, major_radius_i};
  end

  feline_stream_register #(.Width($bits(level_d))) u_level (
    .clk_i, .rst_i,
    .valid_i(count_valid_i), .ready_o(count_ready_o), .data_i(level_d),
    .valid_o(level_valid), .ready_i(level_ready), .data_o(level_q)
  );

  // Half step.
  feline_pkg::plan_t                  plan_d;
  logic                               level_missing;
  logic [feline_pkg::StatusWidth-1:0] plan_status;

  always_comb begin
    plan_status = level_q.status;
    plan_status[feline_pkg::StatusUnsupported] = plan_status[feline_pkg::StatusUnsupported] | level_missing;
  end

  assign plan_d.tag    = level_q.tag;
  assign plan_d.status = plan_status;
  assign plan_d.s      = level_q.s;
  assign plan_d.t      = level_q.t;
  assign plan_d.probes = level_q.probes;

  feline_sampled_level u_sampled_level (
    .base_level_i(level_q.base_level), .level_bias_i(sampler_i.level_bias), .min_level_i(sampler_i.min_level),
    .max_level_i(sampler_i.max_level), .last_level_i(sampler_i.last_level), .levels_cut_i(sampler_i.levels_cut), .mode_i,
    .magnify_i(sampler_i.magnify), .missing_o(level_missing),
    .level_of_detail_o(plan_d.level_of_detail), .linear_o(plan_d.linear)
  );
  feline_choose_weight_row u_choose_weight_row (
    .mode_i, .probes_i(level_q.probes), .eighths_i(level_q.eighths), .weight_row_o(plan_d.weight_row)
  );

  if (AnyLine) begin : gen_half_step
    logic [feline_pkg::ReciprocalWidth-1:0] factor;

    feline_half_step_factor u_half_step_factor (
      .mode_i, .probes_i(level_q.probes), .line_i(level_q.line), .factor_o(factor)
    );
    feline_half_step #(.ProductWidth(ProductWidth)) u_half_step_s (
      .product_i(level_q.product_s), .factor_i(factor), .size_shift_i(sampler_i.width_shift),
      .exponent_i(level_q.exponent), .half_step_o(plan_d.half_step_s)
    );
    feline_half_step #(.ProductWidth(ProductWidth)) u_half_step_t (
      .product_i(level_q.product_t), .factor_i(factor), .size_shift_i(sampler_i.height_shift),
      .exponent_i(level_q.exponent), .half_step_o(plan_d.half_step_t)
    );
  end else begin : gen_no_half_step
    assign plan_d.half_step_s = '0;
    assign plan_d.half_step_t = '0;

    logic unused_level;
    assign unused_level = ^{level_q.product_s, level_q.product_t, level_q.line, level_q.exponent};
  end

  feline_stream_register #(.Width($bits(plan_d))) u_output (
    .clk_i, .rst_i,
    .valid_i(level_valid), .ready_o(level_ready), .data_i(plan_d),
    .valid_o(plan_valid_o), .ready_i(plan_ready_i), .data_o(plan_o)
  );
endmodule

`default_nettype wire
