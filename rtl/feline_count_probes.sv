// SPDX-License-Identifier: Apache-2.0
// The first half of plan: a footprint's radii to a probe count and the minor radius that fits it (model/plan.h).
//
// Takes  major_radius, minor_radius U8.7, exponent; the mode, a supported one; the sampler state; what travels along.
// Gives  major, the radius clamped and shortened, and fitted, the minor radius that fits the count, U8.7; probes;
//        eighths, floor(8 major/minor), which picks the weight row; what travelled along.
// Timing three registers: clamp the radii | choose the probes | fit the radius. Each leaf says how it rounds.
// Source WRL 99/1, 3.1, 3.4; EXT_texture_filter_anisotropic (ext).
`default_nettype none

module feline_count_probes #(
  parameter int unsigned SidebandWidth = 1
) (
  input  wire logic                                        clk_i,
  input  wire logic                                        rst_i,
  input  wire feline_pkg::sampler_t                        sampler_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]            mode_i,
  input  wire logic                                        footprint_valid_i,
  output logic                                             footprint_ready_o,
  input  wire logic [SidebandWidth-1:0]                    sideband_i,
  input  wire logic signed [feline_pkg::ExponentWidth-1:0] exponent_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          major_radius_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          minor_radius_i,
  output logic                                             count_valid_o,
  input  wire logic                                        count_ready_i,
  output logic [SidebandWidth-1:0]                         sideband_o,
  output logic [feline_pkg::RadiusWidth-1:0]               major_o,
  output logic [feline_pkg::RadiusWidth-1:0]               fitted_o,
  output logic [feline_pkg::ProbeCountWidth-1:0]           probes_o,
  output logic                                             limited_o,
  output logic [feline_pkg::EighthsWidth-1:0]              eighths_o
);
  localparam int unsigned RadiusWidth     = feline_pkg::RadiusWidth;
  localparam int unsigned ProbeCountWidth = feline_pkg::ProbeCountWidth;

  typedef struct packed {
    logic [SidebandWidth-1:0]             sideband;
    logic                                 magnified;
    logic [RadiusWidth-1:0]               major;
    logic [RadiusWidth-1:0]               minor;
    logic [feline_pkg::DividendWidth-1:0] dividend;
  } radii_t;
  typedef struct packed {
    logic [SidebandWidth-1:0]            sideband;
    logic [RadiusWidth-1:0]              major;
    logic [RadiusWidth-1:0]              minor;
    logic [ProbeCountWidth-1:0]          probes;
    logic                                limited;
    logic [feline_pkg::EighthsWidth-1:0] eighths;
  } choice_t;
  typedef struct packed {
    logic [SidebandWidth-1:0]            sideband;
    logic [RadiusWidth-1:0]              major;
    logic [RadiusWidth-1:0]              fitted;
    logic [ProbeCountWidth-1:0]          probes;
    logic                                limited;
    logic [feline_pkg::EighthsWidth-1:0] eighths;
  } count_t;

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;

  // Clamp the radii.
  radii_t radii_d;
  radii_t radii_q;
  logic   radii_valid;
  logic   radii_ready;

  assign radii_d.sideband = sideband_i;

  feline_clamp_radii u_clamp_radii (
    .major_radius_i, .minor_radius_i, .exponent_i, .mode_i, .length_factor_i(sampler_i.length_factor),
    .magnified_o(radii_d.magnified), .major_o(radii_d.major), .minor_o(radii_d.minor)
  );
  feline_probe_dividend u_probe_dividend (
    .major_i(radii_d.major), .minor_i(radii_d.minor), .mode_i, .probe_factor_i(sampler_i.probe_factor),
    .dividend_o(radii_d.dividend)
  );

  feline_stream_register #(.Width($bits(radii_d))) u_radii (
    .clk_i, .rst_i,
    .valid_i(footprint_valid_i), .ready_o(footprint_ready_o), .data_i(radii_d),
    .valid_o(radii_valid), .ready_i(radii_ready), .data_o(radii_q)
  );

  // Choose the probes.
  choice_t choice_d;
  choice_t choice_q;
  logic    choice_valid;
  logic    choice_ready;

  assign choice_d.sideband = radii_q.sideband;
  assign choice_d.major   = radii_q.major;
  assign choice_d.minor   = radii_q.minor;

  feline_choose_probes u_choose_probes (
    .magnified_i(radii_q.magnified), .major_i(radii_q.major), .minor_i(radii_q.minor), .dividend_i(radii_q.dividend),
    .mode_i, .probe_rounding_i(sampler_i.probe_rounding), .max_probes_i(sampler_i.max_probes),
    .probes_o(choice_d.probes), .limited_o(choice_d.limited), .eighths_o(choice_d.eighths)
  );

  feline_stream_register #(.Width($bits(choice_d))) u_choice (
    .clk_i, .rst_i,
    .valid_i(radii_valid), .ready_o(radii_ready), .data_i(choice_d),
    .valid_o(choice_valid), .ready_i(choice_ready), .data_o(choice_q)
  );

  // Fit the radius.
  count_t count_d;
  count_t count_q;

  assign count_d.sideband = choice_q.sideband;
  assign count_d.major   = choice_q.major;
  assign count_d.probes  = choice_q.probes;
  assign count_d.limited = choice_q.limited;
  assign count_d.eighths = choice_q.eighths;

  feline_fit_radius u_fit_radius (
    .major_i(choice_q.major), .minor_i(choice_q.minor), .probes_i(choice_q.probes), .limited_i(choice_q.limited),
    .mode_i, .probe_rounding_i(sampler_i.probe_rounding), .blur_factor_i(sampler_i.blur_factor),
    .inverse_alias_factor_i(sampler_i.inverse_alias_factor), .fitted_o(count_d.fitted)
  );

  feline_stream_register #(.Width($bits(count_d))) u_count (
    .clk_i, .rst_i,
    .valid_i(choice_valid), .ready_o(choice_ready), .data_i(count_d),
    .valid_o(count_valid_o), .ready_i(count_ready_i), .data_o(count_q)
  );

  assign sideband_o = count_q.sideband;
  assign major_o   = count_q.major;
  assign fitted_o  = count_q.fitted;
  assign probes_o  = count_q.probes;
  assign limited_o = count_q.limited;
  assign eighths_o = count_q.eighths;
endmodule

`default_nettype wire
