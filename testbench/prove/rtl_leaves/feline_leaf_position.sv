// SPDX-License-Identifier: Apache-2.0
// A float32 coordinate to fixed point (testbench/prove/leaves.h, Position).
`default_nettype none

module feline_leaf_position #(
  localparam int unsigned InputWidth = feline_pkg::WrapWidth + feline_pkg::Float32Width,
  localparam int unsigned OutputWidth = feline_pkg::PositionWidth + 1 + 1 + 1
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  localparam int unsigned ExponentBits = 8;  // of IEEE 754 binary32, as feline_group gives it

  logic [feline_pkg::WrapWidth-1:0]     wrap;
  logic [feline_pkg::Float32Width-1:0]  bits;
  logic [feline_pkg::PositionWidth-1:0] position;
  logic [1-1:0]                         finite;
  logic [1-1:0]                         overflow;
  logic [1-1:0]                         early;

  assign {wrap, bits} = inputs_i;
  assign outputs_o = {position, finite, overflow, early};

  logic [feline_pkg::WrapWidth-1:0] supported;

  feline_supported_wrap u_supported_wrap (.wrap_i(wrap), .wrap_o(supported));
  feline_float_to_position #(.ExponentBits(ExponentBits)) u_position (
    .bits_i(bits), .wrap_i(supported), .position_o(position), .finite_o(finite), .overflow_o(overflow), .early_o(early)
  );
endmodule

`default_nettype wire
