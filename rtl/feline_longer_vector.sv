// SPDX-License-Identifier: Apache-2.0
// The longer of two vectors and, where it needs no table, the minor radius (model/footprint.h).
//
// Takes  dudx, dvdx, dudy, dvdy S7.0 texel * 2^exponent; the mode, a supported one.
// Gives  the longer vector S7.0, its length U8.7 and whether it is x; the shorter length U8.7; minor U8.7, the minor
//        radius: ext: the shorter length. simple: the shortest of sides and diagonals. table: of no use. Else: the
//        longer length.
// Rounds nothing.
// Edges  Equal lengths: y is the longer vector.
// Source WRL 99/1, 3.2; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_longer_vector (
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] dudx_i,
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] dvdx_i,
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] dudy_i,
  input  wire logic signed [feline_pkg::MantissaWidth-1:0] dvdy_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]            mode_i,
  output logic signed [feline_pkg::MantissaWidth-1:0]      u_o,
  output logic signed [feline_pkg::MantissaWidth-1:0]      v_o,
  output logic [feline_pkg::RadiusWidth-1:0]               length_o,
  output logic                                             is_x_o,
  output logic [feline_pkg::RadiusWidth-1:0]               shorter_length_o,
  output logic [feline_pkg::RadiusWidth-1:0]               minor_o
);
  localparam int unsigned MantissaWidth = feline_pkg::MantissaWidth;
  localparam int unsigned RadiusWidth   = feline_pkg::RadiusWidth;

  logic [RadiusWidth-1:0] x_length;
  logic [RadiusWidth-1:0] y_length;
  logic [RadiusWidth-1:0] shortest;

  feline_length #(.Width(MantissaWidth), .LengthWidth(RadiusWidth)) u_x_length (
    .u_i     (dudx_i),
    .v_i     (dvdx_i),
    .length_o(x_length)
  );
  feline_length #(.Width(MantissaWidth), .LengthWidth(RadiusWidth)) u_y_length (
    .u_i     (dudy_i),
    .v_i     (dvdy_i),
    .length_o(y_length)
  );

  assign is_x_o           = x_length > y_length;
  assign u_o              = is_x_o ? dudx_i : dudy_i;
  assign v_o              = is_x_o ? dvdx_i : dvdy_i;
  assign length_o         = is_x_o ? x_length : y_length;
  assign shorter_length_o = is_x_o ? y_length : x_length;

  if (feline_pkg::FeatureSimpleFeline) begin : gen_diagonals
    localparam int unsigned SumWidth       = MantissaWidth + 1;
    localparam int unsigned SumLengthWidth = RadiusWidth + 1;

    logic [SumLengthWidth-1:0] sum_length;
    logic [SumLengthWidth-1:0] difference_length;
    logic [SumLengthWidth-1:0] diagonal;

    feline_length #(.Width(SumWidth), .LengthWidth(SumLengthWidth)) u_sum_length (
      .u_i     (SumWidth'(dudx_i) + SumWidth'(dudy_i)),
      .v_i     (SumWidth'(dvdx_i) + SumWidth'(dvdy_i)),
      .length_o(sum_length)
    );
    feline_length #(.Width(SumWidth), .LengthWidth(SumLengthWidth)) u_difference_length (
      .u_i     (SumWidth'(dudx_i) - SumWidth'(dudy_i)),
      .v_i     (SumWidth'(dvdx_i) - SumWidth'(dvdy_i)),
      .length_o(difference_length)
    );

    assign diagonal = sum_length < difference_length ? sum_length : difference_length;
    assign shortest =
        diagonal < SumLengthWidth'(shorter_length_o) ? diagonal[RadiusWidth-1:0] : shorter_length_o;
  end else begin : gen_sides_only
    assign shortest = shorter_length_o;
  end

  always_comb begin
    unique case (mode_i)
      feline_pkg::ModeExt:    minor_o = feline_pkg::FeatureExt ? shorter_length_o : length_o;
      feline_pkg::ModeSimple: minor_o = feline_pkg::FeatureSimpleFeline ? shortest : length_o;
      default:                minor_o = length_o;
    endcase
  end
endmodule

`default_nettype wire
