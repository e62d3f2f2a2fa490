// SPDX-License-Identifier: Apache-2.0
// The minor radius that fits the probe count, which sets the level of detail (fit_minor_radius of model/plan.h).
//
// Takes  major, minor U8.7 (feline_clamp_radii); probes and limited (feline_choose_probes); the mode, a supported one;
//        probe_rounding; blur_factor U1.8, >= 1; inverse_alias_factor U1.8, <= 1.
// Gives  fitted U8.7, at most the major radius. ext: major/probes. Feline: widened = 2 major/(probes + 1); to nearest:
//        the larger of it and minor; ceiling: the smaller of it and the blurred minor, or, limited, it aliased.
// Rounds each product: nearest, ties up.
// Edges  A magnified radius, which has one probe, comes out as it is.
// Source WRL 99/1, 3.1, 3.4; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_fit_radius (
  input  wire logic [feline_pkg::RadiusWidth-1:0]     major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]     minor_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0] probes_i,
  input  wire logic                                   limited_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]       mode_i,
  input  wire logic                                   probe_rounding_i,
  input  wire logic [feline_pkg::FactorWidth-1:0]     blur_factor_i,
  input  wire logic [feline_pkg::FactorWidth-1:0]     inverse_alias_factor_i,
  output logic [feline_pkg::RadiusWidth-1:0]          fitted_o
);
  localparam int unsigned RadiusWidth        = feline_pkg::RadiusWidth;
  localparam int unsigned ReciprocalWidth    = feline_pkg::ReciprocalWidth;
  localparam int unsigned ReciprocalFraction = feline_pkg::ReciprocalFraction;
  localparam int unsigned ReciprocalIndexWidth = $clog2(feline_pkg::MaxProbes + 2);
  localparam int unsigned WidenedWidth       = RadiusWidth + 1 + ReciprocalWidth;
  localparam int unsigned FactoredWidth      = RadiusWidth + feline_pkg::FactorWidth;
  localparam int unsigned FactorFraction     = feline_pkg::FactorFraction;
  localparam bit          AnyFeline = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  if (feline_pkg::FeatureExt || AnyFeline) begin : gen_widened
    logic                            is_ext;
    logic [ReciprocalIndexWidth-1:0] parts;
    logic [RadiusWidth:0]            dividend;
    logic [ReciprocalWidth-1:0]      reciprocal;
    logic [WidenedWidth-1:0]         product;
    logic [RadiusWidth-1:0]          widened;

    // Without Feline, the isotropic modes have one probe and are ext with one probe.
    assign is_ext   = !AnyFeline || (feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt);
    assign parts    = is_ext ? ReciprocalIndexWidth'(probes_i) : ReciprocalIndexWidth'(probes_i) + 1'b1;
    assign dividend = is_ext ? {1'b0, major_i} : {major_i, 1'b0};

    feline_rom_reciprocal u_rom_reciprocal (.index_i(parts), .data_o(reciprocal));

    assign product = WidenedWidth'(dividend) * WidenedWidth'(reciprocal) +
                     (WidenedWidth'(1) << (ReciprocalFraction - 1));
    assign widened = product[ReciprocalFraction +: RadiusWidth];

    logic unused_product;
    assign unused_product = ^product;

    if (AnyFeline) begin : gen_fitted
      logic [RadiusWidth-1:0] nearest;

      assign nearest = minor_i > widened ? minor_i : widened;

      if (feline_pkg::FeatureFactors) begin : gen_factors
        logic [FactoredWidth-1:0] aliased;
        logic [FactoredWidth-1:0] blurred;

        assign aliased = (FactoredWidth'(widened) * FactoredWidth'(inverse_alias_factor_i) +
                          (FactoredWidth'(1) << (FactorFraction - 1))) >> FactorFraction;
        assign blurred = (FactoredWidth'(minor_i) * FactoredWidth'(blur_factor_i) +
                          (FactoredWidth'(1) << (FactorFraction - 1))) >> FactorFraction;

        always_comb begin
          if (is_ext) begin
            fitted_o = widened;
          end else if (probe_rounding_i == feline_pkg::ProbeRoundingNearest) begin
            fitted_o = nearest;
          end else if (limited_i) begin
            fitted_o = aliased[RadiusWidth-1:0];
          end else begin
            fitted_o = FactoredWidth'(widened) < blurred ? widened : blurred[RadiusWidth-1:0];
          end
        end

        logic unused_aliased;
        assign unused_aliased = ^aliased;
      end else begin : gen_exact
        assign fitted_o = is_ext ? widened : nearest;

        logic unused_factors;
        assign unused_factors = ^{limited_i, probe_rounding_i, blur_factor_i, inverse_alias_factor_i};
      end
    end else begin : gen_ext_only
      assign fitted_o = widened;

      logic unused_inputs;
      assign unused_inputs = ^{minor_i, limited_i, mode_i, probe_rounding_i, blur_factor_i, inverse_alias_factor_i};
    end
  end else begin : gen_isotropic
    assign fitted_o = major_i;

    logic unused_inputs;
    assign unused_inputs =
        ^{minor_i, probes_i, limited_i, mode_i, probe_rounding_i, blur_factor_i, inverse_alias_factor_i};
  end
endmodule

`default_nettype wire
