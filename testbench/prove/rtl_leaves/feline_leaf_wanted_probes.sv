// SPDX-License-Identifier: Apache-2.0
// How many probes radii want (testbench/prove/leaves.h, WantedProbes).
`default_nettype none

module feline_leaf_wanted_probes #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + 1 + feline_pkg::FactorWidth + feline_pkg::RadiusWidth +
      feline_pkg::RadiusWidth,
  localparam int unsigned OutputWidth = $clog2(feline_pkg::MaxProbes + 2) + feline_pkg::EighthsWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]             mode;
  logic [1-1:0]                                 probe_rounding;
  logic [feline_pkg::FactorWidth-1:0]           probe_factor;
  logic [feline_pkg::RadiusWidth-1:0]           major;
  logic [feline_pkg::RadiusWidth-1:0]           minor;
  logic [$clog2(feline_pkg::MaxProbes + 2)-1:0] wanted;
  logic [feline_pkg::EighthsWidth-1:0]          eighths;

  assign {mode, probe_rounding, probe_factor, major, minor} = inputs_i;
  assign outputs_o = {wanted, eighths};

  logic [feline_pkg::DividendWidth-1:0] dividend;

  feline_probe_dividend u_probe_dividend (
    .major_i(major), .minor_i(minor), .mode_i(mode), .probe_factor_i(probe_factor), .dividend_o(dividend)
  );
  feline_wanted_probes u_wanted_probes (
    .major_i(major), .minor_i(minor), .dividend_i(dividend), .mode_i(mode), .probe_rounding_i(probe_rounding),
    .wanted_o(wanted), .eighths_o(eighths)
  );
endmodule

`default_nettype wire
