// SPDX-License-Identifier: Apache-2.0
// walk: one plan to one beat a probe.
//
// Takes  s, t S20.24 and half_step_s, half_step_t S19.24 textures; probes; weight_row.
// Gives  for probe i = 0 .. probes - 1, n = 2i - (probes - 1): position + n * half step, S20.24; its weight U1.8;
//        first and last.
// Rounds nothing. Positions are modulo 2^21, which only the repeats can reach.
// Edges  one probe: the position itself, weight one.
// Timing one register; a beat each cycle, the plan is taken with its last probe.
// Source WRL 99/1, 3.1 (positions, figures 10 and 11), 3.2 (weights: row by fProbes, column floor((|n| + 1)/2)).
`default_nettype none

module feline_walk (
  input  wire logic              clk_i,
  input  wire logic              rst_i,
  input  wire logic              plan_valid_i,
  output logic                   plan_ready_o,
  input  wire feline_pkg::plan_t plan_i,
  output logic                   walk_valid_o,
  input  wire logic              walk_ready_i,
  output feline_pkg::walk_t      walk_o
);
  localparam int unsigned StepWidth = feline_pkg::ProbeCountWidth + 1;

  logic [feline_pkg::ProbeIndexWidth-1:0] probe_q;
  logic                                   last;
  logic signed [StepWidth-1:0]            n;
  logic [feline_pkg::WeightWidth-1:0]     weight;
  logic                                   present;
  logic [feline_pkg::PositionWidth-1:0]   s;
  logic [feline_pkg::PositionWidth-1:0]   t;
  feline_pkg::walk_t                      beat;
  logic                                   beat_ready;

  assign last = StepWidth'(probe_q) + StepWidth'(1) == StepWidth'(plan_i.probes);

  feline_probe_weight u_probe_weight (
    .probe_i(probe_q), .probes_i(plan_i.probes), .weight_row_i(plan_i.weight_row), .n_o(n), .weight_o(weight),
    .present_o(present)
  );
  feline_probe_position u_s (
    .centre_i(plan_i.s), .half_step_i(plan_i.half_step_s), .n_i(n), .position_o(s)
  );
  feline_probe_position u_t (
    .centre_i(plan_i.t), .half_step_i(plan_i.half_step_t), .n_i(n), .position_o(t)
  );

  always_comb begin
    beat.tag             = plan_i.tag;
    beat.status          = plan_i.status;
    beat.status[feline_pkg::StatusUnsupported] = plan_i.status[feline_pkg::StatusUnsupported] | !present;
    beat.probe           = probe_q;
    beat.first           = probe_q == '0;
    beat.last            = last;
    beat.s               = s;
    beat.t               = t;
    beat.weight          = weight;
    beat.level_of_detail = plan_i.level_of_detail;
    beat.linear          = plan_i.linear;
  end

  assign plan_ready_o = beat_ready && last;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      probe_q <= '0;
    end else if (plan_valid_i && beat_ready) begin
      probe_q <= last ? '0 : probe_q + 1'b1;
    end
  end

  feline_stream_register #(.Width(feline_pkg::WalkBeatWidth)) u_output (
    .clk_i, .rst_i,
    .valid_i(plan_valid_i), .ready_o(beat_ready), .data_i(beat),
    .valid_o(walk_valid_o), .ready_i(walk_ready_i), .data_o(walk_o)
  );
endmodule

`default_nettype wire
