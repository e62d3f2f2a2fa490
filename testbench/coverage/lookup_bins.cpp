// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/lookup_bins.h"

#include <bit>
#include <cmath>

#include "model/unit.h"

namespace feline::coverage {
namespace {

using F = Formats<kUnit>;

// In the order of the grids.
enum Grid : std::size_t {
  kCells,
  kWeightRows,
  kProbes,
  kChoices,
  kLevels,
  kLevelClamps,
  kSizes,
  kPlaces,
  kBorders,
  kOperands,
  kStatuses,
  kModes,
  kTexels,
  kTransitions,
};

constexpr int kQuarters = 4;
constexpr std::size_t kExtColumn = kQuarters;
constexpr auto kModeCount = kModeNames.size();

template <std::size_t kCount>
std::vector<std::string> names(const std::array<std::string_view, kCount>& views) {
  return {views.begin(), views.end()};
}

bool has_line(std::size_t mode) { return mode >= static_cast<std::size_t>(Mode::kExt); }

BinGrid probe_grid() {
  BinGrid grid("probes", "Probes of a lookup, in each mode; the isotropic modes have one.", {"mode", names(kModeNames)},
               {"probes", numbers(1, kUnit.max_probes)});
  for (std::size_t mode = 0; mode < kModeCount; ++mode) {
    for (std::size_t column = 1; column < kUnit.max_probes && !has_line(mode); ++column) grid.leave_out(mode, column);
  }
  return grid;
}

BinGrid weight_grid() {
  BinGrid grid("weight_row", "Rows of the weight table: quarters of fProbes below each count, and mode ext.",
               {"probes", numbers(1, kUnit.max_probes)},
               {"fProbes less probes", words({"-3/4", "-1/2", "-1/4", "0", "ext"})});
  for (std::size_t quarter = 0; quarter + 1 < kQuarters; ++quarter) grid.leave_out(0, quarter);
  return grid;
}

BinGrid level_grid() {
  BinGrid grid("level_pair", "The finer level that a probe reads, alone or blended with the next.",
               {"", words({"alone", "with the next"})}, {"level", numbers(0, F::kLevels - 1)});
  grid.leave_out(1, F::kLevels - 1);
  return grid;
}

// repeat s, repeat t, ...
std::vector<std::string> wrap_axes() {
  std::vector<std::string> rows;
  for (const std::string_view wrap : kWrapNames) {
    for (const char* axis : {" s", " t"}) rows.push_back(std::string(wrap) + axis);
  }
  return rows;
}
std::size_t wrap_axis(std::int64_t wrap, std::size_t axis) { return 2 * static_cast<std::size_t>(wrap) + axis; }

const std::vector<std::string> kSizeClasses =
    words({"1", "2", "power of two", "odd", "other even", "above 8192", "16384"});
std::size_t size_class(std::int64_t size) {
  constexpr std::int64_t kLarge = 8192;
  if (size <= 2) return static_cast<std::size_t>(size - 1);
  if (size == 1 << kUnit.max_size_log2) return 6;
  if (size > kLarge) return 5;
  if (std::has_single_bit(static_cast<std::uint64_t>(size))) return 2;
  return size % 2 != 0 ? 3 : 4;
}

const std::vector<std::string> kFloatClasses = words({"0", "-0", "denormal", "-denormal", "least normal", "normal",
                                                      "-normal", "greatest", "infinity", "-infinity", "NaN", "-NaN"});
std::size_t float_class(std::int64_t raw) {
  const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  const std::size_t sign = std::signbit(value) ? 1 : 0;
  switch (std::fpclassify(value)) {
    case FP_ZERO: return sign;
    case FP_SUBNORMAL: return 2 + sign;
    case FP_INFINITE: return 8 + sign;
    case FP_NAN: return 10 + sign;
    default: break;
  }
  if (std::abs(value) == std::numeric_limits<float>::min()) return 4;
  if (std::abs(value) == std::numeric_limits<float>::max()) return 7;
  return 5 + sign;
}

// Whether an axis' two texels lie outside: none, the first, the second, both.
const std::vector<std::string> kOutside = words({"none", "first", "second", "both"});

}  // namespace

class LookupBins::Recorder {
 public:
  Recorder(std::vector<BinGrid>& grids, const SamplerState<kUnit>& sampler)
      : grids_(grids), sampler_(sampler), mode_(static_cast<std::size_t>(sampler.mode.raw())) {}
  bool is_new() const { return is_new_; }

  // What every lookup of the batch has.
  void sampler() {
    const auto kernel = static_cast<std::size_t>(sampler_.kernel.raw());
    count(kModes, mode_, 2 * kernel + static_cast<std::size_t>(sampler_.magnify.raw()));
    count(kTexels, mode_,
          2 * static_cast<std::size_t>(sampler_.texel_format.raw()) + static_cast<std::size_t>(sampler_.srgb.raw()));
    count(kSizes, wrap_axis(sampler_.wrap_s.raw(), 0), size_class(sampler_.width.raw()));
    count(kSizes, wrap_axis(sampler_.wrap_t.raw(), 1), size_class(sampler_.height.raw()));
  }

