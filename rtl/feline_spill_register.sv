// SPDX-License-Identifier: Apache-2.0
// Two registers in a valid/ready stream: cuts valid, data and ready. Full throughput, one cycle.
//
// The second register holds the beat that arrives in the cycle in which ready_i falls, so that ready_o may come from a
// flip-flop. The rules of the stream are those of feline_stream_register.
`default_nettype none

module feline_spill_register #(
  parameter int unsigned Width = 1
) (
  input  wire logic             clk_i,
  input  wire logic             rst_i,
  input  wire logic             valid_i,
  output logic                  ready_o,
  input  wire logic [Width-1:0] data_i,
  output logic                  valid_o,
  input  wire logic             ready_i,
  output logic [Width-1:0]      data_o
);
  logic             valid_q;
  logic             spilled_q;
  logic [Width-1:0] data_q;
  logic [Width-1:0] spilled_data_q;
  logic             moves;

  assign moves   = !valid_q || ready_i;
  assign ready_o = !spilled_q;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      valid_q   <= 1'b0;
      spilled_q <= 1'b0;
    end else if (moves) begin
      valid_q   <= spilled_q || valid_i;
      spilled_q <= 1'b0;
    end else if (valid_i) begin
      spilled_q <= 1'b1;
    end
    // Data moves with its beat only, so that nothing toggles for nothing.
    if (moves && (spilled_q || valid_i)) data_q <= spilled_q ? spilled_data_q : data_i;
    if (!moves && !spilled_q && valid_i) spilled_data_q <= data_i;
  end
endmodule

`default_nettype wire
