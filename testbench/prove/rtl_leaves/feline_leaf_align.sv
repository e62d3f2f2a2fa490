// SPDX-License-Identifier: Apache-2.0
// All of feline_group but s and t (testbench/prove/leaves.h, Align).
`default_nettype none

module feline_leaf_align #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + feline_pkg::SizeWidth + feline_pkg::SizeWidth +
      feline_pkg::Float32Width + feline_pkg::Float32Width + feline_pkg::Float32Width + feline_pkg::Float32Width,
  localparam int unsigned OutputWidth = feline_pkg::StatusWidth + feline_pkg::ExponentWidth +
      feline_pkg::MantissaWidth + feline_pkg::MantissaWidth + feline_pkg::MantissaWidth + feline_pkg::MantissaWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]     mode;
  logic [feline_pkg::SizeWidth-1:0]     width;
  logic [feline_pkg::SizeWidth-1:0]     height;
  logic [feline_pkg::Float32Width-1:0]  dsdx;
  logic [feline_pkg::Float32Width-1:0]  dtdx;
  logic [feline_pkg::Float32Width-1:0]  dsdy;
  logic [feline_pkg::Float32Width-1:0]  dtdy;
  logic [feline_pkg::StatusWidth-1:0]   status;
  logic [feline_pkg::ExponentWidth-1:0] exponent;
  logic [feline_pkg::MantissaWidth-1:0] dudx;
  logic [feline_pkg::MantissaWidth-1:0] dvdx;
  logic [feline_pkg::MantissaWidth-1:0] dudy;
  logic [feline_pkg::MantissaWidth-1:0] dvdy;

  assign {mode, width, height, dsdx, dtdx, dsdy, dtdy} = inputs_i;
  assign outputs_o = {status, exponent, dudx, dvdx, dudy, dvdy};

  feline_pkg::sampler_t sampler;
  feline_pkg::request_t request;
  feline_pkg::group_t   group;
  logic                 ready;
  logic                 valid;

  always_comb begin
    sampler        = '0;
    sampler.mode   = mode;
    sampler.width  = width;
    sampler.height = height;
    request        = '0;
    request.dsdx   = dsdx;
    request.dtdx   = dtdx;
    request.dsdy   = dsdy;
    request.dtdy   = dtdy;
  end

  feline_group u_group (
    .clk_i(1'b0), .rst_i(1'b0), .sampler_i(sampler),
    .request_valid_i(1'b1), .request_ready_o(ready), .request_i(request),
    .group_valid_o(valid), .group_ready_i(1'b1), .group_o(group)
  );

  assign status   = group.status;
  assign exponent = group.exponent;
  assign dudx     = group.dudx;
  assign dvdx     = group.dvdx;
  assign dudy     = group.dudy;
  assign dvdy     = group.dvdy;

  logic unused_group;
  assign unused_group = ^{ready, valid, group};
endmodule

`default_nettype wire
