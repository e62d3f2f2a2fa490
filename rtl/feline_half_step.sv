// SPDX-License-Identifier: Apache-2.0
// Half the distance of two probes along one axis (to_half_step of model/plan.h).
//
// Takes  product, the major vector's u or v times the reciprocal of width or height, U1.15 * 2^-size_shift, exact;
//        factor U1.16 (feline_half_step_factor); exponent.
// Gives  the half step S19.24 textures.
// Rounds nearest, ties away from zero, once.
// Edges  A factor of 0 gives 0. Where it is not 0, exponent <= MaxExponent: the fitted radius is at least its last bit,
//        which the sampler state's least length_factor sees to, and no level of detail is beyond the smallest level's
//        (feline_plan).
// Source WRL 99/1, 3.1.
`default_nettype none

module feline_half_step #(
  parameter int unsigned ProductWidth = feline_pkg::VectorWidth + feline_pkg::SizeReciprocalWidth
) (
  input  wire logic signed [ProductWidth-1:0]              product_i,
  input  wire logic [feline_pkg::ReciprocalWidth-1:0]      factor_i,
  input  wire logic [feline_pkg::SizeShiftWidth-1:0]       size_shift_i,
  input  wire logic signed [feline_pkg::ExponentWidth-1:0] exponent_i,
  output logic signed [feline_pkg::HalfStepWidth-1:0]      half_step_o
);
  localparam int unsigned HalfStepWidth = feline_pkg::HalfStepWidth;
  // The bits to drop are Right + size_shift - exponent; as exponents above Right would add bits, the magnitude gets as
  // many as they need first, and one to round by.
  localparam int unsigned Right = feline_pkg::VectorFraction + feline_pkg::ReciprocalFraction +
                                  feline_pkg::SizeReciprocalFraction - feline_pkg::HalfStepFraction;
  localparam int unsigned MaxExponent = feline_pkg::MaxSizeLog2 + feline_pkg::RadiusFraction;
  localparam int unsigned AddedBits = MaxExponent > Right ? MaxExponent - Right : 0;
  localparam int unsigned MagnitudeWidth = ProductWidth + feline_pkg::ReciprocalWidth + AddedBits + 1;
  localparam int unsigned DropWidth =
      $clog2(Right + AddedBits + (1 << feline_pkg::SizeShiftWidth) + (1 << (feline_pkg::ExponentWidth - 1))) + 1;

  logic                      negative;
  logic [ProductWidth-1:0]   size;
  logic [MagnitudeWidth-1:0] magnitude;
  logic [DropWidth-1:0]      dropped;
  logic [MagnitudeWidth-1:0] halves;
  logic [HalfStepWidth-1:0]  rounded;

  assign negative  = product_i[ProductWidth-1];
  assign size      = negative ? -product_i : product_i;
  assign magnitude = (MagnitudeWidth'(size) * MagnitudeWidth'(factor_i)) << (AddedBits + 1);
  assign dropped   = DropWidth'(Right + AddedBits) + DropWidth'(size_shift_i) - DropWidth'(exponent_i);
  assign halves    = magnitude >> dropped;
  assign rounded   = HalfStepWidth'(halves >> 1) + HalfStepWidth'(halves[0]);

  assign half_step_o = negative ? -rounded : rounded;
endmodule

`default_nettype wire
