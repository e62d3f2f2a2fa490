// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "testbench/budget/budget_report.h"
#include "testbench/measure/contestant.h"
#include "testbench/prune/observe.h"
#include "testbench/prune/prune.h"
#include "tests/testbench/budget/hardware_for.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/measure/surfaces.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr int kSide = 24;
constexpr double kAny = 1e9;

ExhibitPlan small_plan(const std::string& name) { return plan_exhibit(small_scene(name), kSide, kSide); }

SearchOptions small_search(const std::vector<double>& decibels) {
  SearchOptions options;
  options.survey.space = Space::kSmall;
  options.survey.strata = 4;
  for (const double limit : decibels) options.budgets.push_back({Budget::Kind::kDecibels, limit});
  return options;
}

SceneSearch search(const ExhibitPlan& plan, const SearchOptions& options, const Cache& cache) {
  Progress progress("searching", search_work(options.cost));
  return search_scene(plan, options, cache, progress);
}

// A measurement that nobody made.
Measurement made_up(const Config& hardware, double psnr, double cycles = 1, double worst = 0.5) {
  Measurement measurement;
  measurement.gaussian.mean_square = std::pow(10, -psnr / 10);
  measurement.gaussian.worst = worst;
  measurement.box = measurement.gaussian;
  measurement.cycles = cycles;
  measurement.hardware = hardware;
  return measurement;
}

// A count that rises with every width and feature.
double fake_gates(const Config& config) {
  double gates = 100 * FormatSet(config).position.width();
  for (const ConfigField& each : kConfigFields) {
    if (each.field != &Config::guard_bits && each.field != &Config::least_range_log2) gates += 10 * config.*each.field;
  }
  for (const FeatureField& each : kFeatureFields) gates += config.features.*each.field ? 500 : 0;
  return gates;
}

TEST(budget_space, each_difference_once) {
  for (const Space space : {Space::kSmall, Space::kFull}) {
    const std::vector<Candidate> all = candidates_of(space);
    std::set<std::string> names;
    for (const Candidate& each : all) {
      EXPECT_TRUE(names.insert(sampler_name(each) + "; " + widths_name(each)).second) << sampler_name(each);
      EXPECT_EQ(variant_of(each.widths).config, config_of(each.widths));
      EXPECT_EQ(fault_of(config_of(each.widths)).field, "");
    }
    for (const Kernel kernel : {Kernel::kBilinear, Kernel::kGaussian}) {
      EXPECT_EQ(std::ranges::count(all, full_candidate(kernel)), 1);
    }
  }
  EXPECT_GE(candidates_of(Space::kSmall).size(), 60U);
  EXPECT_LE(candidates_of(Space::kSmall).size(), 120U);
  // 3 mantissas, 2 sub-texels and 2 levels in every mode; tables, weights, probes, parameters and kernels where they
  // make a difference.
  const std::size_t few = 12;
  const std::size_t probes = few + 7 * 2 * few;
  EXPECT_EQ(candidates_of(Space::kFull).size(), few + 2 * (2 * few + probes + 3 * probes + 2 * 3 * probes));
  EXPECT_THROW(variant_of({5}), std::out_of_range);
}

TEST(budget_space, names_say_what_makes_a_difference) {
  EXPECT_EQ(sampler_name({}), "table, bilinear, exact, 16 probes");
  EXPECT_EQ(widths_name({}), "mantissa 8, table 16, sub-texel 8, level 8, weight 8");
  const Candidate nearest{{6, 8, 5, 5, 6}, Mode::kNearest, Kernel::kBilinear, ParameterSet::kExact, 1};
  EXPECT_EQ(sampler_name(nearest), "nearest");
  EXPECT_EQ(widths_name(nearest), "mantissa 6, sub-texel 5, level 5");
}

