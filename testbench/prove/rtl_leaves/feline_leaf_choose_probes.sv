// SPDX-License-Identifier: Apache-2.0
// The limit of a probe count (testbench/prove/leaves.h, ChooseProbes): radii that want so many in mode ext.
`default_nettype none

module feline_leaf_choose_probes #(
  localparam int unsigned InputWidth = 1 + feline_pkg::ProbeCountWidth + $clog2(feline_pkg::MaxProbes + 2),
  localparam int unsigned OutputWidth = feline_pkg::ProbeCountWidth + 1
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [1-1:0]                                 magnified;
  logic [feline_pkg::ProbeCountWidth-1:0]       max_probes;
  logic [$clog2(feline_pkg::MaxProbes + 2)-1:0] wanted;
  logic [feline_pkg::ProbeCountWidth-1:0]       probes;
  logic [1-1:0]                                 limited;

  assign {magnified, max_probes, wanted} = inputs_i;
  assign outputs_o = {probes, limited};

  localparam int unsigned MinorLog2 = 9;

  logic [feline_pkg::RadiusWidth-1:0]   major;
  logic [feline_pkg::RadiusWidth-1:0]   minor;
  logic [feline_pkg::DividendWidth-1:0] dividend;
  logic [feline_pkg::EighthsWidth-1:0]  eighths;

  assign major = feline_pkg::RadiusWidth'(wanted) << MinorLog2;
  assign minor = feline_pkg::RadiusWidth'(1) << MinorLog2;

  feline_probe_dividend u_probe_dividend (
    .major_i(major), .minor_i(minor), .mode_i(feline_pkg::ModeExt),
    .probe_factor_i(feline_pkg::FactorWidth'(1) << feline_pkg::FactorFraction), .dividend_o(dividend)
  );
  feline_choose_probes u_choose_probes (
    .magnified_i(magnified), .major_i(major), .minor_i(minor), .dividend_i(dividend), .mode_i(feline_pkg::ModeExt),
    .probe_rounding_i(feline_pkg::ProbeRoundingNearest), .max_probes_i(max_probes),
    .probes_o(probes), .limited_o(limited), .eighths_o(eighths)
  );

  logic unused_eighths;
  assign unused_eighths = ^eighths;
endmodule

`default_nettype wire
