// SPDX-License-Identifier: Apache-2.0
// One register in a valid/ready stream: cuts valid and data, passes ready. Full throughput.
//
// The rules of every stream here: a transfer happens in a cycle where valid and ready are both high; valid never waits
// for ready; once valid is high, valid and data stay until they are taken; ready may change at any time.
`default_nettype none

module feline_stream_register #(
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
  logic [Width-1:0] data_q;

  assign ready_o = !valid_q || ready_i;
  assign valid_o = valid_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      valid_q <= 1'b0;
    end else if (ready_o) begin
      valid_q <= valid_i;
    end
    if (ready_o && valid_i) data_q <= data_i;
  end
endmodule

`default_nettype wire