// The variant of the default widths is the unit that a report measures.
TEST(budget_variant, the_widest_is_the_unit) {
  const Exhibit exhibit = small_plan("bricks").build();
  const View& view = exhibit.frames.front();
  for (const char* const name : {"unit_nearest", "unit_ext", "unit_simple_high_efficiency", "unit_table_gaussian"}) {
    const Contestant& contestant = *find_contestant(name);
    const Rendering rendering = contestant.render(view, nullptr);
    const auto sampler =
        make_sampler<kDefaultConfig>(*contestant.sampler, exhibit.surface->texture, exhibit.surface->memory);
    std::vector<std::array<float, 4>> colours(view.gbuffer.lookups.size());
    VariantUse use;
    variant_of({}).sample(sampler, exhibit.surface->memory, view.gbuffer.lookups, colours, use);
    EXPECT_EQ(colours, rendering.picture.pixels) << name;
    EXPECT_EQ(static_cast<double>(use.probes), rendering.cost.probes) << name;
  }
}

// What a candidate is said to need is what pruning finds in a profile, but for the words of ROMs.
TEST(budget_hardware, is_the_pruned_unit) {
  for (const char* const name : {"bricks", "runway", "spin"}) {
    const Exhibit exhibit = small_plan(name).build();
    const Surface& surface = *exhibit.surface;
    for (const Candidate& candidate :
         {full_candidate(Kernel::kGaussian),
          Candidate{{}, Mode::kSimple, Kernel::kBilinear, ParameterSet::kHighEfficiency, 4},
          Candidate{{}, Mode::kTrilinear, Kernel::kBilinear, ParameterSet::kExact, 1}}) {
      const auto sampler = make_sampler<kDefaultConfig>(sampler_options(candidate), surface.texture, surface.memory);
      const std::vector<Lookup>& lookups = exhibit.frames.front().gbuffer.lookups;
      std::vector<std::array<float, 4>> colours(lookups.size());
      VariantUse use;
      variant_of(candidate.widths).sample(sampler, surface.memory, lookups, colours, use);
      Profile profile;
      observe(profile, name, lookups, sampler, surface.memory, profiled_texture(name, surface.texture));
      Config pruned = pruned_config(profile);
      pruned.table_cells = kDefaultConfig.table_cells;
      pruned.weight_rows = kDefaultConfig.weight_rows;
      EXPECT_EQ(unit_header(hardware_of(candidate, sampler, use)), unit_header(pruned)) << sampler_name(candidate);
    }
  }
}

TEST(budget_hardware, a_narrower_unit_needs_no_more) {
  const Exhibit exhibit = small_plan("bricks").build();
  const auto hardware = [&](const Candidate& candidate) { return hardware_for(exhibit, candidate); };
  const Config whole = hardware(full_candidate(Kernel::kBilinear));
  EXPECT_TRUE(needs_no_more(whole, kDefaultConfig));
  EXPECT_FALSE(needs_no_more(kDefaultConfig, whole));
  for (const Widths& widths :
       {Widths{6}, Widths{8, 8}, Widths{8, 16, 5}, Widths{8, 16, 8, 5}, Widths{8, 16, 8, 8, 6}}) {
    const Config narrow = hardware({widths});
    EXPECT_EQ(fault_of(narrow).field, "");
    EXPECT_TRUE(needs_no_more(narrow, whole)) << widths_name({widths});
    EXPECT_FALSE(needs_no_more(whole, narrow)) << widths_name({widths});
  }
  const Config gaussian = hardware(full_candidate(Kernel::kGaussian));
  EXPECT_TRUE(needs_no_more(whole, gaussian));
  EXPECT_FALSE(needs_no_more(gaussian, whole));
}

// By brute force over every candidate's own measurement: what is chosen holds, and nothing cheaper does.
TEST(budget_search, exhaustive_on_the_small_space) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  for (const char* const name : {"bricks", "spin"}) {
    const SearchOptions options = small_search({0.1, 0.5, 1});
    const ExhibitPlan plan = small_plan(name);
    const SceneSearch found = search(plan, options, cache);
    BudgetScene scene(plan, options.survey, cache);
    const double full = scene.measure(full_candidate(Kernel::kBilinear)).gaussian.psnr();
    std::vector<double> cheapest(options.budgets.size(), kAny);
    for (const Candidate& candidate : candidates_of(Space::kSmall)) {
      const Measurement measured = scene.measure(candidate);
      for (std::size_t i = 0; i < options.budgets.size(); ++i) {
        if (full - measured.gaussian.psnr() > options.budgets[i].limit) continue;
        cheapest[i] = std::min(cheapest[i], measured.cycles);
      }
    }
    ASSERT_EQ(found.choices.size(), options.budgets.size());
    for (std::size_t i = 0; i < options.budgets.size(); ++i) {
      const BudgetChoice& choice = found.choices[i];
      ASSERT_TRUE(choice.chosen.has_value());
      EXPECT_TRUE(choice.holds);
      EXPECT_EQ(found.measurements[*choice.chosen].cycles, cheapest[i]) << name << ", " << budget_name(choice.budget);
      EXPECT_LE(full - choice.verified->gaussian.psnr(), choice.budget.limit);
    }
  }
}

