// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/page/html.h"

namespace feline::page {
namespace {

constexpr int kMargin = 12;
constexpr int kLine = 18;
constexpr double kCharacter = 7.0;  // the mean width of one at this size, rounded up: SVG breaks no lines itself

std::size_t characters(int width) { return static_cast<std::size_t>(std::max(width / kCharacter, 8.0)); }

// Lines of text from a first base line down.
std::string lines(const std::vector<std::string>& texts, int x, int y, std::string_view attributes) {
  std::string svg;
  for (const std::string& text : texts) {
    svg += fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", x, y, attributes, escape(text));
    y += kLine;
  }
  return svg;
}

std::string placed(std::string_view svg, int x, int y, int width, int height) {
  return fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}\n", x, y, width, height,
                     svg.substr(std::string_view("<svg").size()));
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t length) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    if (!line.empty() && line.size() + 1 + word.size() > length) {
      lines.push_back(line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string to_svg(const Sheet& sheet) {
  std::vector<std::vector<std::string>> notes;
  std::size_t note_lines = 0;
  bool labels = false;
  for (const Panel& panel : sheet.panels) {
    notes.push_back(wrapped(panel.note, characters(sheet.panel_width)));
    note_lines = std::max(note_lines, notes.back().size());
    labels = labels || !panel.label.empty();
  }
  const int words = kLine * (static_cast<int>(note_lines) + (labels ? 1 : 0)) + kMargin;
  const int columns = std::max(sheet.columns, 1);
  const int rows = (static_cast<int>(sheet.panels.size()) + columns - 1) / columns;
  const int width = columns * (sheet.panel_width + kMargin) + kMargin;
  const std::vector<std::string> caption = wrapped(sheet.caption, characters(width - 2 * kMargin));
  const int below = kMargin + rows * (sheet.panel_height + words);
  const int height = below + kLine * static_cast<int>(caption.size()) + kMargin;

  // Its own colours, whatever the page around it has.
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0}\" width=\"{1}\" height=\"{2}\" "
      "viewBox=\"0 0 {1} {2}\" color=\"#1b1f24\" fill=\"#1b1f24\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"{1}\" height=\"{2}\" fill=\"#fff\"/>\n",
      escape(sheet.title), width, height);
  for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
    const int x = kMargin + static_cast<int>(i) % columns * (sheet.panel_width + kMargin);
    const int y = kMargin + static_cast<int>(i) / columns * (sheet.panel_height + words);
    int text = y + sheet.panel_height + kLine - 2;
    svg += placed(sheet.panels[i].svg, x, y, sheet.panel_width, sheet.panel_height);
    if (labels) {
      svg += lines({sheet.panels[i].label}, x, text, " font-weight=\"bold\"");
      text += kLine;
    }
    svg += lines(notes[i], x, text, "");
  }
  return svg + lines(caption, kMargin, below + kLine - 2, "") + "</svg>\n";
}

std::string picture(std::span<const std::byte> png, int width, int height, std::string_view text) {
  return fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\"><image width=\"{0}\" height=\"{1}\" style=\"image-rendering:pixelated\" "
      "aria-label=\"{2}\" href=\"data:image/png;base64,{3}\"/></svg>",
      width, height, escape(text), base64(png));
}

}  // namespace feline::page
