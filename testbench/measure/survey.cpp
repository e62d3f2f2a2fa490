// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "testbench/json_input.h"
#include "testbench/measure/truth_store.h"
#include "testbench/page/html.h"
#include "testbench/progress.h"

namespace feline {
namespace {

constexpr int kDetailSize = 96;
// What pieces of work take, for the progress bar.
constexpr std::uint64_t kTruthWork = 2000;
constexpr std::uint64_t kCellWork = 100;

nlohmann::ordered_json to_json(const Detail& detail) {
  return {{"left", detail.left}, {"top", detail.top}, {"size", detail.size}};
}

Detail detail_from_json(const nlohmann::ordered_json& json) {
  return {whole_from_json<int>(json.at("left")), whole_from_json<int>(json.at("top")),
          whole_from_json<int>(json.at("size"))};
}

nlohmann::ordered_json to_json(const TruthFacts& facts) {
  return {{"gaussian_error", facts.gaussian_error},
          {"box_error", facts.box_error},
          {"samples", facts.samples},
          {"detail", to_json(facts.focus.detail)},
          {"quarter", to_json(facts.focus.quarter)},
          {"overview_png", facts.overview_png},
          {"gaussian_png", facts.gaussian_png},
          {"box_png", facts.box_png}};
}

TruthFacts facts_from_json(const nlohmann::ordered_json& json) {
  return {json.at("gaussian_error"),
          json.at("box_error"),
          whole_from_json<int>(json.at("samples")),
          {detail_from_json(json.at("detail")), detail_from_json(json.at("quarter"))},
          json.at("overview_png"),
          json.at("gaussian_png"),
          json.at("box_png")};
}

nlohmann::ordered_json to_json(const Split& split) {
  return {{"kernel", split.kernel}, {"feline", split.feline}, {"table", split.table}, {"arithmetic", split.arithmetic}};
}

Split split_from_json(const nlohmann::ordered_json& json) {
  return {json.at("kernel"), json.at("feline"), json.at("table"), json.at("arithmetic")};
}

// The pictures between which the unit's error is split.
struct SplitNames {
  std::string_view kernel, ideal, table, unit;
};
constexpr std::array<SplitNames, 2> kSplits{
    {{"bilinear", "feline_ideal", "feline_table", "unit_table"},
     {"gaussian", "feline_ideal_gaussian", "feline_table_gaussian", "unit_table_gaussian"}}};

class Clock {
 public:
  explicit Clock(std::optional<double> budget) : budget_(budget) {}
  bool over() const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    return budget_ && spent.count() > *budget_;
  }

 private:
  std::optional<double> budget_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// One exhibit's share of a survey: builds what it needs when it needs it. Nothing is what the budget does not allow to
// begin.
class Work {
 public:
  Work(const ExhibitPlan& plan, const SurveyOptions& options, const Cache& cache, const Clock& clock)
      : plan_(plan), cache_(cache), clock_(clock), strata_(options.strata), seed_(options.seed) {}

  std::optional<TruthFacts> truth(Progress& progress) {
    return within_budget<TruthFacts>("facts", facts_from_json, [&] { return make_facts(&progress); });
  }
  std::optional<Cell> cell(const Contestant& contestant) {
    return within_budget<Cell>("cell " + contestant.name, cell_from_json,
                               [&] { return measure_cell(contestant, exhibit(), truths(nullptr), focus()); });
  }
  std::optional<Split> split(const SplitNames& names) {
    return within_budget<Split>(fmt::format("split {}", names.kernel), split_from_json,
                                [&] { return make_split(names); });
  }

 private:
  template <typename Result, typename Parse, typename Make>
  std::optional<Result> within_budget(const std::string& what, Parse parse, Make make) {
    const std::string key = cache_key(what);
    if (const auto stored = cache_.read(key)) return parse(nlohmann::ordered_json::parse(*stored));
    if (clock_.over()) return std::nullopt;
    Result result = make();
    cache_.write(key, to_json(result).dump());
    return result;
  }

  std::string cache_key(const std::string& what) const {
    return cache_.key({what, plan_.identity, std::to_string(strata_), std::to_string(seed_)});
  }

  const Exhibit& exhibit() {
    if (!exhibit_) exhibit_ = plan_.build();
    return *exhibit_;
  }

  const std::vector<Truth>& truths(Progress* progress) {
    for (std::size_t i = truths_.size(); i < static_cast<std::size_t>(plan_.frame_count); ++i) {
      const std::string key = cache_key(fmt::format("truth {}", i));
      if (const auto stored = cache_.read(key)) {
        truths_.push_back(truth_from_bytes(*stored));
        continue;
      }
      truths_.push_back(compute_truth(exhibit().frames[i], strata_, seed_ + i, progress));
      cache_.write(key, to_bytes(truths_.back()));
    }
    return truths_;
  }

