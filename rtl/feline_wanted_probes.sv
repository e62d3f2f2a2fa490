// SPDX-License-Identifier: Apache-2.0
// The number of probes that a footprint wants, before any limit (wanted_probes of model/plan.h).
//
// Takes  major, minor U8.7, major >= minor (feline_clamp_radii); dividend (feline_probe_dividend); the mode, a supported
//        one; probe_rounding.
// Gives  wanted, saturated above max_probes; eighths: floor(8 major / minor), which picks the weight row, saturated
//        where that no longer matters.
// Rounds ext: major/minor up. Feline: 2 major/minor - 1 to nearest, ties up; or 2 f major/minor - 1 up.
// Edges  minor 0 saturates both. Of 2 f major/minor - 1 up 0 can be left, which stands for one probe.
// Source WRL 99/1, 3.1, 3.4; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_wanted_probes #(
  // Counts up to max_probes + 1: the quotients saturate at one too many or above.
  localparam int unsigned WantedWidth = $clog2(feline_pkg::MaxProbes + 2)
) (
  input  wire logic [feline_pkg::RadiusWidth-1:0]   major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]   minor_i,
  input  wire logic [feline_pkg::DividendWidth-1:0] dividend_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]     mode_i,
  input  wire logic                                 probe_rounding_i,
  output logic [WantedWidth-1:0]                    wanted_o,
  output logic [feline_pkg::EighthsWidth-1:0]       eighths_o
);
  localparam int unsigned RadiusWidth = feline_pkg::RadiusWidth;
  localparam bit          AnyFeline   = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  logic                   is_ext;
  logic [WantedWidth-1:0] ceiling;

  assign is_ext = feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt;

  if (feline_pkg::FeatureExt || (AnyFeline && feline_pkg::FeatureFactors)) begin : gen_ceiling
    feline_quotient #(
      .NumeratorWidth  (feline_pkg::DividendWidth),
      .DenominatorWidth(RadiusWidth),
      .QuotientWidth   (WantedWidth)
    ) u_ceiling (
      .numerator_i  (dividend_i),
      .denominator_i(minor_i),
      .quotient_o   (ceiling)
    );
  end else begin : gen_one_probe
    assign ceiling = WantedWidth'(1);

    logic unused_inputs;
    assign unused_inputs = ^{dividend_i, minor_i};
  end

  if (AnyFeline) begin : gen_nearest
    logic [WantedWidth-1:0] nearest;

    feline_quotient #(
      .NumeratorWidth  (RadiusWidth + 3),
      .DenominatorWidth(RadiusWidth),
      .QuotientWidth   (feline_pkg::EighthsWidth)
    ) u_eighths (
      .numerator_i  ({major_i, 3'b000}),
      .denominator_i(minor_i),
      .quotient_o   (eighths_o)
    );

    // floor(fProbes + 1/2) with fProbes = 2 major/minor - 1; major >= minor.
    assign nearest = WantedWidth'((eighths_o - feline_pkg::EighthsWidth'(2)) >> 2);

    always_comb begin
      wanted_o = ceiling;
      if (!is_ext && (!feline_pkg::FeatureFactors || probe_rounding_i == feline_pkg::ProbeRoundingNearest)) begin
        wanted_o = nearest;
      end
    end
  end else begin : gen_ceiling_only
    assign eighths_o = '0;
    assign wanted_o  = ceiling;

    logic unused_inputs;
    assign unused_inputs = ^{major_i, is_ext, probe_rounding_i};
  end
endmodule

`default_nettype wire
