// SPDX-License-Identifier: Apache-2.0
// The unit: one lookup through the eight stages, group, footprint, plan, walk, address, fetch, filter, accumulate.
//
// Takes  requests, in order; the sampler state, which is held still while busy_o; memory lines.
// Gives  one pixel a request, in order; beside it every stage's boundary for whoever watches: bit k of offered_o says
//        that stage k's beat is valid, bit k of taken_o that it is transferred in this cycle. The fingerprint of
//        configuration, formats and beats.
// Edges  back-pressure anywhere, at any cycle. flush_i, only while not busy_o, forgets the texture's lines. rst_i, at any
//        cycle, forgets every lookup inside; the memory forgets what was asked of it in the same cycle. A memory
//        response is taken in the cycle in which it comes, if that is later than its request.
// Timing one probe a cycle while its lines are in the cache. accumulate_ready_i does not reach request_ready_o within
//        the cycle.
// Source WRL 99/1, 3 (Feline); CS248A lecture 4 (texture unit).
`default_nettype none

module feline_unit (
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
  logic              group_valid;
  logic              group_ready;
  logic              footprint_valid;
  logic              footprint_ready;
  logic              plan_valid;
  logic              plan_ready;
  logic              walk_valid;
  logic              walk_ready;
  logic              spilled_valid;
  logic              spilled_ready;
  feline_pkg::walk_t spilled;
  logic              address_valid;
  logic              address_ready;
  logic              fetch_valid;
  logic              fetch_ready;
  logic              filter_valid;
  logic              filter_ready;

  feline_group u_group (
    .clk_i, .rst_i, .sampler_i,
    .request_valid_i, .request_ready_o, .request_i,
    .group_valid_o(group_valid), .group_ready_i(group_ready), .group_o
  );

  feline_footprint u_footprint (
    .clk_i, .rst_i, .sampler_i,
    .group_valid_i(group_valid), .group_ready_o(group_ready), .group_i(group_o),
    .footprint_valid_o(footprint_valid), .footprint_ready_i(footprint_ready), .footprint_o
  );

  feline_plan u_plan (
    .clk_i, .rst_i, .sampler_i,
    .footprint_valid_i(footprint_valid), .footprint_ready_o(footprint_ready), .footprint_i(footprint_o),
    .plan_valid_o(plan_valid), .plan_ready_i(plan_ready), .plan_o
  );

  feline_walk u_walk (
    .clk_i, .rst_i,
    .plan_valid_i(plan_valid), .plan_ready_o(plan_ready), .plan_i(plan_o),
    .walk_valid_o(walk_valid), .walk_ready_i(walk_ready), .walk_o
  );

  // Cuts ready between the halves: here the beat is narrow, the chain of readies about even on both sides, and what
  // stops most often, a missing line in fetch, does not have to reach walk's counter and the front in the same cycle.
  feline_spill_register #(.Width(feline_pkg::WalkBeatWidth)) u_spill (
    .clk_i, .rst_i,
    .valid_i(walk_valid), .ready_o(walk_ready), .data_i(walk_o),
    .valid_o(spilled_valid), .ready_i(spilled_ready), .data_o(spilled)
  );

  feline_address u_address (
    .clk_i, .rst_i, .sampler_i,
    .walk_valid_i(spilled_valid), .walk_ready_o(spilled_ready), .walk_i(spilled),
    .address_valid_o(address_valid), .address_ready_i(address_ready), .address_o
  );

  feline_fetch u_fetch (
    .clk_i, .rst_i, .sampler_i, .flush_i,
    .address_valid_i(address_valid), .address_ready_o(address_ready), .address_i(address_o),
    .fetch_valid_o(fetch_valid), .fetch_ready_i(fetch_ready), .fetch_o,
    .memory_request_valid_o, .memory_request_ready_i, .memory_request_line_o,
    .memory_response_valid_i, .memory_response_ready_o, .memory_response_data_i
  );

  feline_filter u_filter (
    .clk_i, .rst_i, .sampler_i,
    .fetch_valid_i(fetch_valid), .fetch_ready_o(fetch_ready), .fetch_i(fetch_o),
    .filter_valid_o(filter_valid), .filter_ready_i(filter_ready), .filter_o
  );

  feline_accumulate u_accumulate (
    .clk_i, .rst_i,
    .filter_valid_i(filter_valid), .filter_ready_o(filter_ready), .filter_i(filter_o),
    .accumulate_valid_o, .accumulate_ready_i, .accumulate_o
  );

  assign fingerprint_o = feline_pkg::Fingerprint;
  assign offered_o = {accumulate_valid_o, filter_valid, fetch_valid, address_valid, walk_valid, plan_valid,
                      footprint_valid, group_valid};
  assign taken_o   = offered_o & {accumulate_ready_i, filter_ready, fetch_ready, address_ready, walk_ready, plan_ready,
                                  footprint_ready, group_ready};

  // Lookups in flight: requests taken less pixels taken. At most one in each register: two in group, three in footprint,
  // five in plan, one in walk, two in the spill register, four in address, two in fetch, three in filter, two in
  // accumulate.
  localparam int unsigned MostInFlight  = 2 + 3 + 5 + 1 + 2 + 4 + 2 + 3 + 2;
  localparam int unsigned InFlightWidth = $clog2(MostInFlight + 1);

  logic [InFlightWidth-1:0] in_flight_q;
  logic                     enters;
  logic                     leaves;

  assign enters = request_valid_i && request_ready_o;
  assign leaves = accumulate_valid_o && accumulate_ready_i;
  assign busy_o = in_flight_q != '0;

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      in_flight_q <= '0;
    end else if (enters != leaves) begin
      in_flight_q <= enters ? in_flight_q + 1'b1 : in_flight_q - 1'b1;
    end
  end
endmodule

`default_nettype wire
