// SPDX-License-Identifier: Apache-2.0
// The Gaussian kernel (testbench/prove/leaves.h, KernelWeight).
`default_nettype none

module feline_leaf_kernel_weight #(
  localparam int unsigned InputWidth = feline_pkg::TexelFractionWidth,
  localparam int unsigned OutputWidth = feline_pkg::TexelFractionWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::TexelFractionWidth-1:0] fraction;
  logic [feline_pkg::TexelFractionWidth-1:0] weight;

  assign {fraction} = inputs_i;
  assign outputs_o = {weight};

  feline_rom_gaussian u_rom_gaussian (.index_i(fraction), .data_o(weight));
endmodule

`default_nettype wire
