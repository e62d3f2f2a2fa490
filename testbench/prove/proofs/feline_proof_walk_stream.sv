// SPDX-License-Identifier: Apache-2.0
// walk gives of each plan, in order, its probes 0 .. probes - 1, first and last where they are, and no beat else; a beat
// that is offered stays; while its output is taken, a plan that waits gets a beat every cycle.
// level_of_detail, which walk passes on, carries the plan's count, and the tag's lowest bit whether its number is odd.
`default_nettype none

module feline_proof_walk_stream (
  input  wire logic                                 clk_i,
  input  wire logic                                 rst_i,
  input  wire logic                                 valid_i,
  input  wire feline_pkg::plan_t                    beat_i,
  input  wire logic [feline_pkg::ProbeIndexWidth-1:0] most_i,  // probes less one
  input  wire logic                                 ready_i,
  output logic                                      broken_o
);
  localparam int unsigned IndexWidth = feline_pkg::ProbeIndexWidth;
  localparam int unsigned SentWidth  = feline_pkg::PlanBeatWidth + IndexWidth;

  feline_pkg::plan_t    any;
  feline_pkg::plan_t    plan;
  feline_pkg::walk_t    walk;
  logic                 offered;
  logic                 plan_ready;
  logic                 walk_valid;
  logic                 rst;
  logic [IndexWidth-1:0] most;
  logic                 in_odd_q;
  logic                 out_odd_q;
  logic [IndexWidth-1:0] probe_q;
  logic                 waited_q;
  logic                 due_q;
  feline_pkg::walk_t    walk_q;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));
  feline_proof_source #(.Width(SentWidth)) u_source (
    .clk_i, .rst_i(rst), .valid_i, .data_i({beat_i, most_i}), .valid_o(offered), .data_o({any, most}), .ready_i(plan_ready)
  );

  always_comb begin
    plan                 = any;
    plan.probes          = feline_pkg::ProbeCountWidth'(most) + 1'b1;
    plan.level_of_detail = feline_pkg::SampledLevelWidth'(most);
    plan.tag             = '0;
    plan.tag[0]          = in_odd_q;
  end

  feline_walk u_walk (
    .clk_i, .rst_i(rst), .plan_valid_i(offered), .plan_ready_o(plan_ready), .plan_i(plan),
    .walk_valid_o(walk_valid), .walk_ready_i(ready_i), .walk_o(walk)
  );

  always_ff @(posedge clk_i) begin
    if (rst) begin
      in_odd_q  <= 1'b0;
      out_odd_q <= 1'b0;
      probe_q   <= '0;
      waited_q  <= 1'b0;
      due_q     <= 1'b0;
    end else begin
      if (offered && plan_ready) in_odd_q <= !in_odd_q;
      if (walk_valid && ready_i) begin
        probe_q <= walk.last ? '0 : probe_q + 1'b1;
        if (walk.last) out_odd_q <= !out_odd_q;
      end
      waited_q <= walk_valid && !ready_i;
      due_q    <= offered && ready_i;
    end
    walk_q <= walk;
  end

  assign broken_o = !rst && ((waited_q && (!walk_valid || walk != walk_q)) || (due_q && !walk_valid) ||
                             (walk_valid && (walk.probe != probe_q || walk.first != (probe_q == '0) ||
                                             walk.last != (probe_q == walk.level_of_detail[IndexWidth-1:0]) ||
                                             walk.tag[0] != out_odd_q)));
endmodule

`default_nettype wire
