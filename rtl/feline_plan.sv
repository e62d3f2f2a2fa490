// SPDX-License-Identifier: Apache-2.0
// plan: radii to probe count, level of detail, step vector and weight row.
//
// Takes  major_u, major_v S8.8, major_radius, minor_radius U8.7, texel * 2^exponent, as footprint makes them: minor
//        <= major, and major is 0 or at least 64; the sampler state.
// Gives  probes 1 .. 16; half_step_s, half_step_t S19.24 textures, half the distance of two probes; weight_row;
//        level_of_detail U4.8, biased and clamped; linear: whether texels are interpolated, which the magnification
//        filter decides where the biased and clamped level is 0, however many probes there are.
// Rounds length and blur factors, the widened radius: nearest, ties up. Division by a count: product with the nearest
//        16-bit reciprocal (reciprocal ROM). The radius whose log2 is taken: nearest, ties up, to 9 significant bits;
//        log2 of it: to nearest. (major - minor) over the major radius before lengthFactor: down to 12 bits; that over
//        probes - 1: nearest, ties up, to 16 bits. ext: half of 1/(probes + 1), nearest, ties up, to 16 bits. Half
//        step: nearest, ties away from zero, once.
// Edges  A radius below one texel is one texel; when the major one is, too, there is one probe, and the level of detail
//        is that of the major radius, below 0, as a bias needs it. ext just above one texel takes two probes, each at
//        level 0. A footprint wider than the 1 x 1 level takes one probe. Level of detail before the bias saturates at
//        -32 and 31.996. minor_radius 0 means max_probes.
// Source WRL 99/1, 3.1, 3.2, 3.4; EXT_texture_filter_anisotropic (ext); Vulkan 1.3, 16.8 (bias, clamp, magnification).
//        Weight row: fProbes in quarters (a row stands for its middle, a whole row for itself), kept within the four
//        rows of its probe count. The printed rule, the smaller of fProbes and iProbes, meets the row of one probe less
//        when 3.4's ceiling rounds up by more than 3/4.
// Timing five registers: clamp the radii | choose the probes | fit the radius (feline_count_probes) | level and line | half
//        step (feline_plan_level_step).
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

  // What the second half needs of the footprint.
  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]             tag;
    logic [feline_pkg::StatusWidth-1:0]          status;
    logic signed [feline_pkg::PositionWidth-1:0] s;
    logic signed [feline_pkg::PositionWidth-1:0] t;
    logic signed [feline_pkg::ExponentWidth-1:0] exponent;
    logic signed [feline_pkg::VectorWidth-1:0]   major_u;
    logic signed [feline_pkg::VectorWidth-1:0]   major_v;
    logic [feline_pkg::RadiusWidth-1:0]          major_radius;
  } sideband_t;

  logic [feline_pkg::ModeWidth-1:0]       mode;
  sideband_t                              sideband_d;
  sideband_t                              sideband_q;
  logic                                   count_valid;
  logic                                   count_ready;
  logic [feline_pkg::RadiusWidth-1:0]     major;
  logic [feline_pkg::RadiusWidth-1:0]     fitted;
  logic [feline_pkg::ProbeCountWidth-1:0] probes;
  logic                                   limited;
  logic [feline_pkg::EighthsWidth-1:0]    eighths;

  feline_supported_mode u_supported_mode (.mode_i(sampler_i.mode), .mode_o(mode));

  assign sideband_d.tag          = footprint_i.tag;
  assign sideband_d.status       = footprint_i.status;
  assign sideband_d.s            = footprint_i.s;
  assign sideband_d.t            = footprint_i.t;
  assign sideband_d.exponent     = footprint_i.exponent;
  assign sideband_d.major_u      = footprint_i.major_u;
  assign sideband_d.major_v      = footprint_i.major_v;
  assign sideband_d.major_radius = footprint_i.major_radius;

  feline_count_probes #(.SidebandWidth($bits(sideband_d))) u_count_probes (
    .clk_i, .rst_i, .sampler_i, .mode_i(mode),
    .footprint_valid_i, .footprint_ready_o,
    .sideband_i(sideband_d), .exponent_i(footprint_i.exponent),
    .major_radius_i(footprint_i.major_radius), .minor_radius_i(footprint_i.minor_radius),
    .count_valid_o(count_valid), .count_ready_i(count_ready),
    .sideband_o(sideband_q), .major_o(major), .fitted_o(fitted), .probes_o(probes), .limited_o(limited),
    .eighths_o(eighths)
  );

  feline_plan_level_step u_level_step (
    .clk_i, .rst_i, .sampler_i, .mode_i(mode),
    .count_valid_i(count_valid), .count_ready_o(count_ready),
    .tag_i(sideband_q.tag), .status_i(sideband_q.status), .s_i(sideband_q.s), .t_i(sideband_q.t),
    .exponent_i(sideband_q.exponent), .major_u_i(sideband_q.major_u), .major_v_i(sideband_q.major_v),
    .major_radius_i(sideband_q.major_radius), .major_i(major), .fitted_i(fitted), .probes_i(probes),
    .limited_i(limited), .eighths_i(eighths),
    .plan_valid_o, .plan_ready_i, .plan_o
  );
endmodule

`default_nettype wire
