// SPDX-License-Identifier: Apache-2.0
// The number of probes (choose_probes of model/plan.h).
//
// Takes  major, minor U8.7 and magnified (feline_clamp_radii); dividend (feline_probe_dividend); the mode, a supported
//        one; probe_rounding; max_probes.
// Gives  probes 1 .. max_probes; limited: more were wanted; eighths: floor(8 major / minor), which picks the weight
//        row, saturated where that no longer matters.
// Rounds ext: major/minor up. Feline: 2 major/minor - 1 to nearest, ties up; or 2 f major/minor - 1 up.
// Edges  magnified: one probe. minor 0: max_probes, limited.
// Source WRL 99/1, 3.1, 3.4; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_choose_probes (
  input  wire logic                                   magnified_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]     major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]     minor_i,
  input  wire logic [feline_pkg::DividendWidth-1:0]   dividend_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]       mode_i,
  input  wire logic                                   probe_rounding_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0] max_probes_i,
  output logic [feline_pkg::ProbeCountWidth-1:0]      probes_o,
  output logic                                        limited_o,
  output logic [feline_pkg::EighthsWidth-1:0]         eighths_o
);
  localparam int unsigned ProbeCountWidth = feline_pkg::ProbeCountWidth;
  localparam int unsigned WantedWidth     = $clog2(feline_pkg::MaxProbes + 2);

  logic [WantedWidth-1:0] wanted;

  feline_wanted_probes u_wanted_probes (
    .major_i, .minor_i, .dividend_i, .mode_i, .probe_rounding_i, .wanted_o(wanted), .eighths_o
  );

  assign limited_o = !magnified_i && 32'(wanted) > 32'(max_probes_i);

  always_comb begin
    if (limited_o) begin
      probes_o = max_probes_i;
    end else if (magnified_i || wanted == '0) begin
      probes_o = ProbeCountWidth'(1);
    end else begin
      probes_o = ProbeCountWidth'(wanted);
    end
  end
endmodule

`default_nettype wire
