// SPDX-License-Identifier: Apache-2.0
// accumulate: the weighted probes of a pixel to its colour, rounded once.
//
// Takes  colour U8.28, unit 1/255, and weight U1.8 of each probe; first and last.
// Gives  colour U8.8, unit 1/255, with the last probe, and the status bits of all; other probes are absorbed.
// Rounds the exact weighted sum, U8.36, to 8 fraction bits: nearest, ties up. Weights sum to exactly one, so equal
//        texels come back exactly, and the result lies within the texels that have weight: every texel is a multiple of
//        the result's last bit, and rounding to its multiples is monotone.
// Edges  first starts the sum anew, whatever was there. A channel that the configuration leaves out is 0, alpha one,
//        even where weights are missing.
// Timing two registers: weighted | sum. A beat each cycle.
// Source WRL 99/1, 3.1 (accumulation), 3.2 (weights that sum to one).
`default_nettype none

module feline_accumulate (
  input  wire logic                    clk_i,
  input  wire logic                    rst_i,
  input  wire logic                    filter_valid_i,
  output logic                         filter_ready_o,
  input  wire feline_pkg::filter_t     filter_i,
  output logic                         accumulate_valid_o,
  input  wire logic                    accumulate_ready_i,
  output feline_pkg::accumulate_t      accumulate_o
);
  localparam int unsigned SumWidth = feline_pkg::AccumulatedWidth;
  localparam int unsigned Dropped  = feline_pkg::AccumulatedFraction - feline_pkg::PixelFraction;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]    tag;
    logic [feline_pkg::StatusWidth-1:0] status;
    logic                               first;
    logic                               last;
    logic [4*SumWidth-1:0]              colour;
  } weighted_t;

  logic unused_probe;
  assign unused_probe = ^filter_i.probe;

  logic [4*SumWidth-1:0] product;
  weighted_t             weighted_d;
  weighted_t             weighted_q;
  logic                  weighted_valid;
  logic                  weighted_ready;

  for (genvar c = 0; c < 4; c++) begin : gen_product
    if (feline_pkg::HasChannel[c]) begin : gen_weighted
      assign product[c*SumWidth +: SumWidth] = SumWidth'(filter_i.colour[c]) * SumWidth'(filter_i.weight);
    end else begin : gen_constant
      assign product[c*SumWidth +: SumWidth] = '0;

      logic unused_colour;
      assign unused_colour = ^filter_i.colour[c];
    end
  end

  always_comb begin
    weighted_d.tag    = filter_i.tag;
    weighted_d.status = filter_i.status;
    weighted_d.first  = filter_i.first;
    weighted_d.last   = filter_i.last;
    weighted_d.colour = product;
  end

  feline_stream_register #(.Width($bits(weighted_d))) u_weighted (
    .clk_i, .rst_i,
    .valid_i(filter_valid_i), .ready_o(filter_ready_o), .data_i(weighted_d),
    .valid_o(weighted_valid), .ready_i(weighted_ready), .data_o(weighted_q)
  );

  // The sum starts at half of the pixel's last bit: what is left after dropping bits is then rounded.
  localparam logic [SumWidth-1:0] Half = SumWidth'(1) << (Dropped - 1);

  logic [4*SumWidth-1:0]               sum_q;
  logic [4*SumWidth-1:0]               sum_d;
  logic [4*feline_pkg::PixelWidth-1:0] colour;
  feline_pkg::accumulate_t             beat;
  logic                                beat_ready;

  for (genvar c = 0; c < 4; c++) begin : gen_sum
    if (feline_pkg::HasChannel[c]) begin : gen_weighted
      logic [SumWidth-1:0] carried;
      logic [SumWidth-1:0] sum;

      assign carried = weighted_q.first ? Half : sum_q[c*SumWidth +: SumWidth];
      assign sum     = carried + weighted_q.colour[c*SumWidth +: SumWidth];
      assign sum_d[c*SumWidth +: SumWidth] = sum;
      assign colour[c*feline_pkg::PixelWidth +: feline_pkg::PixelWidth] = feline_pkg::PixelWidth'(sum >> Dropped);
    end else begin : gen_constant
      // Of a channel that the configuration has no place for: 0, alpha one.
      assign sum_d[c*SumWidth +: SumWidth] = '0;
      assign colour[c*feline_pkg::PixelWidth +: feline_pkg::PixelWidth] =
          c == 3 ? {8'hff, feline_pkg::PixelFraction'(0)} : '0;

      logic unused_sum;
      assign unused_sum = ^{weighted_q.colour[c*SumWidth +: SumWidth], sum_q[c*SumWidth +: SumWidth]};
    end
  end

  assign weighted_ready = beat_ready || !weighted_q.last;

  always_ff @(posedge clk_i) begin
    // After the last probe the sum starts anew.
    if (weighted_valid && !weighted_q.last) sum_q <= sum_d;
  end

  // Only texels can make one probe's status differ from another's.
  logic [feline_pkg::StatusWidth-1:0] status;

  if (feline_pkg::FeatureAlpha) begin : gen_status
    assign status = weighted_q.status;
  end else begin : gen_status_of_all
    logic [feline_pkg::StatusWidth-1:0] status_q;

    assign status = weighted_q.status | (status_q & {feline_pkg::StatusWidth{!weighted_q.first}});

    always_ff @(posedge clk_i) begin
      if (weighted_valid && !weighted_q.last) status_q <= status;
    end
  end

  always_comb begin
    beat.tag    = weighted_q.tag;
    beat.status = status;
    beat.colour = colour;
  end

  feline_stream_register #(.Width(feline_pkg::AccumulateBeatWidth)) u_output (
    .clk_i, .rst_i,
    .valid_i(weighted_valid && weighted_q.last), .ready_o(beat_ready), .data_i(beat),
    .valid_o(accumulate_valid_o), .ready_i(accumulate_ready_i), .data_o(accumulate_o)
  );
endmodule

`default_nettype wire
