// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace feline::page {

// What plots of every kind share.
struct Drawing {
  std::string name;  // letters, digits, '-' or '_': keeps the drawings of a page apart
  std::string title;
  int width;  // of the view box; text is 15 high
  int height;
};

// Throws InputError when there is no gnuplot: before the work whose plots it is to draw.
void check_gnuplot();

// A text in single quotes, in which gnuplot runs nothing and escapes nothing.
std::string quoted(std::string_view text);

// What the commands draw as an SVG element for a page: without network references, in the page's text colour, the same
// bytes for the same commands. Throws InputError when there is no gnuplot, or when it fails.
std::string run_gnuplot(std::string_view commands, const Drawing& drawing);

}  // namespace feline::page
