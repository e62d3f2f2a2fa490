// SPDX-License-Identifier: Apache-2.0
// A port of a cell, with a fault when the mutant says so: site, kind, bit and control from the least bit in 16, 4, 12
// and 16 bits (testbench/mutation/mutant.h). Kinds: inverted, zero, one, inverted when the control bit is zero, or one.
`default_nettype none

module feline_mutation_site #(
  parameter int unsigned Width = 1,
  parameter int unsigned Site  = 1
) (
  input  wire logic [63:0]      mutant_i,
  input  wire logic [Width-1:0] data_i,
  output logic [Width-1:0]      data_o
);
  logic [Width-1:0] mask;
  logic             control;

  assign mask    = Width'(1) << mutant_i[31:20];
  assign control = 1'(data_i >> mutant_i[47:32]);

  always_comb begin
    data_o = data_i;
    if (mutant_i[15:0] == 16'(Site)) begin
      case (mutant_i[19:16])
        4'd0: data_o = data_i ^ mask;
        4'd1: data_o = data_i & ~mask;
        4'd2: data_o = data_i | mask;
        4'd3: data_o = control ? data_i : data_i ^ mask;
        4'd4: data_o = control ? data_i ^ mask : data_i;
        default: data_o = data_i;
      endcase
    end
  end
endmodule

`default_nettype wire
