// SPDX-License-Identifier: Apache-2.0
// The row of the weight table (choose_weight_row of model/plan.h).
//
// Takes  the mode, a supported one; probes; eighths, floor(8 major/minor) >= 8 (feline_choose_probes).
// Gives  the row: ext: the Gaussian-free rows, one a probe count; Feline: fProbes = 2 major/minor - 1 in quarters, kept
//        within the four rows of its probe count.
// Rounds nothing.
// Edges  one probe: row 0, outside ext.
// Source WRL 99/1, 3.2.
`default_nettype none

module feline_choose_weight_row (
  input  wire logic [feline_pkg::ModeWidth-1:0]       mode_i,
  input  wire logic [feline_pkg::ProbeCountWidth-1:0] probes_i,
  input  wire logic [feline_pkg::EighthsWidth-1:0]    eighths_i,
  output logic [feline_pkg::WeightRowWidth-1:0]       weight_row_o
);
  localparam int unsigned WeightRowWidth  = feline_pkg::WeightRowWidth;
  localparam int unsigned ProbeCountWidth = feline_pkg::ProbeCountWidth;
  localparam bit          AnyFeline       = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  logic [WeightRowWidth-1:0] ext;
  logic [WeightRowWidth-1:0] feline;

  assign ext = WeightRowWidth'(probes_i) + WeightRowWidth'(feline_pkg::GaussianRows - 1);

  if (AnyFeline) begin : gen_feline
    localparam int unsigned QuartersWidth = feline_pkg::EighthsWidth + 1;

    // All of them four too many, as rows of the table are not: row = quarters - 4.
    logic [QuartersWidth-1:0] quarters;
    logic [QuartersWidth-1:0] least;
    logic [QuartersWidth-1:0] most;
    logic [QuartersWidth-1:0] kept;

    assign quarters = QuartersWidth'(eighths_i) - QuartersWidth'(4);
    assign most     = QuartersWidth'({probes_i, 2'b00});
    assign least    = most - QuartersWidth'(3);

    always_comb begin
      kept = quarters;
      if (quarters < least) kept = least;
      if (quarters > most) kept = most;
    end
    assign feline = kept[WeightRowWidth-1:0] - WeightRowWidth'(4);

    logic unused_kept;
    assign unused_kept = ^kept;
  end else begin : gen_no_feline
    assign feline = '0;

    logic unused_inputs;
    assign unused_inputs = ^eighths_i;
  end

  always_comb begin
    if (feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt) begin
      weight_row_o = ext;
    end else if (probes_i == ProbeCountWidth'(1)) begin
      weight_row_o = '0;
    end else begin
      weight_row_o = feline;
    end
  end
endmodule

`default_nettype wire
