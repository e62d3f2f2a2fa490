// SPDX-License-Identifier: Apache-2.0
// footprint: four mantissas to the major vector and both radii of the pixel's footprint.
//
// Takes  dudx, dvdx, dudy, dvdy S7.0 texel * 2^exponent; the mode.
// Gives  major_u, major_v S8.8 and major_radius, minor_radius U8.7, texel * 2^exponent.
//        nearest, bilinear, trilinear: both radii are the longer vector's length.
//        ext: the longer and the shorter length. simple: the longer length; the shortest of sides and diagonals.
//        table: the ellipse, through its table.
// Rounds lengths are exact; table: major_u, major_v are exact, both radii nearest, ties up.
// Edges  Equal lengths: y is the long vector. A zero shorter vector: ratio 0, column of 90 degrees. Cross or dot
//        product zero: the axes are the vectors themselves, nothing is turned. All zero: radii 0.
// Source WRL 99/1, 3.2 (lengths, Simple), 3.3 (Table, its rotation corrected: a counter-clockwise turn by 90 degrees
//        takes (u, v) to (-v, u)); EXT_texture_filter_anisotropic. Where 3.2 chooses a part of the length by b < 3a/8,
//        the larger part is taken here (model/footprint.h says why).
// Timing three registers: lengths and products | place in the table | ellipse.
`default_nettype none

module feline_footprint (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 group_valid_i,
  output logic                      group_ready_o,
  input  wire feline_pkg::group_t   group_i,
  output logic                      footprint_valid_o,
  input  wire logic                 footprint_ready_i,
  output feline_pkg::footprint_t    footprint_o
);
  localparam int unsigned MantissaWidth = feline_pkg::MantissaWidth;
  localparam int unsigned RadiusWidth   = feline_pkg::RadiusWidth;
  localparam int unsigned VectorWidth   = feline_pkg::VectorWidth;
  localparam int unsigned ProductWidth  = 2 * MantissaWidth;
  localparam int unsigned IndexWidth    = $clog2(feline_pkg::TableRows * feline_pkg::TableColumns);

  // What every step knows.
  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]             tag;
    logic [feline_pkg::StatusWidth-1:0]          status;
    logic signed [feline_pkg::PositionWidth-1:0] s;
    logic signed [feline_pkg::PositionWidth-1:0] t;
    logic signed [feline_pkg::ExponentWidth-1:0] exponent;
    logic signed [MantissaWidth-1:0]             longer_u;
    logic signed [MantissaWidth-1:0]             longer_v;
    logic [RadiusWidth-1:0]                      longer_length;
    logic [RadiusWidth-1:0]                      minor;  // mode table makes its own
  } longer_t;
  typedef struct packed {
    longer_t                        longer;
    logic                           x_is_longer;
    logic [RadiusWidth-1:0]         shorter_length;
    logic signed [ProductWidth-1:0] cross_product;
    logic signed [ProductWidth-1:0] dot_product;
  } products_t;
  typedef struct packed {
    longer_t               longer;
    logic [IndexWidth-1:0] index;
    logic                  turns;
    logic                  counter_clockwise;
  } place_t;

  logic [feline_pkg::ModeWidth-1:0] mode;

  feline_supported_mode u_supported_mode (.mode_i(sampler_i.mode), .mode_o(mode));

  // Lengths and products.
  products_t                          products_d;
  longer_t                            longer;
  logic                               unsupported;
  logic [feline_pkg::StatusWidth-1:0] status;

  feline_unsupported u_unsupported (.sampler_i, .unsupported_o(unsupported));
  always_comb begin
    status = group_i.status;
    status[feline_pkg::StatusUnsupported] = status[feline_pkg::StatusUnsupported] | unsupported;
  end

  assign longer.tag        = group_i.tag;
  assign longer.status     = status;
  assign longer.s          = group_i.s;
  assign longer.t          = group_i.t;
  assign longer.exponent   = group_i.exponent;
  assign products_d.longer = longer;

  feline_longer_vector u_longer_vector (
    .dudx_i(group_i.dudx), .dvdx_i(group_i.dvdx), .dudy_i(group_i.dudy), .dvdy_i(group_i.dvdy), .mode_i(mode),
    .u_o(longer.longer_u), .v_o(longer.longer_v), .length_o(longer.longer_length), .is_x_o(products_d.x_is_longer),
    .shorter_length_o(products_d.shorter_length), .minor_o(longer.minor)
  );

  if (feline_pkg::FeatureTableFeline) begin : gen_products
    assign products_d.cross_product = ProductWidth'($signed(group_i.dudx)) * ProductWidth'($signed(group_i.dvdy)) -
                                      ProductWidth'($signed(group_i.dvdx)) * ProductWidth'($signed(group_i.dudy));
    assign products_d.dot_product   = ProductWidth'($signed(group_i.dudx)) * ProductWidth'($signed(group_i.dudy)) +
                                      ProductWidth'($signed(group_i.dvdx)) * ProductWidth'($signed(group_i.dvdy));
  end else begin : gen_no_products
    assign products_d.cross_product = '0;
    assign products_d.dot_product   = '0;
  end

  logic      products_valid;
  logic      products_ready;
  products_t products_q;

  feline_stream_register #(.Width($bits(products_d))) u_products (
    .clk_i, .rst_i,
    .valid_i(group_valid_i), .ready_o(group_ready_o), .data_i(products_d),
    .valid_o(products_valid), .ready_i(products_ready), .data_o(products_q)
  );

  // Place in the table.
  place_t place_d;

  assign place_d.longer = products_q.longer;

  if (feline_pkg::FeatureTableFeline) begin : gen_place
    feline_table_place #(.ProductWidth(ProductWidth), .IndexWidth(IndexWidth)) u_table_place (
      .longer_length_i(products_q.longer.longer_length), .shorter_length_i(products_q.shorter_length),
      .cross_i(products_q.cross_product), .dot_i(products_q.dot_product), .x_is_longer_i(products_q.x_is_longer),
      .index_o(place_d.index), .turns_o(place_d.turns), .counter_clockwise_o(place_d.counter_clockwise)
    );
  end else begin : gen_no_place
    assign place_d.index             = '0;
    assign place_d.turns             = 1'b0;
    assign place_d.counter_clockwise = 1'b0;

    logic unused_products;
    assign unused_products = ^products_q;
  end

  logic   place_valid;
  logic   place_ready;
  place_t place_q;

  feline_stream_register #(.Width($bits(place_d))) u_place (
    .clk_i, .rst_i,
    .valid_i(products_valid), .ready_o(products_ready), .data_i(place_d),
    .valid_o(place_valid), .ready_i(place_ready), .data_o(place_q)
  );

  // Ellipse, or the vector as it is.
  feline_pkg::footprint_t             footprint_d;
  logic                               is_table;
  logic                               cell_present;
  logic [feline_pkg::StatusWidth-1:0] place_status;
  logic [VectorWidth-1:0]             ellipse_u;
  logic [VectorWidth-1:0]             ellipse_v;
  logic [RadiusWidth-1:0]             ellipse_major;
  logic [RadiusWidth-1:0]             ellipse_minor;
  logic [VectorWidth-1:0]             longer_u;
  logic [VectorWidth-1:0]             longer_v;

  assign longer_u = VectorWidth'($signed(place_q.longer.longer_u)) << feline_pkg::VectorFraction;
  assign longer_v = VectorWidth'($signed(place_q.longer.longer_v)) << feline_pkg::VectorFraction;

  if (feline_pkg::FeatureTableFeline) begin : gen_ellipse
    assign is_table = mode == feline_pkg::ModeTable;

    feline_table_footprint #(.IndexWidth(IndexWidth)) u_table_footprint (
      .longer_u_i(place_q.longer.longer_u), .longer_v_i(place_q.longer.longer_v),
      .longer_length_i(place_q.longer.longer_length), .index_i(place_q.index), .turns_i(place_q.turns),
      .counter_clockwise_i(place_q.counter_clockwise), .present_o(cell_present),
      .major_u_o(ellipse_u), .major_v_o(ellipse_v), .major_radius_o(ellipse_major), .minor_radius_o(ellipse_minor)
    );
  end else begin : gen_no_ellipse
    assign is_table      = 1'b0;
    assign cell_present  = 1'b1;
    assign ellipse_u     = '0;
    assign ellipse_v     = '0;
    assign ellipse_major = '0;
    assign ellipse_minor = '0;

    logic unused_place;
    assign unused_place = ^place_q;
  end

  always_comb begin
    place_status = place_q.longer.status;
    place_status[feline_pkg::StatusUnsupported] =
        place_status[feline_pkg::StatusUnsupported] | (is_table && !cell_present);
  end

  assign footprint_d.tag          = place_q.longer.tag;
  assign footprint_d.status       = place_status;
  assign footprint_d.s            = place_q.longer.s;
  assign footprint_d.t            = place_q.longer.t;
  assign footprint_d.exponent     = place_q.longer.exponent;
  assign footprint_d.major_u      = is_table ? ellipse_u : longer_u;
  assign footprint_d.major_v      = is_table ? ellipse_v : longer_v;
  assign footprint_d.major_radius = is_table ? ellipse_major : place_q.longer.longer_length;
  assign footprint_d.minor_radius = is_table ? ellipse_minor : place_q.longer.minor;

  feline_stream_register #(.Width($bits(footprint_d))) u_output (
    .clk_i, .rst_i,
    .valid_i(place_valid), .ready_o(place_ready), .data_i(footprint_d),
    .valid_o(footprint_valid_o), .ready_i(footprint_ready_i), .data_o(footprint_o)
  );

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;
endmodule

`default_nettype wire
