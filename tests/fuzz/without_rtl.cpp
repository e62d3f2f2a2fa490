// SPDX-License-Identifier: Apache-2.0
// In the place of what Verilator makes, and of the searched units: what fuzzes parsers never gets there.
#include <stdexcept>

#include "testbench/area/toggles.h"
#include "testbench/budget/variant.h"
#include "testbench/cosim/rtl_unit.h"
#include "testbench/prove/rtl_leaf.h"

namespace feline {
namespace {

[[noreturn]] void never() { throw std::logic_error("a fuzz target ran the unit"); }

}  // namespace

std::unique_ptr<RtlUnit> make_fast_unit(std::uint64_t /*seed*/) { never(); }
std::unique_ptr<RtlUnit> make_trace_unit(std::uint64_t /*seed*/) { never(); }
std::vector<StageToggles> count_toggles(const std::filesystem::path& /*wave*/) { never(); }
std::span<const Variant> variants_of_first_mantissa() { return {}; }
std::span<const Variant> variants_of_second_mantissa() { return {}; }
std::span<const Variant> variants_of_third_mantissa() { return {}; }

namespace prove {

std::unique_ptr<RtlLeaf> make_rtl_leaf(std::string_view /*name*/) { never(); }
std::string_view verilator_version() { return "none"; }

}  // namespace prove
}  // namespace feline
