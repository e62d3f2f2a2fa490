// SPDX-License-Identifier: Apache-2.0
// The wrap mode that the machine uses for one that is asked for.
//
// Takes and gives a wrap code.
// Edges  what the configuration leaves out falls back as tables/supported.h says; footprint raises the status bit.
`default_nettype none

module feline_supported_wrap (
  input  wire logic [feline_pkg::WrapWidth-1:0] wrap_i,
  output logic [feline_pkg::WrapWidth-1:0]      wrap_o
);
  always_comb begin
    unique case (wrap_i)
      feline_pkg::WrapRepeat:         wrap_o = feline_pkg::SupportedWrapRepeat;
      feline_pkg::WrapMirroredRepeat: wrap_o = feline_pkg::SupportedWrapMirroredRepeat;
      feline_pkg::WrapClampToEdge:    wrap_o = feline_pkg::SupportedWrapClampToEdge;
      feline_pkg::WrapClampToBorder:  wrap_o = feline_pkg::SupportedWrapClampToBorder;
    endcase
  end
endmodule

`default_nettype wire
