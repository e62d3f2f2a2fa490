// SPDX-License-Identifier: Apache-2.0
// Whether a stage keeps the rules of its streams: beats in, as many out, in order, what passes through unchanged, none
// changed while it waits, and always some progress.
//
// Takes  a transfer in and a transfer out; mark_i of a beat that enters, free, of which the first one counts; what of a
//        beat passes through, as it enters and as it leaves; mark of the beat that leaves; all of the beat that leaves.
//        progress_i: what the stage waits for besides, such as a memory that answers; else 1.
// Gives  broken_o: a beat that was offered went away or changed; a beat came out that never went in; the marked beat
//        came out too early, too late, twice, not as the one it should be, or with something else passed through; more
//        than Depth are inside; a beat is inside, or offered, and none came out in Patience cycles in which it could; or
//        the stage stopped its input in a cycle, or after one with Cut, in which its output was taken.
// As the mark may be on any beat, what holds for it holds for all.
`default_nettype none

module feline_stream_checker #(
  parameter int unsigned Width    = 1,
  parameter int unsigned Payload  = 1,
  parameter int unsigned Depth    = 1,
  parameter int unsigned Patience = Depth + 1,
  parameter bit          Cut      = 1'b0,  // ready comes from a register
  parameter bit          Waits    = 1'b0   // the stage may stop its input by itself
) (
  input  wire logic               clk_i,
  input  wire logic               rst_i,
  input  wire logic               progress_i,
  input  wire logic               in_valid_i,
  input  wire logic               in_ready_i,
  input  wire logic [Payload-1:0] in_payload_i,
  input  wire logic               mark_i,
  output logic                    mark_o,    // what the beat that enters carries
  input  wire logic               out_valid_i,
  input  wire logic               out_ready_i,
  input  wire logic [Payload-1:0] out_payload_i,
  input  wire logic               out_mark_i,
  input  wire logic [Width-1:0]   out_data_i,
  output logic                    broken_o
);
  localparam int unsigned CountWidth = $clog2(Depth + 2);
  localparam int unsigned IdleWidth  = $clog2(Patience + 2);

  logic                  offered_q;
  logic [Width-1:0]      data_q;
  logic                  marked_q;   // the mark has been given
  logic                  waits_q;    // the marked beat is inside
  logic [Payload-1:0]    payload_q;  // of the marked beat
  logic [CountWidth-1:0] inside_q;
  logic [CountWidth-1:0] ahead_q;    // of the marked beat
  logic                  taken_q;    // the output was taken in the cycle before, or would have been
  logic [IdleWidth-1:0]  idle_q;     // cycles in which a beat could have come out
  logic                  enters;
  logic                  leaves;
  logic                  marks;
  logic                  is_due;

  assign enters = in_valid_i && in_ready_i;
  assign leaves = out_valid_i && out_ready_i;
  assign mark_o = mark_i && !marked_q;
  assign marks  = enters && mark_o;
  assign is_due = waits_q && ahead_q == '0;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      offered_q <= 1'b0;
      marked_q  <= 1'b0;
      waits_q   <= 1'b0;
      inside_q  <= '0;
      taken_q   <= 1'b1;
      idle_q    <= '0;
    end else begin
      offered_q <= out_valid_i && !out_ready_i;
      marked_q  <= marked_q || marks;
      waits_q   <= (waits_q && !(leaves && is_due)) || marks;
      inside_q  <= inside_q + CountWidth'(enters) - CountWidth'(leaves);
      taken_q   <= out_ready_i;
      idle_q    <= leaves || !out_ready_i || !progress_i || (inside_q == '0 && !in_valid_i) ? '0 : idle_q + IdleWidth'(1);
    end
    data_q  <= out_data_i;
    ahead_q <= marks ? inside_q - CountWidth'(leaves) : ahead_q - CountWidth'(leaves && ahead_q != '0);
    if (marks) payload_q <= in_payload_i;
  end

  assign broken_o = !rst_i && ((offered_q && (!out_valid_i || out_data_i != data_q)) ||
                               (leaves && inside_q == '0) ||
                               (leaves && out_mark_i != is_due) ||
                               (leaves && is_due && out_payload_i != payload_q) ||
                               (32'(inside_q) > Depth) ||
                               (32'(idle_q) > Patience) ||
                               (!Waits && (Cut ? taken_q : out_ready_i) && !in_ready_i));
endmodule

`default_nettype wire
