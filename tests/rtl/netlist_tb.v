// SPDX-License-Identifier: Apache-2.0
// Plays golden vectors (feline vectors) through the unit's netlist and compares the pixels. Plain Verilog, for Icarus.
`timescale 1ns / 1ps
`default_nettype none

module netlist_tb;
  parameter integer Requests = 1;
  parameter integer Lines = 1;
  // Widths in bits, as the heads of the vector files tell them.
  parameter integer SamplerWidth = 1;
  parameter integer RequestWidth = 1;
  parameter integer PixelWidth = 1;
  parameter integer LineWidth = 1;
  localparam integer Patience = 20000;

  reg          clk = 1'b0;
  reg          rst = 1'b1;
  reg [SamplerWidth-1:0] sampler [0:0];
  reg [RequestWidth-1:0] request [0:Requests-1];
  reg [PixelWidth-1:0] pixel [0:Requests-1];
  reg [511:0]  memory [0:Lines-1];

  wire         request_ready;
  wire         pixel_valid;
  wire [PixelWidth-1:0] pixel_got;
  wire         memory_request_valid;
  wire [LineWidth-1:0] memory_request_line;
  wire         memory_response_ready;
  reg          memory_response_valid = 1'b0;
  reg [511:0]  memory_response_data = 512'd0;
  reg          memory_ready = 1'b0;
  reg          pixel_ready = 1'b0;
  integer      stalls = 1;
  integer      offered = 0;
  integer      taken = 0;
  integer      idle = 0;
  integer      wrong = 0;

  feline_unit u_unit (
    .clk_i(clk), .rst_i(rst), .sampler_i(sampler[0]), .flush_i(1'b0),
    .request_valid_i(!rst && offered < Requests), .request_ready_o(request_ready),
    .request_i(request[offered < Requests ? offered : 0]),
    .memory_request_valid_o(memory_request_valid), .memory_request_ready_i(memory_ready),
    .memory_request_line_o(memory_request_line),
    .memory_response_valid_i(memory_response_valid), .memory_response_ready_o(memory_response_ready),
    .memory_response_data_i(memory_response_data),
    .accumulate_valid_o(pixel_valid), .accumulate_ready_i(pixel_ready), .accumulate_o(pixel_got)
  );

  always #5 clk = !clk;

  always @(posedge clk) begin
    if (!rst) begin
      if (offered < Requests && request_ready) offered <= offered + 1;
      memory_ready <= $random(stalls);
      pixel_ready  <= $random(stalls);
      if (memory_request_valid && memory_ready) begin
        memory_response_valid <= 1'b1;
        memory_response_data  <= memory[memory_request_line];
      end else if (memory_response_ready) begin
        memory_response_valid <= 1'b0;
      end
      idle <= pixel_valid && pixel_ready ? 0 : idle + 1;
      if (pixel_valid && pixel_ready) begin
        // X in the result differs, too: !== compares four values.
        if (pixel_got !== pixel[taken]) begin
          $display("FAIL: pixel %0d: netlist %h, model %h", taken, pixel_got, pixel[taken]);
          wrong = wrong + 1;
        end
        taken = taken + 1;
        if (taken == Requests) begin
          if (wrong == 0) $display("PASS: %0d pixels", taken);
          $finish;
        end
      end else if (idle > Patience) begin
        $display("FAIL: no pixel for %0d cycles after %0d pixels", Patience, taken);
        $finish;
      end
    end
  end

  initial begin
    $readmemh("sampler.hex", sampler);
    $readmemh("request.hex", request);
    $readmemh("accumulate.hex", pixel);
    $readmemh("memory.hex", memory);
    repeat (4) @(posedge clk);
    #1 rst = 1'b0;
  end
endmodule
