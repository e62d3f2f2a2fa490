// SPDX-License-Identifier: Apache-2.0
// group: float32 coordinates to fixed point, float32 derivatives to four mantissas under one exponent.
//
// Takes  s, t and the derivatives ds/dx, dt/dx, ds/dy, dt/dy, float32, normalized (1 = the texture's size).
// Gives  s, t S20.24 textures; dudx, dvdx, dudy, dvdy S7.0 in texels of level 0 * 2^exponent; exponent S6.0.
// Rounds s, t: nearest, ties away from zero. Mantissas: simple and table nearest, ties away from zero; the other modes
//        outward (away from zero), so that a growing footprint never shrinks. The exponent is the least with which no
//        rounded magnitude exceeds 127; the largest is then 64 .. 127.
// Edges  Denormals are 0. |s| or |t| >= 2^19: the clamps saturate at 2^19, the repeats keep the value modulo 2^21.
//        NaN coordinates are 0; infinite ones are +-2^19 (clamps) or 0 (repeats). A NaN or infinite derivative gives
//        the unbounded footprint (127, 0), (0, 127), exponent 63. exponent > 63 saturates; exponent < -64 gives zeros
//        at -64. -128 never occurs: negating a gradient negates its mantissas. Status: coordinate or derivative not
//        finite; overflow where a clamp saturates a finite coordinate or exponent > 63 saturates; unsupported where the
//        configuration's exponent is narrower than that and saturates, or a coordinate saturates nearer than 2^19, or it
//        has no place for a derivative that is not 0.
// Source McCormack et al., WRL 99/1, 3.2 (group scaling); CS248A lecture 4, steps 2 and 4.
// Timing two registers: products and their leading ones | align and round.
`default_nettype none

module feline_group (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 request_valid_i,
  output logic                      request_ready_o,
  input  wire feline_pkg::request_t request_i,
  output logic                      group_valid_o,
  input  wire logic                 group_ready_i,
  output feline_pkg::group_t        group_o
);
  localparam int unsigned Float32Width  = feline_pkg::Float32Width;
  localparam int unsigned SizeWidth     = feline_pkg::SizeWidth;
  localparam int unsigned MantissaWidth = feline_pkg::MantissaWidth;
  localparam int unsigned ExponentBits  = 8;  // of IEEE 754 binary32
  localparam int unsigned ProductWidth  = Float32Width - ExponentBits + (feline_pkg::FeatureAnySize ? SizeWidth : 0);
  localparam int unsigned TopWidth      = ExponentBits + 1;

  typedef struct packed {
    logic [feline_pkg::TagWidth-1:0]      tag;
    logic                                 coordinates_finite;
    logic                                 coordinates_overflow;
    logic                                 finite;
    logic                                 missing;
    logic [feline_pkg::PositionWidth-1:0] s;
    logic [feline_pkg::PositionWidth-1:0] t;
    logic [TopWidth-1:0]                  top;
    // Of ds/dx, dt/dx, ds/dy, dt/dy, the first lowest.
    logic [3:0]                           negative;
    logic [4*TopWidth-1:0]                exponent;
    logic [4*ProductWidth-1:0]            product;
  } products_t;

  // Products.
  localparam logic [3:0] HasPlace = {feline_pkg::FeatureDvdy, feline_pkg::FeatureDudy, feline_pkg::FeatureDvdx,
                                     feline_pkg::FeatureDudx};

  products_t                        products_d;
  logic [feline_pkg::WrapWidth-1:0] wrap_s;
  logic [feline_pkg::WrapWidth-1:0] wrap_t;
  logic                             s_finite;
  logic                             t_finite;
  logic                             s_overflow;
  logic                             t_overflow;
  logic [3:0]                       finite;
  logic [3:0]                       missing;
  logic [1:0]                       early;
  logic [4*Float32Width-1:0]        derivatives;
  logic [4*SizeWidth-1:0]           sizes;
  logic [4*TopWidth-1:0]            tops;
  logic [TopWidth-1:0]              top;

  assign products_d.tag                  = request_i.tag;
  assign products_d.coordinates_finite   = s_finite && t_finite;
  assign products_d.coordinates_overflow = s_overflow || t_overflow;
  assign products_d.finite               = finite == 4'hf;
  assign products_d.missing              = missing != '0 || early != '0;

  feline_supported_wrap u_wrap_s (.wrap_i(sampler_i.wrap_s), .wrap_o(wrap_s));
  feline_supported_wrap u_wrap_t (.wrap_i(sampler_i.wrap_t), .wrap_o(wrap_t));

  feline_float_to_position #(.ExponentBits(ExponentBits)) u_position_s (
    .bits_i(request_i.s), .wrap_i(wrap_s), .position_o(products_d.s), .finite_o(s_finite),
    .overflow_o(s_overflow), .early_o(early[0])
  );
  feline_float_to_position #(.ExponentBits(ExponentBits)) u_position_t (
    .bits_i(request_i.t), .wrap_i(wrap_t), .position_o(products_d.t), .finite_o(t_finite),
    .overflow_o(t_overflow), .early_o(early[1])
  );

  assign derivatives = {request_i.dtdy, request_i.dsdy, request_i.dtdx, request_i.dsdx};
  assign sizes       = {sampler_i.height, sampler_i.width, sampler_i.height, sampler_i.width};

  for (genvar i = 0; i < 4; i++) begin : gen_product
    feline_texel_product #(
      .HasPlace    (HasPlace[i]),
      .ExponentBits(ExponentBits),
      .ProductWidth(ProductWidth)
    ) u_texel_product (
      .bits_i    (derivatives[i*Float32Width +: Float32Width]),
      .size_i    (sizes[i*SizeWidth +: SizeWidth]),
      .finite_o  (finite[i]),
      .missing_o (missing[i]),
      .negative_o(products_d.negative[i]),
      .exponent_o(products_d.exponent[i*TopWidth +: TopWidth]),
      .product_o (products_d.product[i*ProductWidth +: ProductWidth]),
      .top_o     (tops[i*TopWidth +: TopWidth])
    );
  end

  always_comb begin
    top = '0;
    for (int i = 0; i < 4; i++) begin
      if (tops[i*TopWidth +: TopWidth] > top) top = tops[i*TopWidth +: TopWidth];
    end
  end
  assign products_d.top = top;

  logic      products_valid;
  logic      products_ready;
  products_t products_q;

  feline_stream_register #(.Width($bits(products_d))) u_products (
    .clk_i, .rst_i,
    .valid_i(request_valid_i), .ready_o(request_ready_o), .data_i(products_d),
    .valid_o(products_valid), .ready_i(products_ready), .data_o(products_q)
  );

  // Align and round.
  feline_pkg::group_t                 group_d;
  logic [feline_pkg::StatusWidth-1:0] status;
  logic [4*MantissaWidth-1:0]         mantissa;
  logic                               exponent_overflow;
  logic                               exponent_unsupported;

  logic [feline_pkg::ModeWidth-1:0] mode;

  feline_supported_mode u_supported_mode (.mode_i(sampler_i.mode), .mode_o(mode));

  feline_group_mantissas #(.ExponentBits(ExponentBits), .ProductWidth(ProductWidth)) u_group_mantissas (
    .nearest_i(mode == feline_pkg::ModeSimple || mode == feline_pkg::ModeTable),
    .finite_i(products_q.finite), .top_i(products_q.top), .negative_i(products_q.negative),
    .exponent_i(products_q.exponent), .product_i(products_q.product),
    .exponent_o(group_d.exponent), .mantissa_o(mantissa), .overflow_o(exponent_overflow),
    .unsupported_o(exponent_unsupported)
  );

  always_comb begin
    status = '0;
    status[feline_pkg::StatusCoordinateNotFinite] = !products_q.coordinates_finite;
    status[feline_pkg::StatusDerivativeNotFinite] = !products_q.finite;
    status[feline_pkg::StatusOverflow]            = products_q.coordinates_overflow || exponent_overflow;
    status[feline_pkg::StatusUnsupported]         = products_q.missing || exponent_unsupported;
  end
  assign group_d.tag    = products_q.tag;
  assign group_d.status = status;
  assign group_d.s      = products_q.s;
  assign group_d.t      = products_q.t;
  assign group_d.dudx   = mantissa[0*MantissaWidth +: MantissaWidth];
  assign group_d.dvdx   = mantissa[1*MantissaWidth +: MantissaWidth];
  assign group_d.dudy   = mantissa[2*MantissaWidth +: MantissaWidth];
  assign group_d.dvdy   = mantissa[3*MantissaWidth +: MantissaWidth];

  feline_stream_register #(.Width($bits(group_d))) u_output (
    .clk_i, .rst_i,
    .valid_i(products_valid), .ready_o(products_ready), .data_i(group_d),
    .valid_o(group_valid_o), .ready_i(group_ready_i), .data_o(group_o)
  );

  logic unused_sampler;
  assign unused_sampler = ^sampler_i;
endmodule

`default_nettype wire
