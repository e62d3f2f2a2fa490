// SPDX-License-Identifier: Apache-2.0
// What a configuration makes of a mode that it leaves out (tables/supported.h).
`default_nettype none

module feline_supported_mode (
  input  wire logic [feline_pkg::ModeWidth-1:0] mode_i,
  output logic [feline_pkg::ModeWidth-1:0]      mode_o
);
  always_comb begin
    unique case (mode_i)
      feline_pkg::ModeNearest:  mode_o = feline_pkg::SupportedModeNearest;
      feline_pkg::ModeBilinear: mode_o = feline_pkg::SupportedModeBilinear;
      feline_pkg::ModeExt:      mode_o = feline_pkg::SupportedModeExt;
      feline_pkg::ModeSimple:   mode_o = feline_pkg::SupportedModeSimple;
      feline_pkg::ModeTable:    mode_o = feline_pkg::SupportedModeTable;
      default:                  mode_o = feline_pkg::SupportedModeTrilinear;
    endcase
  end
endmodule

`default_nettype wire
