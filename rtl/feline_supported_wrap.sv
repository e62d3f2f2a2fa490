// SPDX-License-Identifier: Apache-2.0
// The wrap mode that the machine uses for one that is asked for.
//
// Takes and gives a wrap code.
// Edges  mirrored repeat falls back to repeat and clamp to border to clamp to edge where the configuration leaves them
//        out (model/features.h); footprint raises the status bit.
`default_nettype none

module feline_supported_wrap (
  input  wire logic [feline_pkg::WrapWidth-1:0] wrap_i,
  output logic [feline_pkg::WrapWidth-1:0]      wrap_o
);
  always_comb begin
    wrap_o = wrap_i;
    if (!feline_pkg::FeatureMirroredRepeat && wrap_i == feline_pkg::WrapMirroredRepeat) wrap_o = feline_pkg::WrapRepeat;
    if (!feline_pkg::FeatureClampToBorder && wrap_i == feline_pkg::WrapClampToBorder) begin
      wrap_o = feline_pkg::WrapClampToEdge;
    end
  end
endmodule

`default_nettype wire
