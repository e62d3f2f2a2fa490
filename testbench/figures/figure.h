// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feline {

// The figures of the papers, made again by this project's filters.

struct FigureOptions {
  int size = 256;  // of each picture, pixels a side; for figures that have pictures
};

struct FigureOutput {
  std::string content;           // the file's bytes
  nlohmann::ordered_json facts;  // its figures, in numbers
};

struct Figure {
  std::string name;
  std::string description;  // one line
  std::string extension;    // with its dot, of the file's kind
  std::function<FigureOutput(const FigureOptions& options)> make;
};

// A family at a time.
std::span<const Figure> figures();

// Throws InputError listing the legal names.
const Figure& find_figure(std::string_view name);

// The families: surface plots of filter shapes, Feline's pictures, costs, vertex-based texturing's pictures and
// patterns.
std::vector<Figure> shape_figures();
std::vector<Figure> picture_figures();
std::vector<Figure> cost_figures();
std::vector<Figure> vertex_figures();
std::vector<Figure> pattern_figures();

}  // namespace feline