TEST(budget_search, budgets_without_end_and_of_nothing) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const SceneSearch found = search(small_plan("bricks"), small_search({kAny, 0}), cache);
  const BudgetChoice& any = found.choices[0];
  EXPECT_EQ(any.holding, found.measurements.size());
  for (const Measurement& each : found.measurements) EXPECT_GE(each.cycles, found.measurements[*any.chosen].cycles);
  EXPECT_EQ(found.measurements[*any.chosen].cycles, 1);
  const BudgetChoice& none = found.choices[1];
  ASSERT_TRUE(none.chosen.has_value());
  EXPECT_LE(none.verified->gaussian.mean_square, found.measurements[found.full].gaussian.mean_square);
  EXPECT_LE(found.measurements[*none.chosen].cycles, found.full_cost);
}

TEST(budget_search, the_worst_pixel_and_the_box) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SearchOptions options = small_search({});
  options.truth = TruthChoice::kBox;
  options.budgets = {{Budget::Kind::kWorst, 255}, {Budget::Kind::kWorst, 0}};
  const SceneSearch found = search(small_plan("bricks"), options, cache);
  EXPECT_EQ(found.choices[0].holding, found.measurements.size());
  EXPECT_FALSE(found.choices[1].chosen.has_value());
  EXPECT_FALSE(found.choices[1].holds);
  EXPECT_FALSE(all_hold({found}));
  double least = 1;
  for (const Measurement& each : found.measurements) least = std::min(least, each.box.worst);
  options.budgets = {{Budget::Kind::kWorst, 255 * least}};
  const SceneSearch again = search(small_plan("bricks"), options, cache);
  EXPECT_EQ(again.choices[0].verified.value().box.worst, least);
  EXPECT_TRUE(all_hold({again}));
}

// A search that was stopped goes on: what is there is not measured again, what is damaged or missing is.
TEST(budget_search, goes_on_from_its_cache) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const SearchOptions options = small_search({0.5});
  const std::string whole = budget_json({search(small_plan("bricks"), options, cache)}, options).dump();
  std::map<std::string, std::string> entries;
  for (const auto& file : std::filesystem::directory_iterator(dir / "cache")) {
    entries[file.path().filename().string()] = read_bytes(file.path());
  }
  ASSERT_GT(entries.size(), 2U);
  bool damage = false;
  for (const auto& [name, bytes] : entries) {
    if (damage) {
      write_bytes(dir / ("cache/" + name), bytes.substr(0, bytes.size() / 2));
    } else {
      std::filesystem::remove(dir / ("cache/" + name));
    }
    damage = !damage;
    if (name > std::next(entries.begin(), static_cast<std::ptrdiff_t>(entries.size()) / 2)->first) break;
  }
  EXPECT_EQ(budget_json({search(small_plan("bricks"), options, cache)}, options).dump(), whole);
  for (const auto& [name, bytes] : entries) EXPECT_TRUE(std::filesystem::exists(dir / ("cache/" + name)));
  // Nothing is left to do: entries stay as they are, to the byte.
  std::size_t same = 0;
  for (const auto& [name, bytes] : entries) same += read_bytes(dir / ("cache/" + name)) == bytes ? 1 : 0;
  EXPECT_GE(same, 1U);
}

TEST(budget_search, the_same_for_a_seed) {
  const TempDir dir;
  SearchOptions options = small_search({0.1, 1});
  const auto told = [&](const std::string& name) {
    const Cache cache(dir / name);
    return budget_json({search(small_plan("bricks"), options, cache)}, options).dump();
  };
  const std::string first = told("a");
  EXPECT_EQ(told("b"), first);
  options.survey.seed = 2;
  EXPECT_NE(told("c"), first);
}

