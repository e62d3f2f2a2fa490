// SPDX-License-Identifier: Apache-2.0
// What reaches plan: a beat stays until it is taken; the minor radius is not larger than the major one, which is 0 or at
// least 64 (leaves footprint.*), 0 under the least exponent alone (leaf group.align); without probes along a line both
// are one (leaf footprint.isotropic); no vector is longer than twice its radius (test
// footprint.no_vector_is_longer_than_twice_its_radius); nothing unsupported in the full configuration.
`default_nettype none

module feline_rules_plan (
  input  wire logic                   clk_i,
  input  wire logic                   rst_i,
  input  wire feline_pkg::sampler_t   sampler_i,
  input  wire logic                   footprint_valid_i,
  input  wire logic                   footprint_ready_o,
  input  wire feline_pkg::footprint_t footprint_i,
  output logic                        legal_o
);
  localparam logic [feline_pkg::RadiusWidth-1:0] Least =
      feline_pkg::RadiusWidth'(1) << (feline_pkg::MantissaWidth - 2 + feline_pkg::RadiusFraction);
  localparam logic [feline_pkg::ExponentWidth-1:0] LeastExponent = {1'b1, (feline_pkg::ExponentWidth - 1)'(0)};
  localparam int unsigned VectorWidth = feline_pkg::VectorWidth;

  logic                   held_q;
  feline_pkg::footprint_t footprint_q;
  logic                   sampler_legal;
  logic [VectorWidth:0]   longest;
  logic [VectorWidth-1:0] size_u;
  logic [VectorWidth-1:0] size_v;

  // Twice the radius, which has a fraction bit less.
  assign longest = (VectorWidth + 1)'({footprint_i.major_radius, 2'b00});
  assign size_u  = footprint_i.major_u[VectorWidth-1] ? -footprint_i.major_u : footprint_i.major_u;
  assign size_v  = footprint_i.major_v[VectorWidth-1] ? -footprint_i.major_v : footprint_i.major_v;

  always_ff @(posedge clk_i) begin
    held_q <= !rst_i && footprint_valid_i && !footprint_ready_o;
    footprint_q <= footprint_i;
  end

  feline_rules_sampler u_sampler (.clk_i, .rst_i, .sampler_i, .legal_o(sampler_legal));

  assign legal_o = sampler_legal && (!held_q || (footprint_valid_i && footprint_i == footprint_q)) &&
                   (!footprint_valid_i || (footprint_i.minor_radius <= footprint_i.major_radius &&
                                           (footprint_i.major_radius == '0 ? footprint_i.exponent == LeastExponent
                                                                           : footprint_i.major_radius >= Least) &&
                                           (sampler_i.mode >= feline_pkg::ModeExt ||
                                            footprint_i.minor_radius == footprint_i.major_radius) &&
                                           (VectorWidth + 1)'(size_u) <= longest &&
                                           (VectorWidth + 1)'(size_v) <= longest &&
                                           !footprint_i.status[feline_pkg::StatusUnsupported]));
endmodule

`default_nettype wire
