// SPDX-License-Identifier: Apache-2.0
#include "testbench/figures/figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/error.h"

namespace feline {
namespace {

std::vector<Figure> make_figures() {
  std::vector<Figure> all;
  for (const auto family : {shape_figures, picture_figures, cost_figures, vertex_figures, pattern_figures}) {
    for (Figure& figure : family()) all.push_back(std::move(figure));
  }
  return all;
}

}  // namespace

std::span<const Figure> figures() {
  static const std::vector<Figure> all = make_figures();
  return all;
}

const Figure& find_figure(std::string_view name) {
  const auto found = std::ranges::find(figures(), name, &Figure::name);
  if (found != figures().end()) return *found;
  std::string legal;
  for (const Figure& figure : figures()) legal += figure.name + ", ";
  bad_input("figure", "name", name, legal + "all");
}

}  // namespace feline
