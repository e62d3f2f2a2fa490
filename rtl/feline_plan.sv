// SPDX-License-Identifier: Apache-2.0
// plan: radii to probe count, level of detail, step vector and weight row.
//
// Takes  major_u, major_v S8.8, major_radius, minor_radius U8.7, texel * 2^exponent; the sampler state.
// Gives  probes 1 .. 16; half_step_s, half_step_t S19.24 textures, half the distance of two probes; weight_row;
//        level_of_detail U4.8, biased and clamped; linear: whether texels are interpolated.
// Rounds length and blur factors, the widened radius: nearest, ties up. The radius whose log2 is taken: nearest, ties
//        up, to 9 significant bits; log2 of it: to nearest. (major - minor)/major: down to 12 bits. (major -
//        minor)/major/(probes - 1): nearest, ties up, to 16 bits. Half step: nearest, ties away from zero, once.
// Edges  A radius below one texel is one texel; when the major one is, too, there is one probe, and the level of detail
//        is that of the major radius, below 0, as a bias needs it. A footprint wider than the 1 x 1 level takes one
//        probe. Level of detail before the bias saturates at -32 and 31.996. minor_radius 0 means max_probes.
// Source WRL 99/1, 3.1, 3.2, 3.4; EXT_texture_filter_anisotropic (ext); Vulkan 1.3, 16.8 (bias, clamp, magnification).
//        The weight row's rule is model/plan.h's.
// Takes five steps: clamp the radii | choose the probes | fit the radius | level and line | half step.
`default_nettype none

module feline_plan (
  input  wire logic                   clk_i,
  input  wire logic                   rst_i,
  input  wire feline_pkg::sampler_t   sampler_i,
  input  wire logic                   footprint_valid_i,
  output logic                        footprint_ready_o,
  input  wire feline_pkg::footprint_t footprint_i,
  output logic                        plan_valid_o,
  input  wire logic                   plan_ready_i,
  output feline_pkg::plan_t           plan_o
);
  localparam int unsigned RadiusWidth     = feline_pkg::RadiusWidth;
  localparam int unsigned VectorWidth     = feline_pkg::VectorWidth;
  localparam int unsigned ExponentWidth   = feline_pkg::ExponentWidth;
  localparam int unsigned ProbeCountWidth = feline_pkg::ProbeCountWidth;
  localparam int unsigned LineWidth       = feline_pkg::LineFractionWidth;
  localparam int unsigned LevelWidth      = feline_pkg::LevelOfDetailWidth;
  localparam int unsigned DividendWidth   = RadiusWidth + feline_pkg::FactorWidth + 1 - feline_pkg::FactorFraction;
  localparam int unsigned EighthsWidth    = $clog2(4 * feline_pkg::MaxProbes + 8);
  localparam int unsigned ProductWidth    = VectorWidth + feline_pkg::SizeReciprocalWidth;
  localparam bit          AnyFeline       = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;
  localparam bit          AnyLine         = feline_pkg::FeatureExt || AnyFeline;

  // What every step hands on.
  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]             tag;
    logic [feline_pkg::StatusWidth-1:0]          status;
    logic signed [feline_pkg::PositionWidth-1:0] s;
    logic signed [feline_pkg::PositionWidth-1:0] t;
    logic signed [ExponentWidth-1:0]             exponent;
  } place_t;
  typedef struct packed {
    logic signed [VectorWidth-1:0] u;
    logic signed [VectorWidth-1:0] v;
    logic [RadiusWidth-1:0]        radius;
  } axis_t;
  typedef struct packed {
    place_t                   place;
    axis_t                    axis;
    logic                     magnified;
    logic [RadiusWidth-1:0]   major;
    logic [RadiusWidth-1:0]   minor;
    logic [DividendWidth-1:0] dividend;
  } radii_t;
  typedef struct packed {
    place_t                     place;
    axis_t                      axis;
    logic [RadiusWidth-1:0]     major;
    logic [RadiusWidth-1:0]     minor;
    logic [ProbeCountWidth-1:0] probes;
    logic                       limited;
    logic [EighthsWidth-1:0]    eighths;
  } choice_t;
  typedef struct packed {
    place_t                     place;
    axis_t                      axis;
    logic [RadiusWidth-1:0]     major;
    logic [RadiusWidth-1:0]     fitted;
    logic [ProbeCountWidth-1:0] probes;
    logic [EighthsWidth-1:0]    eighths;
  } fitted_t;
  typedef struct packed {
    place_t                         place;
    logic signed [ProductWidth-1:0] product_s;
    logic signed [ProductWidth-1:0] product_t;
    logic [LineWidth-1:0]           line;
    logic signed [LevelWidth-1:0]   base_level;
    logic [ProbeCountWidth-1:0]     probes;
    logic [EighthsWidth-1:0]        eighths;
  } level_t;

  logic [feline_pkg::ModeWidth-1:0] mode;

  feline_supported_mode u_supported_mode (.mode_i(sampler_i.mode), .mode_o(mode));

  // Clamp the radii.
  radii_t radii_d;
  place_t place;
  axis_t  axis;

  assign place.tag      = footprint_i.tag;
  assign place.status   = footprint_i.status;
  assign place.s        = footprint_i.s;
  assign place.t        = footprint_i.t;
  assign place.exponent = footprint_i.exponent;
  assign axis.u         = footprint_i.major_u;
  assign axis.v         = footprint_i.major_v;
  assign axis.radius    = footprint_i.major_radius;
  assign radii_d.place  = place;
  assign radii_d.axis   = axis;

  feline_clamp_radii u_clamp_radii (
    .major_radius_i (footprint_i.major_radius),
    .minor_radius_i (footprint_i.minor_radius),
    .exponent_i     (footprint_i.exponent),
    .mode_i         (mode),
    .length_factor_i(sampler_i.length_factor),
    .magnified_o    (radii_d.magnified),
    .major_o        (radii_d.major),
    .minor_o        (radii_d.minor)
  );
  feline_probe_dividend #(.DividendWidth(DividendWidth)) u_probe_dividend (
    .major_i       (radii_d.major),
    .minor_i       (radii_d.minor),
    .mode_i        (mode),
    .probe_factor_i(sampler_i.probe_factor),
    .dividend_o    (radii_d.dividend)
  );

  logic   radii_valid;
  logic   radii_ready;
  radii_t radii_q;

  feline_stream_register #(.Width($bits(radii_d))) u_radii_register (
    .clk_i,
    .rst_i,
    .valid_i(footprint_valid_i),
    .ready_o(footprint_ready_o),
    .data_i (radii_d),
    .valid_o(radii_valid),
    .ready_i(radii_ready),
    .data_o (radii_q)
  );

  // Choose the probes.
  choice_t choice_d;

  assign choice_d.place = radii_q.place;
  assign choice_d.axis  = radii_q.axis;
  assign choice_d.major = radii_q.major;
  assign choice_d.minor = radii_q.minor;

  feline_choose_probes #(
    .DividendWidth(DividendWidth),
    .EighthsWidth (EighthsWidth)
  ) u_choose_probes (
    .magnified_i     (radii_q.magnified),
    .major_i         (radii_q.major),
    .minor_i         (radii_q.minor),
    .dividend_i      (radii_q.dividend),
    .mode_i          (mode),
    .probe_rounding_i(sampler_i.probe_rounding),
    .max_probes_i    (sampler_i.max_probes),
    .probes_o        (choice_d.probes),
    .limited_o       (choice_d.limited),
    .eighths_o       (choice_d.eighths)
  );

  logic    choice_valid;
  logic    choice_ready;
  choice_t choice_q;

  feline_stream_register #(.Width($bits(choice_d))) u_choice_register (
    .clk_i,
    .rst_i,
    .valid_i(radii_valid),
    .ready_o(radii_ready),
    .data_i (choice_d),
    .valid_o(choice_valid),
    .ready_i(choice_ready),
    .data_o (choice_q)
  );

  // Fit the radius.
  fitted_t fitted_d;

  assign fitted_d.place   = choice_q.place;
  assign fitted_d.axis    = choice_q.axis;
  assign fitted_d.major   = choice_q.major;
  assign fitted_d.probes  = choice_q.probes;
  assign fitted_d.eighths = choice_q.eighths;

  feline_fit_radius u_fit_radius (
    .major_i               (choice_q.major),
    .minor_i               (choice_q.minor),
    .probes_i              (choice_q.probes),
    .limited_i             (choice_q.limited),
    .mode_i                (mode),
    .probe_rounding_i      (sampler_i.probe_rounding),
    .blur_factor_i         (sampler_i.blur_factor),
    .inverse_alias_factor_i(sampler_i.inverse_alias_factor),
    .fitted_o              (fitted_d.fitted)
  );

  logic    fitted_valid;
  logic    fitted_ready;
  fitted_t fitted_q;

  feline_stream_register #(.Width($bits(fitted_d))) u_fitted_register (
    .clk_i,
    .rst_i,
    .valid_i(choice_valid),
    .ready_o(choice_ready),
    .data_i (fitted_d),
    .valid_o(fitted_valid),
    .ready_i(fitted_ready),
    .data_o (fitted_q)
  );

  // Level and line.
  level_t                       level_d;
  logic signed [LevelWidth-1:0] base_level;
  logic                         beyond_smallest;

  feline_level_of_radius u_level_of_radius (
    .radius_i  (fitted_q.fitted),
    .exponent_i(fitted_q.place.exponent),
    .level_o   (base_level)
  );

  assign beyond_smallest =
      base_level > $signed(LevelWidth'({sampler_i.smallest_level, {feline_pkg::LevelOfDetailFraction{1'b0}}}));

  assign level_d.place      = fitted_q.place;
  assign level_d.base_level = base_level;
  assign level_d.probes     = beyond_smallest ? ProbeCountWidth'(1) : fitted_q.probes;
  assign level_d.eighths    = fitted_q.eighths;

  if (AnyLine) begin : gen_product
    assign level_d.product_s = ProductWidth'($signed(fitted_q.axis.u)) *
                               $signed(ProductWidth'(sampler_i.width_reciprocal));
    assign level_d.product_t = ProductWidth'($signed(fitted_q.axis.v)) *
                               $signed(ProductWidth'(sampler_i.height_reciprocal));
  end else begin : gen_no_product
    assign level_d.product_s = '0;
    assign level_d.product_t = '0;
  end

  if (AnyFeline) begin : gen_line
    logic [RadiusWidth-1:0] rest;

    assign rest = fitted_q.major - fitted_q.fitted;

    feline_quotient #(
      .NumeratorWidth  (RadiusWidth + feline_pkg::LineFractionFraction),
      .DenominatorWidth(RadiusWidth),
      .QuotientWidth   (LineWidth)
    ) u_line (
      .numerator_i  ({rest, {feline_pkg::LineFractionFraction{1'b0}}}),
      .denominator_i(fitted_q.axis.radius),
      .quotient_o   (level_d.line)
    );
  end else begin : gen_no_line
    assign level_d.line = '0;
  end

  logic unused_fitted;
  assign unused_fitted = ^fitted_q;

  logic   level_valid;
  logic   level_ready;
  level_t level_q;

  feline_stream_register #(.Width($bits(level_d))) u_level_register (
    .clk_i,
    .rst_i,
    .valid_i(fitted_valid),
    .ready_o(fitted_ready),
    .data_i (level_d),
    .valid_o(level_valid),
    .ready_i(level_ready),
    .data_o (level_q)
  );

  // Half step.
  feline_pkg::plan_t plan_d;

  assign plan_d.tag    = level_q.place.tag;
  assign plan_d.status = level_q.place.status;
  assign plan_d.s      = level_q.place.s;
  assign plan_d.t      = level_q.place.t;
  assign plan_d.probes = level_q.probes;

  feline_sampled_level u_sampled_level (
    .base_level_i     (level_q.base_level),
    .level_bias_i     (sampler_i.level_bias),
    .min_level_i      (sampler_i.min_level),
    .max_level_i      (sampler_i.max_level),
    .last_level_i     (sampler_i.last_level),
    .mode_i           (mode),
    .magnify_i        (sampler_i.magnify),
    .level_of_detail_o(plan_d.level_of_detail),
    .linear_o         (plan_d.linear)
  );
  feline_choose_weight_row #(.EighthsWidth(EighthsWidth)) u_choose_weight_row (
    .mode_i      (mode),
    .probes_i    (level_q.probes),
    .eighths_i   (level_q.eighths),
    .weight_row_o(plan_d.weight_row)
  );

  if (AnyLine) begin : gen_half_step
    logic [feline_pkg::ReciprocalWidth-1:0] factor;

    feline_half_step_factor u_half_step_factor (
      .mode_i  (mode),
      .probes_i(level_q.probes),
      .line_i  (level_q.line),
      .factor_o(factor)
    );
    feline_half_step #(.ProductWidth(ProductWidth)) u_half_step_s (
      .product_i   (level_q.product_s),
      .factor_i    (factor),
      .size_shift_i(sampler_i.width_shift),
      .exponent_i  (level_q.place.exponent),
      .half_step_o (plan_d.half_step_s)
    );
    feline_half_step #(.ProductWidth(ProductWidth)) u_half_step_t (
      .product_i   (level_q.product_t),
      .factor_i    (factor),
      .size_shift_i(sampler_i.height_shift),
      .exponent_i  (level_q.place.exponent),
      .half_step_o (plan_d.half_step_t)
    );
  end else begin : gen_no_half_step
    assign plan_d.half_step_s = '0;
    assign plan_d.half_step_t = '0;
  end

  logic unused_level;
  assign unused_level = ^level_q;

  feline_stream_register #(.Width($bits(plan_d))) u_plan_register (
    .clk_i,
    .rst_i,
    .valid_i(level_valid),
    .ready_o(level_ready),
    .data_i (plan_d),
    .valid_o(plan_valid_o),
    .ready_i(plan_ready_i),
    .data_o (plan_o)
  );

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;
endmodule

`default_nettype wire
