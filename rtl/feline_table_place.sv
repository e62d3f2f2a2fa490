// SPDX-License-Identifier: Apache-2.0
// Where the ellipse table is read for two vectors, and which way the longer one turns (model/footprint.h).
//
// Takes  the longer and the shorter length U8.7; the vectors' cross and dot product; whether x is the longer vector.
// Gives  the word of the ellipse table, row * columns + column: row by the ratio of the lengths, column by the tangent
//        of the vectors' angle, in the second half by its cotangent; whether the longer vector turns, and whether
//        counter-clockwise, from (u, v) towards (-v, u).
// Rounds row and column: down.
// Edges  Cross or dot product zero: nothing turns. Both zero: the column of 90 degrees.
// Source WRL 99/1, 3.3.
`default_nettype none

module feline_table_place #(
  parameter int unsigned ProductWidth = 2 * feline_pkg::MantissaWidth,
  parameter int unsigned IndexWidth   = $clog2(feline_pkg::TableRows * feline_pkg::TableColumns)
) (
  input  wire logic [feline_pkg::RadiusWidth-1:0] longer_length_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0] shorter_length_i,
  input  wire logic signed [ProductWidth-1:0]     cross_i,
  input  wire logic signed [ProductWidth-1:0]     dot_i,
  input  wire logic                               x_is_longer_i,
  output logic [IndexWidth-1:0]                   index_o,
  output logic                                    turns_o,
  output logic                                    counter_clockwise_o
);
  localparam int unsigned Half = feline_pkg::TableColumns / 2;

  logic [ProductWidth-1:0] cross_size;
  logic [ProductWidth-1:0] dot_size;
  logic                    is_tangent;
  logic [IndexWidth-1:0]   row;
  logic [IndexWidth-1:0]   half_column;
  logic [IndexWidth-1:0]   column;

  assign cross_size = cross_i[ProductWidth-1] ? -cross_i : cross_i;
  assign dot_size   = dot_i[ProductWidth-1] ? -dot_i : dot_i;
  assign is_tangent = cross_size < dot_size;

  feline_table_index #(
    .Width     (feline_pkg::RadiusWidth),
    .Steps     (feline_pkg::TableRows),
    .IndexWidth(IndexWidth)
  ) u_row (
    .numerator_i  (shorter_length_i),
    .denominator_i(longer_length_i),
    .index_o      (row)
  );
  feline_table_index #(
    .Width     (ProductWidth - 1),
    .Steps     (Half),
    .IndexWidth(IndexWidth)
  ) u_column (
    .numerator_i  (is_tangent ? cross_size[ProductWidth-2:0] : dot_size[ProductWidth-2:0]),
    .denominator_i(is_tangent ? dot_size[ProductWidth-2:0] : cross_size[ProductWidth-2:0]),
    .index_o      (half_column)
  );

  assign column              = is_tangent ? half_column : half_column + IndexWidth'(Half);
  assign index_o             = row * IndexWidth'(feline_pkg::TableColumns) + column;
  assign turns_o             = cross_size != '0 && dot_size != '0;
  assign counter_clockwise_o = x_is_longer_i ^ cross_i[ProductWidth-1] ^ dot_i[ProductWidth-1];
endmodule

`default_nettype wire
