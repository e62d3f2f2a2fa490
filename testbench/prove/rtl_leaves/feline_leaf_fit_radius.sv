// SPDX-License-Identifier: Apache-2.0
// The minor radius that fits a probe count (testbench/prove/leaves.h, FitRadius).
`default_nettype none

module feline_leaf_fit_radius #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + 1 + feline_pkg::FactorWidth + feline_pkg::FactorWidth +
      1 + feline_pkg::ProbeCountWidth + feline_pkg::RadiusWidth + feline_pkg::RadiusWidth,
  localparam int unsigned OutputWidth = feline_pkg::RadiusWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]       mode;
  logic [1-1:0]                           probe_rounding;
  logic [feline_pkg::FactorWidth-1:0]     blur_factor;
  logic [feline_pkg::FactorWidth-1:0]     inverse_alias;
  logic [1-1:0]                           limited;
  logic [feline_pkg::ProbeCountWidth-1:0] probes;
  logic [feline_pkg::RadiusWidth-1:0]     major;
  logic [feline_pkg::RadiusWidth-1:0]     minor;
  logic [feline_pkg::RadiusWidth-1:0]     fitted;

  assign {mode, probe_rounding, blur_factor, inverse_alias, limited, probes, major, minor} = inputs_i;
  assign outputs_o = {fitted};

  feline_fit_radius u_fit_radius (
    .major_i(major), .minor_i(minor), .probes_i(probes), .limited_i(limited), .mode_i(mode),
    .probe_rounding_i(probe_rounding), .blur_factor_i(blur_factor), .inverse_alias_factor_i(inverse_alias),
    .fitted_o(fitted)
  );
endmodule

`default_nettype wire
