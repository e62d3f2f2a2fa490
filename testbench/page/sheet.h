// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feline::page {

// One picture or plot of a sheet, with its words beneath.
struct Panel {
  std::string svg;    // an element, as svg of a plot or picture make it
  std::string label;  // one line; none where empty
  std::string note;   // as many lines as it needs
};

// A figure as one SVG file that needs no network: panels in rows, a caption beneath, on white.
struct Sheet {
  std::string title;  // for those who do not see it
  std::vector<Panel> panels;
  int columns = 1;
  int panel_width = 0;  // pixels
  int panel_height = 0;
  std::string caption;
};
std::string to_svg(const Sheet& sheet);

// A PNG file's bytes as an element; enlarged by whole pixels, without smoothing.
std::string picture(std::span<const std::byte> png, int width, int height, std::string_view text);

// Text in lines of at most `length` characters where a word allows it.
std::vector<std::string> wrapped(std::string_view text, std::size_t length);

}  // namespace feline::page
