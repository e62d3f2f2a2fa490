// SPDX-License-Identifier: Apache-2.0
// The unit as the bench drives it: every input comes out of a register. A cycle then costs one evaluation instead of
// two: inputs change at the clock edge only, together with everything that depends on them.
//
// Memory memory_zero_latency_i: a request that is taken in this cycle has its response in it. The data come in the next
//        cycle, with memory_response_valid_i: the unit takes no response in the cycle of its request.
`default_nettype none

module feline_bench (
  input  wire logic                                          clk_i,
  input  wire logic                                          rst_i,
  input  wire feline_pkg::sampler_t                          sampler_i,
  input  wire logic                                          flush_i,
  output logic                                               busy_o,
  input  wire logic                                          request_valid_i,
  output logic                                               request_ready_o,
  input  wire feline_pkg::request_t                          request_i,
  output logic                                               memory_request_valid_o,
  input  wire logic                                          memory_request_ready_i,
  output logic [feline_pkg::LineWidth-1:0]                   memory_request_line_o,
  input  wire logic                                          memory_zero_latency_i,
  input  wire logic                                          memory_response_valid_i,
  output logic                                               memory_response_ready_o,
  input  wire logic [(32 << (2 * feline_pkg::TileLog2))-1:0] memory_response_data_i,
  output logic                                               accumulate_valid_o,
  input  wire logic                                          accumulate_ready_i,
  output feline_pkg::accumulate_t                            accumulate_o,
  output logic [7:0]                                         offered_o,
  output logic [7:0]                                         taken_o,
  output feline_pkg::group_t                                 group_o,
  output feline_pkg::footprint_t                             footprint_o,
  output feline_pkg::plan_t                                  plan_o,
  output feline_pkg::walk_t                                  walk_o,
  output feline_pkg::address_t                               address_o,
  output feline_pkg::fetch_t                                 fetch_o,
  output feline_pkg::filter_t                                filter_o,
  output logic [63:0]                                        fingerprint_o
);
  logic                                          rst_q;
  feline_pkg::sampler_t                          sampler_q;
  logic                                          flush_q;
  logic                                          request_valid_q;
  feline_pkg::request_t                          request_q;
  logic                                          memory_request_ready_q;
  logic                                          memory_zero_latency_q;
  logic                                          memory_response_valid_q;
  logic                                          memory_response_valid;
  logic [(32 << (2 * feline_pkg::TileLog2))-1:0] memory_response_data_q;
  logic                                          accumulate_ready_q;

  always_ff @(posedge clk_i) begin
    rst_q <= rst_i;
    sampler_q <= sampler_i;
    flush_q <= flush_i;
    request_valid_q <= request_valid_i;
    request_q <= request_i;
    memory_request_ready_q <= memory_request_ready_i;
    memory_zero_latency_q <= memory_zero_latency_i;
    memory_response_valid_q <= memory_response_valid_i;
    memory_response_data_q <= memory_response_data_i;
    accumulate_ready_q <= accumulate_ready_i;
  end

  assign memory_response_valid =
      memory_response_valid_q || (memory_zero_latency_q && memory_request_valid_o && memory_request_ready_q);

  feline_unit u_unit (
    .clk_i,
    .rst_i(rst_q),
    .sampler_i(sampler_q),
    .flush_i(flush_q),
    .request_valid_i(request_valid_q),
    .request_i(request_q),
    .memory_request_ready_i(memory_request_ready_q),
    .memory_response_valid_i(memory_response_valid),
    .memory_response_data_i(memory_response_data_q),
    .accumulate_ready_i(accumulate_ready_q),
    .busy_o, .request_ready_o, .memory_request_valid_o, .memory_request_line_o, .memory_response_ready_o,
    .accumulate_valid_o, .accumulate_o, .offered_o, .taken_o, .group_o, .footprint_o, .plan_o, .walk_o, .address_o, .fetch_o,
    .filter_o, .fingerprint_o
  );
endmodule

`default_nettype wire
