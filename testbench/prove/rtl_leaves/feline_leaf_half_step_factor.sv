// SPDX-License-Identifier: Apache-2.0
// How far along the major vector half a step goes (testbench/prove/leaves.h, HalfStepFactor).
`default_nettype none

module feline_leaf_half_step_factor #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + feline_pkg::ProbeCountWidth +
      feline_pkg::LineFractionWidth,
  localparam int unsigned OutputWidth = feline_pkg::ReciprocalWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]         mode;
  logic [feline_pkg::ProbeCountWidth-1:0]   probes;
  logic [feline_pkg::LineFractionWidth-1:0] line;
  logic [feline_pkg::ReciprocalWidth-1:0]   factor;

  assign {mode, probes, line} = inputs_i;
  assign outputs_o = {factor};

  feline_half_step_factor u_half_step_factor (.mode_i(mode), .probes_i(probes), .line_i(line), .factor_o(factor));
endmodule

`default_nettype wire
