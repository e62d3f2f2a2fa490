// SPDX-License-Identifier: Apache-2.0
// Wires in place of the register of rtl/feline_stream_register.sv: a stage without state is then a function.
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
  assign ready_o = ready_i;
  assign valid_o = valid_i;
  assign data_o  = data_i;

  logic unused_clock;
  assign unused_clock = ^{clk_i, rst_i};
endmodule

`default_nettype wire