  void operator()(const RequestBeat<kUnit>& beat) {
    std::size_t operand = 0;
    for (const auto& value : {beat.s, beat.t, beat.dsdx, beat.dtdx, beat.dsdy, beat.dtdy}) {
      count(kOperands, float_class(value.raw()), operand++);
    }
  }

  void operator()(const GroupBeat<kUnit>& beat) {
    if (static_cast<Mode>(mode_) != Mode::kTable) return;
    const TableCell cell = table_cell<kUnit>(gradients_of<kUnit>(beat));
    count(kCells, static_cast<std::size_t>(cell.row), static_cast<std::size_t>(cell.column));
  }

  void operator()(const FootprintBeat<kUnit>& beat) {
    const auto mode = static_cast<Mode>(mode_);
    const ClampedRadii radii = clamp_radii<kUnit>(beat, mode, sampler_.length_factor.raw());
    choice_ = choose_probes<kUnit>(radii, mode, sampler_);
    magnified_ = radii.magnified;
    base_level_ =
        level_of_radius<kUnit>(fit_minor_radius<kUnit>(radii, mode, choice_, sampler_), beat.exponent.raw()).raw();
  }

  void operator()(const PlanBeat<kUnit>& beat) {
    const auto probes = static_cast<std::size_t>(beat.probes.raw());
    count(kProbes, mode_, probes - 1);
    weight_row(probes, static_cast<std::size_t>(beat.weight_row.raw()));
    const bool beyond = base_level_ > sampler_.smallest_level.raw() << kUnit.level_fraction_bits;
    const bool ceiling = sampler_.probe_rounding.raw() != 0;
    if (has_line(mode_)) {
      const std::size_t row = static_cast<Mode>(mode_) == Mode::kExt
                                  ? 0
                                  : 2 * (mode_ - static_cast<std::size_t>(Mode::kSimple)) + 1 + ceiling;
      count(kChoices, row, magnified_ ? 0 : beyond ? 1 : choice_.limited ? 2 : probes == 1 ? 3 : 4);
    }
    const std::int64_t level = beat.level_of_detail.raw() >> kUnit.level_fraction_bits;
    const bool blends = beat.level_of_detail.raw() != level << kUnit.level_fraction_bits;
    count(kLevels, blends ? 1 : 0, static_cast<std::size_t>(level));
    level_clamp(beat);
  }

  void operator()(const AddressBeat<kUnit>& beat) {
    place(sampler_.wrap_s.raw(), 0, s_);
    place(sampler_.wrap_t.raw(), 1, t_);
    border(0, beat.fine_border.raw());
    if (beat.coarse_used.raw() != 0) border(4, beat.coarse_border.raw());
  }

  void operator()(const WalkBeat<kUnit>& beat) {
    s_ = beat.s.raw();
    t_ = beat.t.raw();
  }

  void operator()(const AccumulateBeat<kUnit>& beat) {
    if (beat.status.raw() == 0) count(kStatuses, mode_, 0);
    if ((beat.status.raw() & kCoordinateNotFinite) != 0) count(kStatuses, mode_, 1);
    if ((beat.status.raw() & kDerivativeNotFinite) != 0) count(kStatuses, mode_, 2);
    if ((beat.status.raw() & kOverflow) != 0) count(kStatuses, mode_, 3);
  }

  template <typename Beat>
  void operator()(const Beat&) {}

  void count(Grid grid, std::size_t row, std::size_t column) { is_new_ = grids_[grid].count(row, column) || is_new_; }

 private:
  void weight_row(std::size_t probes, std::size_t row) {
    if (static_cast<Mode>(mode_) == Mode::kExt) {
      count(kWeightRows, probes - 1, kExtColumn);
    } else {
      count(kWeightRows, probes - 1, row + 7 - kQuarters * probes);
    }
  }

  void level_clamp(const PlanBeat<kUnit>& beat) {
    const std::int64_t biased = base_level_ + sampler_.level_bias.raw();
    const std::int64_t lambda = std::clamp(biased, sampler_.min_level.raw(), sampler_.max_level.raw());
    const std::size_t column = biased < sampler_.min_level.raw() ? 0 : biased > sampler_.max_level.raw() ? 1 : 2;
    count(kLevelClamps, mode_, column);
    if (lambda > sampler_.last_level.raw() << kUnit.level_fraction_bits) count(kLevelClamps, mode_, 3);
    if (lambda == 0) count(kLevelClamps, mode_, beat.linear.raw() != 0 ? 4 : 5);
  }

