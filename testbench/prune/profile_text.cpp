// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace feline {
namespace {

// "never" is told of no more legal values than this: every mantissa, but no size of a texture.
constexpr std::int64_t kMostLegal = 256;
constexpr std::size_t kMostRanges = 8;
constexpr std::size_t kMostSources = 6;

// "1 to 8, 12" of values in order.
std::string ranges(const std::vector<std::int64_t>& values) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size();) {
    std::size_t end = i + 1;
    while (end < values.size() && values[end] == values[end - 1] + 1) ++end;
    if (count++ == kMostRanges) {
      return text + fmt::format(" and {} more, up to {}", values.size() - i, values.back());
    }
    text += text.empty() ? "" : ", ";
    text += end - i == 1 ? fmt::format("{}", values[i]) : fmt::format("{} to {}", values[i], values[end - 1]);
    i = end;
  }
  return text;
}

std::string shares(const ReachFacts& of, const Histogram& histogram) {
  std::vector<std::pair<std::uint64_t, std::int64_t>> order;
  for (const auto& [value, count] : histogram) order.emplace_back(count, value);
  std::ranges::stable_sort(order, std::greater{}, [](const auto& item) { return item.first; });
  std::string text;
  for (const auto& [count, value] : order) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", value_name(of, value), percent(count, total(histogram)));
  }
  return text;
}

std::string names_of(const ReachFacts& of, const std::vector<std::int64_t>& values) {
  std::vector<std::string> names;
  for (const std::int64_t value : values) names.push_back(value_name(of, value));
  return fmt::format("{}", fmt::join(names, ", "));
}

// Status bits that are in no set of them.
std::string never_raised(const Histogram& sets) {
  std::int64_t raised = 0;
  for (const auto& [set, count] : sets) raised |= set;
  std::vector<std::string_view> names;
  for (std::size_t bit = 0; bit < kStatusNames.size(); ++bit) {
    if ((raised >> bit & 1) == 0) names.push_back(kStatusNames[bit]);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "-";
  return fmt::format("{:.3g} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::vector<ReachWords> reach_words(const Profile& profile) {
  std::vector<ReachWords> all;
  for (std::size_t i = 0; i < kReachCount; ++i) {
    const ReachFacts& of = kReachFacts[i];
    const Histogram& histogram = profile.reached[i];
    ReachWords words{&of, {}, {}};
    std::vector<std::int64_t> reached;
    std::vector<std::int64_t> never;
    for (const auto& [value, count] : histogram) reached.push_back(value);
    words.reached = reached.empty()       ? "nothing"
                    : !of.names.empty()   ? shares(of, histogram)
                    : reached.size() == 1 ? fmt::format("{}", reached.front())
                                          : fmt::format("{}", ranges(reached));
    if (of.most - of.least < kMostLegal) {
      for (std::int64_t value = of.least; value <= of.most; ++value) {
        if (!histogram.contains(value)) never.push_back(value);
      }
    }
    words.never = static_cast<Reach>(i) == Reach::kStatus ? never_raised(histogram)
                  : of.names.empty()                      ? ranges(never)
                                                          : names_of(of, never);
    all.push_back(std::move(words));
  }
  return all;
}

std::string profile_headline(const Profile& profile) {
  std::vector<std::string> names;
  for (const auto& [name, frames] : profile.sources) {
    if (names.size() == kMostSources) {
      names.push_back(fmt::format("{} more", profile.sources.size() - kMostSources));
      break;
    }
    names.push_back(frames == 1 ? name : fmt::format("{} ({} frames)", name, frames));
  }
  const double each =
      profile.lookups == 0 ? 0 : static_cast<double>(profile.probes) / static_cast<double>(profile.lookups);
  return fmt::format("{} lookups with {} probes, {:.2f} each, in {} frame{} of {}.", profile.lookups, profile.probes,
                     each, profile.frames(), profile.frames() == 1 ? "" : "s",
                     names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", ")));
}

std::string profile_to_text(const Profile& profile) {
  std::string text = profile_headline(profile) + "\n";
  for (const ReachWords& words : reach_words(profile)) {
    text += fmt::format("{:<30} {}", fmt::format("{} {}", words.of->part, words.of->name), words.reached);
    text += words.never.empty() ? "\n" : fmt::format("; never {}\n", words.never);
  }
  for (const auto& [hash, use] : profile.textures) {
    text += fmt::format("{:<30} {} of {} memory lines of {} x {} {} texels, {} of level 0\n",
                        fmt::format("texture {}", fmt::join(use.names, "+")), use.touched.count(), use.touched.size(),
                        use.width, use.height, kTexelFormatNames[static_cast<std::size_t>(use.format)],
                        percent(use.touched.count(0, use.line_count(0)), use.line_count(0)));
  }
  return text;
}

}  // namespace feline
