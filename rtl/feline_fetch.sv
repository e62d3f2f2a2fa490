// SPDX-License-Identifier: Apache-2.0
// fetch: lines to eight texels.
//
// Takes  lines, texel indices and outside bits of two levels; texel format, sRGB, border colour; memory.
// Gives  eight texels of red, green, blue, alpha U8.4, unit 1/255; fractions as they came.
// Rounds sRGB decoding of red, green, blue: to nearest, by table. Other texels are exact: code * 16.
// Edges  R8 gives (r, 0, 0, 1), RG8 (r, g, 0, 1); alpha is never decoded; a texel outside is the sampler state's border
//        colour, which is linear and has the format's channels only. Texels of a coarse level that is not used are 0.
// Memory requests of single lines, responses in order, byte k of a line in bits 8k+7 .. 8k; one request at a time. A
//        beat whose lines are all present passes in a cycle; otherwise it waits while its lines come, one by one.
//        flush_i, only while no beat is inside, forgets every line.
// Timing two registers: words of the lines | texels.
// Source CS248A lecture 4, step 6; IEC 61966-2-1 (sRGB); OpenGL 4.6, 8.14.2 (border), table 15.1 (missing channels).
`default_nettype none

module feline_fetch #(
  parameter int unsigned Lines = 16  // of each half of the cache; a power of two, at least 4
) (
  input  wire logic                                          clk_i,
  input  wire logic                                          rst_i,
  input  wire feline_pkg::sampler_t                          sampler_i,
  input  wire logic                                          flush_i,
  input  wire logic                                          address_valid_i,
  output logic                                               address_ready_o,
  input  wire feline_pkg::address_t                          address_i,
  output logic                                               fetch_valid_o,
  input  wire logic                                          fetch_ready_i,
  output feline_pkg::fetch_t                                 fetch_o,
  output logic                                               memory_request_valid_o,
  input  wire logic                                          memory_request_ready_i,
  output logic [feline_pkg::LineWidth-1:0]                   memory_request_line_o,
  input  wire logic                                          memory_response_valid_i,
  output logic                                               memory_response_ready_o,
  input  wire logic [(32 << (2 * feline_pkg::TileLog2))-1:0] memory_response_data_i
);
  localparam int unsigned WordWidth    = 32;
  localparam int unsigned ChannelWidth = feline_pkg::ChannelWidth;
  localparam int unsigned TexelWidth   = 4 * ChannelWidth;
  localparam int unsigned ColumnWidth  = feline_pkg::TileLog2;

  // Texels 0 .. 3 are fine 00, 10, 01, 11, texels 4 .. 7 the same of the coarse level.
  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]           tag;
    logic [feline_pkg::StatusWidth-1:0]        status;
    logic [feline_pkg::ProbeIndexWidth-1:0]    probe;
    logic                                      first;
    logic                                      last;
    logic [feline_pkg::WeightWidth-1:0]        weight;
    logic                                      linear;
    logic [feline_pkg::LevelFractionWidth-1:0] level_fraction;
    logic [feline_pkg::TexelFractionWidth-1:0] fine_fraction_x;
    logic [feline_pkg::TexelFractionWidth-1:0] fine_fraction_y;
    logic [feline_pkg::TexelFractionWidth-1:0] coarse_fraction_x;
    logic [feline_pkg::TexelFractionWidth-1:0] coarse_fraction_y;
    logic [7:0]                                used;
    logic [7:0]                                outside;
    logic [4*ColumnWidth-1:0]                  column;
    logic [8*WordWidth-1:0]                    word;
  } words_t;

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;

  logic [feline_pkg::TexelFormatWidth-1:0] texel_format;

  feline_supported_format u_supported_format (
    .texel_format_i(sampler_i.texel_format), .texel_format_o(texel_format)
  );

  // The words of the texels.
  logic [7:0]               outside;
  logic [7:0]               used;
  logic [4*ColumnWidth-1:0] column;
  logic [8*WordWidth-1:0]   word;
  words_t                   words_d;
  words_t                   words_q;
  logic                     read_valid;
  logic                     read_ready;
  logic                     words_valid;
  logic                     words_ready;

  for (genvar i = 0; i < 4; i++) begin : gen_outside
    assign outside[i]     = address_i.fine_border[i % 2] || address_i.fine_border[2 + i / 2];
    assign outside[4 + i] = address_i.coarse_border[i % 2] || address_i.coarse_border[2 + i / 2];
  end
  assign used   = {{4{address_i.coarse_used}}, 4'b1111};
  assign column = {ColumnWidth'(address_i.coarse_x[1]), ColumnWidth'(address_i.coarse_x[0]),
                   ColumnWidth'(address_i.fine_x[1]), ColumnWidth'(address_i.fine_x[0])};

  feline_blocking_cache #(.Lines(Lines)) u_cache (
    .clk_i, .rst_i, .flush_i,
    .texel_format_i(texel_format),
    .texels_valid_i(address_valid_i), .texels_ready_o(address_ready_o),
    .odd_i(1'(address_i.level)),
    .x_i({address_i.coarse_x, address_i.fine_x}), .y_i({address_i.coarse_y, address_i.fine_y}),
    .line_i({address_i.coarse_line, address_i.fine_line}), .needed_i(used & ~outside),
    .words_valid_o(read_valid), .words_ready_i(read_ready), .word_o(word),
    .memory_request_valid_o, .memory_request_ready_i, .memory_request_line_o,
    .memory_response_valid_i, .memory_response_ready_o, .memory_response_data_i
  );

  always_comb begin
    words_d.tag               = address_i.tag;
    words_d.status            = address_i.status;
    words_d.probe             = address_i.probe;
    words_d.first             = address_i.first;
    words_d.last              = address_i.last;
    words_d.weight            = address_i.weight;
    words_d.linear            = address_i.linear;
    words_d.level_fraction    = address_i.level_fraction;
    words_d.fine_fraction_x   = address_i.fine_fraction_x;
    words_d.fine_fraction_y   = address_i.fine_fraction_y;
    words_d.coarse_fraction_x = address_i.coarse_fraction_x;
    words_d.coarse_fraction_y = address_i.coarse_fraction_y;
    words_d.used              = used;
    words_d.outside           = outside;
    words_d.column            = column;
    words_d.word              = word;
  end

  feline_stream_register #(.Width($bits(words_d))) u_words (
    .clk_i, .rst_i,
    .valid_i(read_valid), .ready_o(read_ready), .data_i(words_d),
    .valid_o(words_valid), .ready_i(words_ready), .data_o(words_q)
  );

  // The texels in them. `missing`: alpha where the configuration has no place for it.
  localparam logic [ChannelWidth-1:0] Opaque = {8'hff, feline_pkg::ChannelFraction'(0)};

  logic [7:0]              transparent;
  logic                    missing;
  logic [8*TexelWidth-1:0] texel;
  feline_pkg::fetch_t      beat;

  for (genvar i = 0; i < 8; i++) begin : gen_texel
    logic [TexelWidth-1:0] decoded;
    logic [TexelWidth-1:0] read;

    feline_decode_texel u_decode (
      .word_i(words_q.word[i*WordWidth +: WordWidth]),
      .column_i(words_q.column[(i / 4 * 2 + i % 2)*ColumnWidth +: ColumnWidth]),
      .texel_format_i(texel_format), .srgb_i(sampler_i.srgb), .texel_o(decoded)
    );

    assign read = !words_q.used[i] ? '0 : words_q.outside[i] ? sampler_i.border : decoded;

    // What the configuration has no channel for is 0, alpha one.
    for (genvar c = 0; c < 4; c++) begin : gen_channel
      if (feline_pkg::HasChannel[c]) begin : gen_read
        assign texel[i*TexelWidth + c*ChannelWidth +: ChannelWidth] = read[c*ChannelWidth +: ChannelWidth];
      end else begin : gen_constant
        assign texel[i*TexelWidth + c*ChannelWidth +: ChannelWidth] = c == 3 && words_q.used[i] ? Opaque : '0;
      end
    end

    assign transparent[i] = words_q.used[i] && read[3*ChannelWidth +: ChannelWidth] != Opaque;
  end

  if (feline_pkg::HasChannel[2] && !feline_pkg::HasChannel[3]) begin : gen_opaque
    assign missing = transparent != '0;
  end else begin : gen_alpha
    assign missing = 1'b0;

    logic unused_transparent;
    assign unused_transparent = ^transparent;
  end

  always_comb begin
    beat.tag               = words_q.tag;
    beat.status            = words_q.status;
    beat.status[feline_pkg::StatusUnsupported] = words_q.status[feline_pkg::StatusUnsupported] | missing;
    beat.probe             = words_q.probe;
    beat.first             = words_q.first;
    beat.last              = words_q.last;
    beat.weight            = words_q.weight;
    beat.linear            = words_q.linear;
    beat.level_fraction    = words_q.level_fraction;
    beat.fine_fraction_x   = words_q.fine_fraction_x;
    beat.fine_fraction_y   = words_q.fine_fraction_y;
    beat.coarse_fraction_x = words_q.coarse_fraction_x;
    beat.coarse_fraction_y = words_q.coarse_fraction_y;
    beat.fine_00           = texel[0*TexelWidth +: TexelWidth];
    beat.fine_10           = texel[1*TexelWidth +: TexelWidth];
    beat.fine_01           = texel[2*TexelWidth +: TexelWidth];
    beat.fine_11           = texel[3*TexelWidth +: TexelWidth];
    beat.coarse_00         = texel[4*TexelWidth +: TexelWidth];
    beat.coarse_10         = texel[5*TexelWidth +: TexelWidth];
    beat.coarse_01         = texel[6*TexelWidth +: TexelWidth];
    beat.coarse_11         = texel[7*TexelWidth +: TexelWidth];
  end

  feline_stream_register #(.Width(feline_pkg::FetchBeatWidth)) u_output (
    .clk_i, .rst_i,
    .valid_i(words_valid), .ready_o(words_ready), .data_i(beat),
    .valid_o(fetch_valid_o), .ready_i(fetch_ready_i), .data_o(fetch_o)
  );
endmodule

`default_nettype wire
