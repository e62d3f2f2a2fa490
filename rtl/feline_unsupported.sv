// SPDX-License-Identifier: Apache-2.0
// Whether a sampler state asks for a feature that the configuration leaves out (model/features.h).
`default_nettype none

module feline_unsupported (
  input  wire logic [feline_pkg::ModeWidth-1:0] mode_i,
  input  wire logic [feline_pkg::WrapWidth-1:0] wrap_s_i,
  input  wire logic [feline_pkg::WrapWidth-1:0] wrap_t_i,
  input  wire logic                             kernel_i,
  input  wire logic                             srgb_i,
  output logic                                  unsupported_o
);
  logic [feline_pkg::ModeWidth-1:0] mode;
  logic [feline_pkg::WrapWidth-1:0] wrap_s;
  logic [feline_pkg::WrapWidth-1:0] wrap_t;

  feline_supported_mode u_mode (.mode_i(mode_i), .mode_o(mode));
  feline_supported_wrap u_wrap_s (.wrap_i(wrap_s_i), .wrap_o(wrap_s));
  feline_supported_wrap u_wrap_t (.wrap_i(wrap_t_i), .wrap_o(wrap_t));

  assign unsupported_o = mode != mode_i || wrap_s != wrap_s_i || wrap_t != wrap_t_i ||
                         (kernel_i && !feline_pkg::FeatureGaussian) || (srgb_i && !feline_pkg::FeatureSrgb);
endmodule

`default_nettype wire
