// SPDX-License-Identifier: Apache-2.0
// Width or height of a level: max(1, size >> level), U15.0 texels.
//
// Takes  size U15.0, 1 .. 16384 texels; level U5.0, one bit more than a level, so that the one after the last is legal.
// Rounds down. Edges: a level past the last is 1.
// Source OpenGL 4.6, 8.14.3 (mipmap sizes).
`default_nettype none

module feline_level_size (
  input  wire logic [feline_pkg::SizeWidth-1:0] size_i,
  input  wire logic [feline_pkg::LevelWidth:0]  level_i,
  output logic [feline_pkg::SizeWidth-1:0]      size_o
);
  logic [feline_pkg::SizeWidth-1:0] shifted;

  assign shifted = size_i >> level_i;
  assign size_o  = shifted == '0 ? feline_pkg::SizeWidth'(1) : shifted;
endmodule

`default_nettype wire
