// SPDX-License-Identifier: Apache-2.0
// Whether a sampler state asks for what the configuration leaves out (model/features.h).
`default_nettype none

module feline_unsupported (
  input  wire feline_pkg::sampler_t sampler_i,
  output logic                      unsupported_o
);
  logic [feline_pkg::ModeWidth-1:0]        mode;
  logic [feline_pkg::WrapWidth-1:0]        wrap_s;
  logic [feline_pkg::WrapWidth-1:0]        wrap_t;
  logic [feline_pkg::TexelFormatWidth-1:0] texel_format;
  logic                                    factored;

  feline_supported_mode u_mode (.mode_i(sampler_i.mode), .mode_o(mode));
  feline_supported_wrap u_wrap_s (.wrap_i(sampler_i.wrap_s), .wrap_o(wrap_s));
  feline_supported_wrap u_wrap_t (.wrap_i(sampler_i.wrap_t), .wrap_o(wrap_t));
  feline_supported_format u_format (.texel_format_i(sampler_i.texel_format), .texel_format_o(texel_format));

  assign factored = sampler_i.probe_rounding == feline_pkg::ProbeRoundingCeiling ||
                    sampler_i.length_factor != feline_pkg::FactorWidth'(1) << feline_pkg::FactorFraction;

  assign unsupported_o = mode != sampler_i.mode || wrap_s != sampler_i.wrap_s || wrap_t != sampler_i.wrap_t ||
                         texel_format != sampler_i.texel_format ||
                         (sampler_i.kernel && !feline_pkg::FeatureGaussian) ||
                         (sampler_i.srgb && !feline_pkg::FeatureSrgb) || (factored && !feline_pkg::FeatureFactors);

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;
endmodule

`default_nettype wire