// A choice that does not hold, or is not the cheapest, is told.
TEST(budget_search, a_cheaper_one_is_found) {
  const std::vector<Measurement> all{made_up({}, 40, 5), made_up({}, 39.6, 3), made_up({}, 39.7, 3),
                                     made_up({}, 30, 1)};
  const Costs costs = measured_costs(all, CostKind::kCycles);
  const Budget budget{Budget::Kind::kDecibels, 0.5};
  const Errors& full = all.front().gaussian;
  const auto places = holding(all, full, TruthChoice::kGaussian, budget);
  EXPECT_EQ(places, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(choose(all, costs, places, TruthChoice::kGaussian), 2U);
  EXPECT_EQ(cheaper_one(all, costs, full, TruthChoice::kGaussian, budget, 0), 1U);
  EXPECT_EQ(cheaper_one(all, costs, full, TruthChoice::kGaussian, budget, 2), std::nullopt);
  EXPECT_EQ(pareto_front(all, costs, TruthChoice::kGaussian), (std::vector<std::size_t>{3, 2, 0}));
}

TEST(budget_search, of_equal_costs_the_plainest_unit_is_taken) {
  std::vector<Measurement> all(4, made_up({}, 40, 1));
  all[1].candidate = {{6, 8, 5, 5, 6}, Mode::kTable};
  all[2].candidate = {{7, 8, 5, 5, 6}, Mode::kBilinear};
  all[3].candidate = {{6, 8, 5, 5, 6}, Mode::kBilinear};
  all[3].gaussian.mean_square *= 1.01;
  const Costs costs = measured_costs(all, CostKind::kCycles);
  const std::vector<std::size_t> places{0, 1, 2, 3};
  EXPECT_EQ(choose(all, costs, std::span(places).first(2), TruthChoice::kGaussian), 1U);
  EXPECT_EQ(choose(all, costs, std::span(places).first(3), TruthChoice::kGaussian), 2U);
  EXPECT_EQ(choose(all, costs, places, TruthChoice::kGaussian), 3U);
}

// Of gates only those that have to be known are asked for, each unit once, and the least is found all the same.
TEST(budget_search, gates_are_counted_where_it_matters) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SearchOptions options = small_search({0.1, 1, 3});
  options.cost = CostKind::kGates;
  std::map<std::string, int> asked;
  options.gates = [&](const Config& config) {
    ++asked[unit_header(config)];
    return fake_gates(config);
  };
  const SceneSearch found = search(small_plan("bricks"), options, cache);
  EXPECT_LT(asked.size(), found.measurements.size() / 2);
  for (const auto& [unit, times] : asked) EXPECT_EQ(times, 1) << unit;
  EXPECT_EQ(found.full_cost, fake_gates(kDefaultConfig));
  const Errors& full = found.measurements[found.full].gaussian;
  for (const BudgetChoice& choice : found.choices) {
    double least = kAny;
    for (const Measurement& each : found.measurements) {
      if (holds(each.gaussian, full, choice.budget)) least = std::min(least, fake_gates(each.hardware));
    }
    EXPECT_EQ(found.costs[choice.chosen.value()], least) << budget_name(choice.budget);
    EXPECT_TRUE(choice.holds);
  }
}

TEST(budget_report, page_and_table) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SearchOptions options = small_search({0.1, 1});
  options.budgets.push_back({Budget::Kind::kWorst, 0});
  const SceneSearch found = search(small_plan("bricks"), options, cache);
  const std::string html = budget_page({found}, options);
  EXPECT_EQ(html_fault(html), "");
  EXPECT_NE(html.find("none holds"), std::string::npos);
  EXPECT_NE(html.find("0.1 dB"), std::string::npos);
  const std::string csv = budget_csv({found}, options);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), 1 + found.measurements.size());
  const auto json = budget_json({found}, options);
  EXPECT_EQ(json["scenes"][0]["budgets"].size(), 3U);
  EXPECT_EQ(json["holds"], false);
  EXPECT_NE(budget_text({found}, options).find("none holds"), std::string::npos);
}

}  // namespace
}  // namespace feline
