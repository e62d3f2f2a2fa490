// SPDX-License-Identifier: Apache-2.0
// What every stage may count on: a legal sampler state (tables/sampler_state.h, model/sampler.h) of the default
// configuration, that stays from reset to reset. A driver also changes it while nothing is inside: what is left then
// are registers that are not valid, and the lines of fetch, which no sampler state has a part in.
`default_nettype none

module feline_rules_sampler (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  output logic                      legal_o
);
  localparam logic [feline_pkg::SizeWidth-1:0]    MostSize = feline_pkg::SizeWidth'(1) << feline_pkg::MaxSizeLog2;
  localparam logic [feline_pkg::ChannelWidth-1:0] White    = {8'hff, feline_pkg::ChannelFraction'(0)};
  localparam int unsigned                         One      = 1 << feline_pkg::FactorFraction;

  logic                 known_q;
  feline_pkg::sampler_t sampler_q;

  always_ff @(posedge clk_i) begin
    known_q   <= !rst_i;
    sampler_q <= sampler_i;
  end

  logic [feline_pkg::SizeWidth-1:0] larger;
  logic                             sizes_legal;
  logic                             shifts_legal;
  logic                             factors_legal;
  logic                             levels_legal;
  logic [3:0]                       channel_legal;

  assign larger       = sampler_i.width > sampler_i.height ? sampler_i.width : sampler_i.height;
  assign sizes_legal  = sampler_i.width != '0 && sampler_i.width <= MostSize && sampler_i.height != '0 &&
                        sampler_i.height <= MostSize && 32'(larger) >> sampler_i.smallest_level == 1;
  // size <= 2^shift < 2 size; the mantissa of 1/size is 1 or more.
  assign shifts_legal = sampler_i.width_reciprocal[feline_pkg::SizeReciprocalFraction] &&
                        sampler_i.height_reciprocal[feline_pkg::SizeReciprocalFraction] &&
                        (32'(sampler_i.width) - 1) >> sampler_i.width_shift == 0 &&
                        (32'(sampler_i.width) << 1) > 32'(1) << sampler_i.width_shift &&
                        (32'(sampler_i.height) - 1) >> sampler_i.height_shift == 0 &&
                        (32'(sampler_i.height) << 1) > 32'(1) << sampler_i.height_shift;
  // 1/256 .. 1; 1 .. 2, not 2; 1/2 .. 1; 1/4 .. 1.
  assign factors_legal = sampler_i.length_factor != '0 && 32'(sampler_i.length_factor) <= One &&
                         32'(sampler_i.blur_factor) >= One && 32'(sampler_i.inverse_alias_factor) >= One / 2 &&
                         32'(sampler_i.inverse_alias_factor) <= One && 32'(sampler_i.probe_factor) >= One / 4 &&
                         32'(sampler_i.probe_factor) <= One && sampler_i.max_probes != '0 &&
                         32'(sampler_i.max_probes) <= feline_pkg::MaxProbes && !sampler_i.probes_cut;
  assign levels_legal  = sampler_i.last_level <= sampler_i.smallest_level && !sampler_i.levels_cut &&
                         sampler_i.min_level <= sampler_i.max_level;

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    logic present;

    assign present = sampler_i.texel_format == feline_pkg::TexelFormatRgba8 || c == 0 ||
                     (c == 1 && sampler_i.texel_format == feline_pkg::TexelFormatRg8);
    assign channel_legal[c] = present ? sampler_i.border[c] <= White : sampler_i.border[c] == (c == 3 ? White : '0);
  end

  assign legal_o = (!known_q || sampler_i == sampler_q) && sampler_i.mode <= feline_pkg::ModeTable &&
                   sampler_i.texel_format <= feline_pkg::TexelFormatRgba8 && sizes_legal && shifts_legal &&
                   factors_legal && levels_legal && channel_legal == '1;
endmodule

`default_nettype wire
