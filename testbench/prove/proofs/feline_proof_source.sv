// SPDX-License-Identifier: Apache-2.0
// Any stream that keeps the rules: what it offers stays until it is taken.
`default_nettype none

module feline_proof_source #(
  parameter int unsigned Width = 1
) (
  input  wire logic             clk_i,
  input  wire logic             rst_i,
  input  wire logic             valid_i,
  input  wire logic [Width-1:0] data_i,
  output logic                  valid_o,
  output logic [Width-1:0]      data_o,
  input  wire logic             ready_i
);
  logic             valid_q;
  logic [Width-1:0] data_q;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      valid_q <= 1'b0;
    end else if (!valid_q || ready_i) begin
      valid_q <= valid_i;
    end
    if (!valid_q || ready_i) data_q <= data_i;
  end

  assign valid_o = valid_q;
  assign data_o  = data_q;
endmodule

`default_nettype wire
