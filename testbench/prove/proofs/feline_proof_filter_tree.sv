// SPDX-License-Identifier: Apache-2.0
// filter is a tree of feline_interpolate, the first of which a leaf enumerates: along x, along y, between the levels, each
// channel by itself; the fractions along x and y by the kernel. Registers are wires here.
`default_nettype none

module feline_proof_filter_tree (
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire feline_pkg::fetch_t   fetch_i,
  output logic                      broken_o
);
  localparam int unsigned FractionWidth = feline_pkg::TexelFractionWidth;
  localparam int unsigned TexelWidth    = feline_pkg::ChannelWidth;
  localparam int unsigned RowWidth      = TexelWidth + FractionWidth;
  localparam int unsigned LevelWidth    = RowWidth + FractionWidth;
  localparam int unsigned ColourWidth   = feline_pkg::FilteredWidth;

  feline_pkg::filter_t        filter;
  logic                       ready;
  logic                       valid;
  logic [4*FractionWidth-1:0] given;     // fine x and y, coarse x and y
  logic [4*FractionWidth-1:0] fraction;
  logic [3:0]                 broken;

  feline_filter u_filter (
    .clk_i(1'b0), .rst_i(1'b0), .sampler_i,
    .fetch_valid_i(1'b1), .fetch_ready_o(ready), .fetch_i,
    .filter_valid_o(valid), .filter_ready_i(1'b1), .filter_o(filter)
  );

  assign given = {fetch_i.coarse_fraction_y, fetch_i.coarse_fraction_x, fetch_i.fine_fraction_y, fetch_i.fine_fraction_x};

  for (genvar i = 0; i < 4; i++) begin : gen_fraction
    logic [FractionWidth-1:0] gaussian;

    feline_rom_gaussian u_gaussian (.index_i(given[i*FractionWidth +: FractionWidth]), .data_o(gaussian));

    assign fraction[i*FractionWidth +: FractionWidth] =
        sampler_i.kernel == feline_pkg::KernelGaussian && fetch_i.linear ? gaussian
                                                                          : given[i*FractionWidth +: FractionWidth];
  end

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    logic [8*TexelWidth-1:0] texel;
    logic [4*RowWidth-1:0]   row;
    logic [2*LevelWidth-1:0] level;
    logic [ColourWidth-1:0]  colour;

    assign texel = {fetch_i.coarse_11[c], fetch_i.coarse_01[c], fetch_i.coarse_10[c], fetch_i.coarse_00[c],
                    fetch_i.fine_11[c], fetch_i.fine_01[c], fetch_i.fine_10[c], fetch_i.fine_00[c]};

    for (genvar r = 0; r < 4; r++) begin : gen_row
      feline_interpolate #(.ValueWidth(TexelWidth), .FractionWidth(FractionWidth)) u_row (
        .a_i(texel[2*r*TexelWidth +: TexelWidth]), .b_i(texel[(2*r + 1)*TexelWidth +: TexelWidth]),
        .fraction_i(fraction[r/2*2*FractionWidth +: FractionWidth]), .value_o(row[r*RowWidth +: RowWidth])
      );
    end
    for (genvar l = 0; l < 2; l++) begin : gen_level
      feline_interpolate #(.ValueWidth(RowWidth), .FractionWidth(FractionWidth)) u_level (
        .a_i(row[2*l*RowWidth +: RowWidth]), .b_i(row[(2*l + 1)*RowWidth +: RowWidth]),
        .fraction_i(fraction[(2*l + 1)*FractionWidth +: FractionWidth]), .value_o(level[l*LevelWidth +: LevelWidth])
      );
    end
    feline_interpolate #(.ValueWidth(LevelWidth), .FractionWidth(feline_pkg::LevelFractionWidth)) u_colour (
      .a_i(level[0 +: LevelWidth]), .b_i(level[LevelWidth +: LevelWidth]), .fraction_i(fetch_i.level_fraction),
      .value_o(colour)
    );
    assign broken[c] = colour != filter.colour[c];
  end

  assign broken_o = !ready || !valid || broken != '0;
endmodule

`default_nettype wire
