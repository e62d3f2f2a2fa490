// SPDX-License-Identifier: Apache-2.0
// The level of detail that is sampled (testbench/prove/leaves.h, SampledLevel).
`default_nettype none

module feline_leaf_sampled_level #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + 1 + 1 + feline_pkg::LevelWidth +
      feline_pkg::SampledLevelWidth + feline_pkg::SampledLevelWidth + feline_pkg::LevelOfDetailWidth +
      feline_pkg::LevelOfDetailWidth,
  localparam int unsigned OutputWidth = feline_pkg::SampledLevelWidth + 1 + 1
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]                 mode;
  logic [1-1:0]                                     magnify;
  logic [1-1:0]                                     levels_cut;
  logic [feline_pkg::LevelWidth-1:0]                last_level;
  logic [feline_pkg::SampledLevelWidth-1:0]         min_level;
  logic [feline_pkg::SampledLevelWidth-1:0]         max_level;
  logic signed [feline_pkg::LevelOfDetailWidth-1:0] level_bias;
  logic signed [feline_pkg::LevelOfDetailWidth-1:0] base_level;
  logic [feline_pkg::SampledLevelWidth-1:0]         level_of_detail;
  logic [1-1:0]                                     linear;
  logic [1-1:0]                                     missing;

  assign {mode, magnify, levels_cut, last_level, min_level, max_level, level_bias, base_level} = inputs_i;
  assign outputs_o = {level_of_detail, linear, missing};

  feline_sampled_level u_sampled_level (
    .base_level_i(base_level), .level_bias_i(level_bias), .min_level_i(min_level), .max_level_i(max_level),
    .last_level_i(last_level), .levels_cut_i(levels_cut), .mode_i(mode), .magnify_i(magnify),
    .level_of_detail_o(level_of_detail), .linear_o(linear), .missing_o(missing)
  );
endmodule

`default_nettype wire
