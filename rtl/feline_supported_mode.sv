// SPDX-License-Identifier: Apache-2.0
// What a configuration makes of a mode that it leaves out: trilinear (model/features.h).
`default_nettype none

module feline_supported_mode (
  input  wire logic [feline_pkg::ModeWidth-1:0] mode_i,
  output logic [feline_pkg::ModeWidth-1:0]      mode_o
);
  logic left_out;

  assign left_out = (mode_i == feline_pkg::ModeExt && !feline_pkg::FeatureExt) ||
                    (mode_i == feline_pkg::ModeSimple && !feline_pkg::FeatureSimpleFeline) ||
                    (mode_i == feline_pkg::ModeTable && !feline_pkg::FeatureTableFeline);
  assign mode_o = left_out ? feline_pkg::ModeTrilinear : mode_i;
endmodule

`default_nettype wire
