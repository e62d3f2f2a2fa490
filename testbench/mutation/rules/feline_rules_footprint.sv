// SPDX-License-Identifier: Apache-2.0
// What reaches footprint: a beat stays until it is taken; mantissas without -128 (proof mantissas), the largest of them 64 or
// more, or all 0 (leaf group.align); nothing unsupported in the full configuration.
`default_nettype none

module feline_rules_footprint (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 group_valid_i,
  input  wire logic                 group_ready_o,
  input  wire feline_pkg::group_t   group_i,
  output logic                      legal_o
);
  localparam int unsigned Width = feline_pkg::MantissaWidth;

  logic               held_q;
  feline_pkg::group_t group_q;
  logic               sampler_legal;
  logic [3:0]         mantissa_legal;
  logic [3:0]         mantissa_large;
  logic               any_large;
  logic               all_zero;
  logic [4*Width-1:0] mantissas;

  always_ff @(posedge clk_i) begin
    held_q <= !rst_i && group_valid_i && !group_ready_o;
    group_q <= group_i;
  end

  feline_rules_sampler u_sampler (.clk_i, .rst_i, .sampler_i, .legal_o(sampler_legal));

  assign any_large = mantissa_large != '0;
  assign all_zero  = {group_i.dudx, group_i.dvdx, group_i.dudy, group_i.dvdy} == '0;
  assign mantissas = {group_i.dvdy, group_i.dudy, group_i.dvdx, group_i.dudx};

  for (genvar i = 0; i < 4; i++) begin : gen_mantissa
    logic signed [Width-1:0] mantissa;

    assign mantissa          = mantissas[i*Width +: Width];
    assign mantissa_legal[i] = mantissa != {1'b1, {(Width-1){1'b0}}};
    assign mantissa_large[i] = mantissa >= $signed(Width'(1) << (Width - 2)) || mantissa <= -$signed(Width'(1) << (Width - 2));
  end

  assign legal_o = sampler_legal && (!held_q || (group_valid_i && group_i == group_q)) &&
                   (!group_valid_i || (mantissa_legal == '1 && (any_large || all_zero) &&
                                       !group_i.status[feline_pkg::StatusUnsupported]));
endmodule

`default_nettype wire
