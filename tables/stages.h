// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "tables/beats.h"

namespace feline {

// The eight stages, in the order of the data: file, function, module suffix, instance and trace tag.
enum class Stage : std::uint8_t { kGroup, kFootprint, kPlan, kWalk, kAddress, kFetch, kFilter, kAccumulate };

inline constexpr std::array<std::string_view, 8> kStageNames{"group",   "footprint", "plan",   "walk",
                                                             "address", "fetch",     "filter", "accumulate"};
inline constexpr std::size_t kStageCount = kStageNames.size();

constexpr std::string_view stage_name(Stage stage) { return kStageNames[static_cast<std::size_t>(stage)]; }

// What each stage gives, in the same order.
template <Config kConfig>
using StageBeats = std::tuple<GroupBeat<kConfig>, FootprintBeat<kConfig>, PlanBeat<kConfig>, WalkBeat<kConfig>,
                              AddressBeat<kConfig>, FetchBeat<kConfig>, FilterBeat<kConfig>, AccumulateBeat<kConfig>>;

template <Config kConfig, std::size_t kStage>
using StageBeat = std::tuple_element_t<kStage, StageBeats<kConfig>>;

// The stage that gives a beat type; kStageCount for a request.
template <Config kConfig, typename Beat, std::size_t kStage = 0>
constexpr std::size_t stage_of() {
  if constexpr (kStage == kStageCount) {
    return kStageCount;
  } else if constexpr (std::is_same_v<Beat, StageBeat<kConfig, kStage>>) {
    return kStage;
  } else {
    return stage_of<kConfig, Beat, kStage + 1>();
  }
}

}  // namespace feline
