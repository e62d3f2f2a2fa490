// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/ratchet.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "testbench/error.h"
#include "testbench/json_input.h"

namespace feline::coverage {
namespace {

std::size_t index_of(Kind kind) { return static_cast<std::size_t>(kind); }

std::string place_of(const Point& point) {
  return point.line == 0 ? std::string() : fmt::format(", {}:{}", point.file, point.line);
}

}  // namespace

Figures figures_of(const std::vector<Point>& points) {
  Figures figures;
  for (const Point& point : points) {
    Figure& figure = figures[index_of(point.kind)];
    if (!point.excluded.empty()) {
      ++figure.excluded;
      continue;
    }
    ++figure.total;
    if (point.count != 0) ++figure.hit;
  }
  return figures;
}

Ratchet ratchet_of(const std::vector<Point>& points) {
  Ratchet ratchet{figures_of(points), {}};
  for (const Point& point : points) {
    if (point.count == 0 && point.excluded.empty()) ratchet.missing[index_of(point.kind)].push_back(point.name);
  }
  for (auto& names : ratchet.missing) std::ranges::sort(names);
  return ratchet;
}

nlohmann::ordered_json to_json(const Ratchet& ratchet) {
  nlohmann::ordered_json json;
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    const Figure& figure = ratchet.figures[kind];
    json[std::string(kKindNames[kind])] = {{"hit", figure.hit},
                                           {"total", figure.total},
                                           {"excluded", figure.excluded},
                                           {"missing", ratchet.missing[kind]}};
  }
  return json;
}

Ratchet read_ratchet(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) bad_input(file.string(), "open", "nothing", "the ratchet; --update writes it");
  Ratchet ratchet;
  std::string kind_and_field = "JSON";
  try {
    const auto json = nlohmann::ordered_json::parse(in);
    for (std::size_t kind = 0; kind < kKindCount; ++kind) {
      const std::string name(kKindNames[kind]);
      kind_and_field = name;
      const auto& of_kind = json.at(name);
      Figure& figure = ratchet.figures[kind];
      for (const auto& [field, value] : {std::pair{"hit", &figure.hit}, std::pair{"total", &figure.total},
                                         std::pair{"excluded", &figure.excluded}}) {
        kind_and_field = fmt::format("{}.{}", name, field);
        *value = whole_from_json<std::uint64_t>(of_kind.at(field));
      }
      kind_and_field = name + ".missing";
      ratchet.missing[kind] = of_kind.at("missing").get<std::vector<std::string>>();
    }
  } catch (const std::exception& error) {
    bad_input(file.string(), kind_and_field, error.what(), "as --update writes it");
  }
  return ratchet;
}

std::vector<std::string> losses(const std::vector<Point>& points, const Ratchet& before) {
  std::vector<std::string> lost;
  for (const Point& point : points) {
    if (point.count != 0 || !point.excluded.empty()) continue;
    if (std::ranges::binary_search(before.missing[index_of(point.kind)], point.name)) continue;
    lost.push_back(fmt::format("{} not reached: {}{}", kind_name(point.kind), point.name, place_of(point)));
  }
  const Figures now = figures_of(points);
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    const Figure& was = before.figures[kind];
    const Figure& is = now[kind];
    if (is.hit < was.hit) {
      lost.push_back(
          fmt::format("{}: {} of {} reached, {} of {} before; if points went away with what was counted, "
                      "--update records it",
                      kKindNames[kind], is.hit, is.total, was.hit, was.total));
    }
  }
  return lost;
}

std::string share_text(const Figure& figure) {
  if (figure.total == 0) return "";
  if (figure.hit == figure.total) return "100 %";
  const std::uint64_t hundredths = figure.hit * 10000 / figure.total;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

}  // namespace feline::coverage