  // What is begun is finished, whatever the budget.
  Focus focus() {
    if (const auto stored = cache_.read(cache_key("facts"))) {
      return facts_from_json(nlohmann::ordered_json::parse(*stored)).focus;
    }
    return make_facts(nullptr).focus;
  }

  TruthFacts make_facts(Progress* progress) {
    const Truth& first = truths(progress).front();
    const FloatPicture trilinear = find_contestant("trilinear")->render(exhibit().frames.front(), nullptr).picture;
    TruthFacts facts;
    for (const Truth& frame : truths(nullptr)) {
      facts.gaussian_error = std::max(facts.gaussian_error, frame.gaussian_error);
      facts.box_error = std::max(facts.box_error, frame.box_error);
    }
    // Those are means over three channels, of which the texture may leave some empty.
    const double share = std::sqrt(3.0 / std::min(exhibit().channels(), 3));
    facts.gaussian_error *= share;
    facts.box_error *= share;
    facts.samples = first.samples;
    facts.focus = {find_detail(trilinear, first.gaussian, std::min(kDetailSize, std::max(plan_.width, plan_.height))),
                   find_detail(trilinear, first.gaussian, std::max(std::max(plan_.width, plan_.height) / 2, 1))};
    const bool srgb = exhibit().srgb();
    const int channels = exhibit().channels();
    facts.overview_png = page::base64(picture_png(first.gaussian, srgb, channels));
    facts.gaussian_png = page::base64(detail_png(first.gaussian, facts.focus.detail, srgb, channels));
    facts.box_png = page::base64(detail_png(first.box, facts.focus.detail, srgb, channels));
    return facts;
  }

  Split make_split(const SplitNames& names) {
    Split split{std::string(names.kernel)};
    const double share = 1.0 / plan_.frame_count;
    const int channels = exhibit().channels();
    for (std::size_t i = 0; i < exhibit().frames.size(); ++i) {
      const auto picture = [&](std::string_view name) {
        return find_contestant(name)->render(exhibit().frames[i], nullptr).picture;
      };
      const FloatPicture ideal = picture(names.ideal);
      const FloatPicture table = picture(names.table);
      split.feline += share * compare(ideal, truths(nullptr)[i].gaussian, channels).mean_square;
      split.table += share * compare(table, ideal, channels).mean_square;
      split.arithmetic += share * compare(picture(names.unit), table, channels).mean_square;
    }
    return split;
  }

  const ExhibitPlan& plan_;
  const Cache& cache_;
  const Clock& clock_;
  int strata_;
  std::uint64_t seed_;
  std::optional<Exhibit> exhibit_;
  std::vector<Truth> truths_;
};

std::uint64_t pixel_count(const ExhibitPlan& plan) {
  return static_cast<std::uint64_t>(plan.width) * static_cast<std::uint64_t>(plan.height) *
         static_cast<std::uint64_t>(plan.frame_count);
}

}  // namespace

Survey run_survey(const SurveyOptions& options, const Cache& cache) {
  const Clock clock(options.budget);
  const std::uint64_t pieces = options.contestants.size() + kSplits.size();
  Progress progress("measuring", options.exhibits.size() * (kTruthWork + pieces * kCellWork));
  Survey survey;
  for (const ExhibitPlan& plan : options.exhibits) {
    ExhibitResult result{plan, std::nullopt, {}, {}};
    Work work(plan, options, cache, clock);
    // `measure` gives whether it was allowed.
    const auto piece = [&](std::uint64_t share, std::uint64_t total, const auto& measure) {
      Progress part(progress, share, total);
      if (!measure(part)) ++survey.missing;
    };
    const auto keep = [](auto& results, auto measured) {
      if (!measured) return false;
      results.push_back(*std::move(measured));
      return true;
    };
    piece(kTruthWork, pixel_count(plan), [&](Progress& part) {
      result.truth = work.truth(part);
      return result.truth.has_value();
    });
    for (const Contestant* const contestant : options.contestants) {
      piece(kCellWork, 1, [&](Progress&) { return keep(result.cells, work.cell(*contestant)); });
    }
    for (const SplitNames& names : kSplits) {
      piece(kCellWork, 1, [&](Progress&) { return keep(result.splits, work.split(names)); });
    }
    survey.results.push_back(std::move(result));
  }
  return survey;
}

}  // namespace feline
