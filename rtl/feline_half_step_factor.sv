// SPDX-License-Identifier: Apache-2.0
// How far along the major vector half a step goes (half_step_factor of model/plan.h).
//
// Takes  the mode, a supported one; probes; line U1.12, the part (major - fitted) / major_radius of the vector.
// Gives  the factor, U1.16 of the vector. ext: half of 1/(probes + 1). Feline: line / (probes - 1).
// Rounds nearest, ties up.
// Edges  one probe: 0.
// Source WRL 99/1, 3.1; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_half_step_factor (
  input  wire logic [feline_pkg::ModeWidth-1:0]         mode_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0]   probes_i,
  input  wire logic [feline_pkg::LineFractionWidth-1:0] line_i,
  output logic [feline_pkg::ReciprocalWidth-1:0]        factor_o
);
  localparam int unsigned LineFraction    = feline_pkg::LineFractionFraction;
  localparam int unsigned ReciprocalWidth = feline_pkg::ReciprocalWidth;
  localparam int unsigned ReciprocalIndexWidth = $clog2(feline_pkg::MaxProbes + 2);
  localparam int unsigned ProductWidth    = feline_pkg::LineFractionWidth + ReciprocalWidth;
  localparam bit          AnyFeline       = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  logic                            is_ext;
  logic [ReciprocalIndexWidth-1:0] parts;
  logic [ReciprocalWidth-1:0]      reciprocal;
  logic [ReciprocalWidth-1:0]      ext;
  logic [ReciprocalWidth-1:0]      feline;

  // Without Feline, other modes than ext have one probe.
  assign is_ext = !AnyFeline || (feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt);
  assign parts  = is_ext ? ReciprocalIndexWidth'(probes_i) + 1'b1 : ReciprocalIndexWidth'(probes_i) - 1'b1;

  feline_rom_reciprocal u_rom_reciprocal (.index_i(parts), .data_o(reciprocal));

  assign ext = (reciprocal + ReciprocalWidth'(1)) >> 1;

  if (AnyFeline) begin : gen_feline
    logic [ProductWidth-1:0] product;

    assign product = ProductWidth'(line_i) * ProductWidth'(reciprocal) + (ProductWidth'(1) << (LineFraction - 1));
    assign feline  = product[LineFraction +: ReciprocalWidth];

    logic unused_product;
    assign unused_product = ^product;
  end else begin : gen_no_feline
    assign feline = '0;

    logic unused_line;
    assign unused_line = ^line_i;
  end

  always_comb begin
    if (probes_i == feline_pkg::ProbeCountWidth'(1)) begin
      factor_o = '0;
    end else begin
      factor_o = is_ext ? ext : feline;
    end
  end
endmodule

`default_nettype wire
