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

// In the order of the papers.
std::span<const Figure> figures();

// Throws InputError listing the legal names.
const Figure& find_figure(std::string_view name);

// A file a family: surface plots of filter shapes, pictures, costs, vertex-based texturing.
std::vector<Figure> shape_figures();
std::vector<Figure> picture_figures();
std::vector<Figure> cost_figures();
std::vector<Figure> vertex_figures();

}  // namespace feline
