// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/proof.h"

namespace feline::prove {
namespace {

using Method = Proof::Method;
using Control = Proof::Control;
using Registers = Proof::Registers;

// A register that takes the next beat's data while the one that it offers still waits.
constexpr Control kDataMovesTooEarly{"rtl/feline_stream_register.sv", "if (ready_o && valid_i) data_q <= data_i;",
                                     "if (valid_i) data_q <= data_i;"};
// One that loses what comes while it waits; one that gives a beat again; one that changes a bit; one that stops for
// ever.
constexpr Control kLosesBeats{"rtl/feline_stream_register.sv", "assign ready_o = !valid_q || ready_i;",
                              "assign ready_o = 1'b1;"};
constexpr Control kRepeatsBeats{"rtl/feline_stream_register.sv", "valid_q <= valid_i;",
                                "valid_q <= valid_i || valid_q;"};
constexpr Control kChangesABit{"rtl/feline_stream_register.sv", "data_q <= data_i;",
                               "data_q <= data_i ^ (Width'(1) << (Width - 1));"};
constexpr Control kStops{"rtl/feline_stream_register.sv", "assign ready_o = !valid_q || ready_i;",
                         "logic stuck_q; always_ff @(posedge clk_i) stuck_q <= !rst_i && (stuck_q || (valid_q && "
                         "!ready_i)); assign ready_o = (!valid_q || ready_i) && !stuck_q;"};

std::vector<Control> stream_controls() {
  return {kDataMovesTooEarly, kLosesBeats, kRepeatsBeats, kChangesABit, kStops};
}

const std::vector<Proof>& proofs() {
  static const std::vector<Proof> all{
      {"length",
       "feline_length is the greatest of its parts, by shifts and additions",
       Method::kEquivalence,
       {{"rtl/feline_length.sv", "assign u_is_larger = size_u > size_v", "assign u_is_larger = size_u >= 5 + size_v"}}},
      {"quotient",
       "feline_quotient of the ellipse table's widths and of the ceiling's is confirmed by multiplying back",
       Method::kEquivalence,
       {{"rtl/feline_quotient.sv", "quotient[i] = remainder >= denominator;",
         "quotient[i] = remainder > denominator;"}}},
      {"bit_length",
       "feline_bit_length of group's products is the place of the highest bit",
       Method::kEquivalence,
       {{"rtl/feline_bit_length.sv", "(rest >> ((1 << i) - 1)) != '0", "(rest >> (1 << i)) != '0"}}},
      {"round_magnitude",
       "feline_round_magnitude of group's products is a division of the sum with half a unit or a unit less one",
       Method::kEquivalence,
       {{"rtl/feline_round_magnitude.sv", "half_more || (inexact && !nearest_i)", "half_more || inexact"}}},
      {"mantissas",
       "no mantissa of group is -128",
       Method::kEquivalence,
       {{"rtl/feline_group_mantissas.sv", "assign halved   = too_large != '0;",
         "assign halved   = too_large[2:0] != '0;"}}},
      {"wrap",
       "feline_wrap is arithmetic modulo a texture or two, and clamping",
       Method::kEquivalence,
       {{"rtl/feline_wrap.sv", "whole > 1 ? BelowTwo", "whole > 2 ? BelowTwo"}}},
      {"group_stream",
       "group: no beat lost, repeated, overtaken or changed, tags pass; two inside at most; one a cycle",
       Method::kReachability,
       {kDataMovesTooEarly,
        kLosesBeats,
        kRepeatsBeats,
        kStops,
        {"rtl/feline_group.sv", "assign group_d.tag    = products_q.tag;",
         "assign group_d.tag    = products_q.tag ^ 2;"}}},
      {"footprint_stream", "footprint: the same, coordinates and exponent pass; three inside", Method::kReachability,
       stream_controls()},
      {"plan_stream", "plan: the same, coordinates pass; five inside", Method::kReachability, {kLosesBeats, kStops}},
      {"walk_stream",
       "walk: of each plan its probes, in order, one a cycle",
       Method::kReachability,
       {{"rtl/feline_walk.sv", "assign plan_ready_o = beat_ready && last;",
         "assign plan_ready_o = beat_ready && beat.first;"},
        kLosesBeats,
        kStops}},
      {"spill_stream",
       "the spill register: no beat lost, repeated, overtaken or changed; two inside at most; one a cycle",
       Method::kReachability,
       {{"rtl/feline_spill_register.sv", "if (!moves && !spilled_q && valid_i)", "if (!moves && valid_i)"},
        {"rtl/feline_spill_register.sv", "spilled_data_q <= data_i;", "spilled_data_q <= data_i ^ Width'(4);"}}},
      {"address_stream",
       "address: no beat lost, repeated, overtaken or changed, header and level pass; four inside at most; one a cycle",
       Method::kReachability,
       {kLosesBeats, kRepeatsBeats, kStops}},
      {"levels_in_step",
       "address: both levels of a beat are of the same probe",
       Method::kReachability,
       {{"rtl/feline_address.sv", ".wrapped_valid_i(wrapped_valid), .wrapped_ready_o(coarse_ready)",
         ".wrapped_valid_i(1'b1), .wrapped_ready_o(coarse_ready)"}}},
      {"fetch_stream",
       "fetch with four lines, never flushed: no beat lost, repeated, overtaken or changed, header and fractions pass; "
       "its requests stay",
       Method::kReachability,
       {{"rtl/feline_blocking_cache.sv", "assign texels_ready_o = words_ready_i && missing == '0;",
         "assign texels_ready_o = words_ready_i;"},
        {"rtl/feline_blocking_cache.sv", "Request: if (memory_request_ready_i) state_q <= Respond;",
         "Request: state_q <= Respond;"}}},
      {"cached_words",
       "fetch with four lines in each half, never flushed: each word is that of its line in memory",
       Method::kReachability,
       {{"rtl/feline_tile_cache.sv", "present_o[i] = valid_q[set] && line_q", "present_o[i] = line_q"},
        {"rtl/feline_blocking_cache.sv", "if (rst_i || (texels_valid_i && texels_ready_o))", "if (rst_i)"}}},
      {"cache_ends",
       "fetch with four lines in each half, never flushed: asks for each line of a beat once, waits not for ever",
       Method::kReachability,
       {{"rtl/feline_blocking_cache.sv", "kept_q <= kept_q | keep;", "kept_q <= kept_q;"},
        {"rtl/feline_blocking_cache.sv", "default: if (memory_response_valid_i) state_q <= Look;",
         "default: if (memory_response_valid_i && !half_q) state_q <= Look;"}}},
      {"filter_stream",
       "filter: no beat lost, repeated, overtaken or changed, the header passes; three inside at most; one a cycle",
       Method::kReachability, stream_controls()},
      {"filter_tree",
       "filter is a tree of feline_interpolate",
       Method::kEquivalence,
       {{"rtl/feline_filter.sv", ".a_i(fetch_i.fine_01), .b_i(fetch_i.fine_11), .fraction_i(fine_x)",
         ".a_i(fetch_i.fine_01), .b_i(fetch_i.fine_11), .fraction_i(coarse_x)"},
        {"rtl/feline_filter.sv", "gaussian = sampler_i.kernel == feline_pkg::KernelGaussian && fetch_i.linear",
         "gaussian = sampler_i.kernel == feline_pkg::KernelGaussian"}},
       Registers::kWires},
      {"sum",
       "accumulate: a pixel is the sum of its probes' products, each channel by itself, rounded once",
       Method::kReachability,
       {{"rtl/feline_accumulate.sv", "carried + weighted_q.colour[c*SumWidth +: SumWidth];",
         "carried + (weighted_q.colour[c*SumWidth +: SumWidth] >> !weighted_q.first);"},
        {"rtl/feline_accumulate.sv", "SumWidth'(filter_i.colour[c])", "SumWidth'(filter_i.colour[c % 3])"}},
       Registers::kWires},
      {"sum_bound",
       "accumulate: the sum of the first channel does not overflow",
       Method::kInduction,
       {{"rtl/feline_accumulate.sv", "carried + weighted_q.colour[c*SumWidth +: SumWidth];",
         "carried[SumWidth-2:0] + weighted_q.colour[c*SumWidth +: SumWidth];"},
        {"rtl/feline_accumulate.sv", "localparam logic [SumWidth-1:0] Half = SumWidth'(1) << (Dropped - 1);",
         "localparam logic [SumWidth-1:0] Half = SumWidth'(1) << Dropped;"}},
       Registers::kWires},
      {"accumulate_stream",
       "accumulate: a pixel of each last beat, in order, with its tag and status; one beat a cycle",
       Method::kReachability,
       {{"rtl/feline_accumulate.sv", "beat_ready || !weighted_q.last", "1'b1"}, kRepeatsBeats}}};
  return all;
}

}  // namespace

const std::vector<Proof>& all_proofs() { return proofs(); }

}  // namespace feline::prove
