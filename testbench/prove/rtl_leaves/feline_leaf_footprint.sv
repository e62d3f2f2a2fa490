// SPDX-License-Identifier: Apache-2.0
// All of feline_footprint (testbench/prove/leaves.h, Footprint).
`default_nettype none

module feline_leaf_footprint #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + feline_pkg::MantissaWidth + feline_pkg::MantissaWidth +
      feline_pkg::MantissaWidth + feline_pkg::MantissaWidth,
  localparam int unsigned OutputWidth = feline_pkg::VectorWidth + feline_pkg::VectorWidth + feline_pkg::RadiusWidth +
      feline_pkg::RadiusWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]     mode;
  logic [feline_pkg::MantissaWidth-1:0] dudx;
  logic [feline_pkg::MantissaWidth-1:0] dvdx;
  logic [feline_pkg::MantissaWidth-1:0] dudy;
  logic [feline_pkg::MantissaWidth-1:0] dvdy;
  logic [feline_pkg::VectorWidth-1:0]   major_u;
  logic [feline_pkg::VectorWidth-1:0]   major_v;
  logic [feline_pkg::RadiusWidth-1:0]   major_radius;
  logic [feline_pkg::RadiusWidth-1:0]   minor_radius;

  assign {mode, dudx, dvdx, dudy, dvdy} = inputs_i;
  assign outputs_o = {major_u, major_v, major_radius, minor_radius};

  feline_pkg::sampler_t   sampler;
  feline_pkg::group_t     group;
  feline_pkg::footprint_t footprint;
  logic                   ready;
  logic                   valid;

  always_comb begin
    sampler      = '0;
    sampler.mode = mode;
    group        = '0;
    group.dudx   = dudx;
    group.dvdx   = dvdx;
    group.dudy   = dudy;
    group.dvdy   = dvdy;
  end

  feline_footprint u_footprint (
    .clk_i(1'b0), .rst_i(1'b0), .sampler_i(sampler),
    .group_valid_i(1'b1), .group_ready_o(ready), .group_i(group),
    .footprint_valid_o(valid), .footprint_ready_i(1'b1), .footprint_o(footprint)
  );

  assign major_u      = footprint.major_u;
  assign major_v      = footprint.major_v;
  assign major_radius = footprint.major_radius;
  assign minor_radius = footprint.minor_radius;

  logic unused_footprint;
  assign unused_footprint = ^{ready, valid, footprint};
endmodule

`default_nettype wire