  void place(std::int64_t wrap, std::size_t axis, std::int64_t position) {
    constexpr std::int64_t kOne = std::int64_t{1} << F::kPositionFraction;
    const std::size_t column = position < -kOne      ? 0
                               : position < 0        ? 1
                               : position < kOne     ? 2
                               : position < 2 * kOne ? 3
                                                     : 4;
    count(kPlaces, wrap_axis(wrap, axis), column);
  }

  void border(std::size_t first_column, std::int64_t bits) {
    count(kBorders, static_cast<std::size_t>(bits >> 2), first_column + static_cast<std::size_t>(bits & 3));
  }

  std::vector<BinGrid>& grids_;
  const SamplerState<kUnit>& sampler_;
  std::size_t mode_;
  bool is_new_ = false;
  ProbeChoice choice_{};
  bool magnified_ = false;
  std::int64_t base_level_ = 0;
  std::int64_t s_ = 0;
  std::int64_t t_ = 0;
};

LookupBins::LookupBins() {
  const auto modes = names(kModeNames);
  grids_.emplace_back("ellipse_cell", "Cells of the ellipse table.",
                      BinGrid::Axis{"ratio of the lengths", numbers(0, kUnit.table_rows - 1)},
                      BinGrid::Axis{"angle of the gradients", numbers(0, kUnit.table_columns - 1)});
  grids_.push_back(weight_grid());
  grids_.push_back(probe_grid());
  grids_.emplace_back(
      "probe_choice", "What decides the number of probes.",
      BinGrid::Axis{"", words({"ext", "simple, nearest", "simple, ceiling", "table, nearest", "table, ceiling"})},
      BinGrid::Axis{"", words({"magnified", "past 1 x 1", "limited", "one", "more"})});
  grids_.push_back(level_grid());
  grids_.emplace_back(
      "level_choice", "What decides the level of detail, and what level 0 is magnified with.",
      BinGrid::Axis{"mode", modes},
      BinGrid::Axis{"", words({"min level", "max level", "neither", "last level", "linear", "nearest"})});
  grids_.emplace_back("size", "Wrap mode and size of the texture along each axis.", BinGrid::Axis{"", wrap_axes()},
                      BinGrid::Axis{"texels", kSizeClasses});
  grids_.emplace_back("place", "Where probes are along each axis, in textures.", BinGrid::Axis{"", wrap_axes()},
                      BinGrid::Axis{"", words({"below -1", "-1 to 0", "0 to 1", "1 to 2", "above 2"})});
  std::vector<std::string> sides;
  for (const char* level : {"fine ", "coarse "}) {
    for (const std::string& outside : kOutside) sides.push_back(level + outside);
  }
  grids_.emplace_back("border", "Which columns and rows of a probe's texels lie outside, of both levels.",
                      BinGrid::Axis{"rows outside", kOutside}, BinGrid::Axis{"columns outside", sides});
  grids_.emplace_back("operand", "Class of float32 of each operand.", BinGrid::Axis{"", kFloatClasses},
                      BinGrid::Axis{"", words({"s", "t", "dsdx", "dtdx", "dsdy", "dtdy"})});
  grids_.emplace_back("status", "Status of lookups.", BinGrid::Axis{"mode", modes},
                      BinGrid::Axis{"", words({"none", "coordinate", "derivative", "overflow"})});
  grids_.emplace_back("mode", "Modes with kernels and magnification filters.", BinGrid::Axis{"mode", modes},
                      BinGrid::Axis{"kernel, magnified", words({"bilinear, nearest", "bilinear, linear",
                                                                "gaussian, nearest", "gaussian, linear"})});
  grids_.emplace_back("texel", "Modes with texel formats.", BinGrid::Axis{"mode", modes},
                      BinGrid::Axis{"", words({"r8", "r8 srgb", "rg8", "rg8 srgb", "rgba8", "rgba8 srgb"})});
  grids_.emplace_back("transition", "A batch in one mode right after one in another.", BinGrid::Axis{"from", modes},
                      BinGrid::Axis{"to", modes});
}

void LookupBins::observe(const Batch& batch) {
  Recorder recorder(grids_, batch.sampler);
  recorder.sampler();
  const auto mode = static_cast<std::size_t>(batch.sampler.mode.raw());
  if (mode_before_) recorder.count(kTransitions, *mode_before_, mode);
  mode_before_ = mode;
  for (const Lookup& lookup : batch.lookups) {
    sample<kUnit>(make_request<kUnit>(lookup, 0), batch.sampler, *batch.memory, recorder);
  }
}

bool LookupBins::observe(const Lookup& lookup, const SamplerState<kUnit>& sampler, const TextureMemory& memory) {
  Recorder recorder(grids_, sampler);
  recorder.sampler();
  sample<kUnit>(make_request<kUnit>(lookup, 0), sampler, memory, recorder);
  return recorder.is_new();
}

}  // namespace feline::coverage
