// SPDX-License-Identifier: Apache-2.0
// Width or height of a level (testbench/prove/leaves.h, LevelSize).
`default_nettype none

module feline_leaf_level_size #(
  localparam int unsigned InputWidth = feline_pkg::SizeWidth + (feline_pkg::LevelWidth + 1),
  localparam int unsigned OutputWidth = feline_pkg::SizeWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::SizeWidth-1:0]        size;
  logic [(feline_pkg::LevelWidth + 1)-1:0] level;
  logic [feline_pkg::SizeWidth-1:0]        level_size;

  assign {size, level} = inputs_i;
  assign outputs_o = {level_size};

  feline_level_size u_level_size (.size_i(size), .level_i(level), .size_o(level_size));
endmodule

`default_nettype wire
