// SPDX-License-Identifier: Apache-2.0
#include <string_view>
#include <vector>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/font.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

constexpr int kSize = 1024;
constexpr int kMargin = 56;  // texels
constexpr double kPaper = 0.95;
constexpr double kInk = 0.06;
constexpr double kTitleDot = 7.0;  // texels a glyph pixel
constexpr double kBodyDot = 2.85;  // not whole, so that strokes have grey edges like real print

constexpr std::string_view kTitle = "Feline at work";
constexpr std::string_view kBody =
    "A pixel is a small round window. Seen through it, a slanted page is an ellipse: long where the page runs away "
    "from you, narrow across. Whoever averages the whole ellipse gets letters that stay sharp; whoever averages the "
    "circle around it gets fog, and whoever looks at one point only gets noise that crawls.\n"
    "Feline lays a row of small round probes along the ellipse, weighs them with a bell, and adds them up. Two probes "
    "are enough for a mild slant, sixteen for a page seen from its edge. Each probe is an ordinary trilinear lookup, "
    "so the hardware that has one already has the other: only the plan of the row is new.\n"
    "How long is the row? How wide is a probe? Simple Feline guesses both from the two gradients of the pixel. Table "
    "Feline looks them up: 16 x 16 cells, 4 bytes each, 1024 bytes in all. Where the gradients are square to each "
    "other, both agree. Where they lean, the guess is too short and too fat, and the text goes soft.\n"
    "This page is the test. Count the lines that you can still read, then count the probes that each of them cost. (0 "
    "1 2 3 4 5 6 7 8 9 + - = / ; : ! ?)\n"
    "The quick brown lynx jumps over sixty lazy voxels; a black cat waits for the judge's fuzzy quartz map.";

// A sheet that is inked by area: a glyph pixel is a rectangle of any size at any place, and each
// texel takes the part of it that is covered.
class Sheet {
 public:
  Sheet() : ink_(static_cast<std::size_t>(kSize) * kSize, 0.0) {}

  void print(char character, double left, double top, double dot) {
    const Glyph& rows = glyph(character);
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        if ((rows[static_cast<std::size_t>(row)] >> (kGlyphWidth - 1 - column) & 1) == 0) continue;
        cover(left + column * dot, top + row * dot, dot);
      }
    }
  }

  MipLevel develop() const {
    MipLevel level{kSize, kSize, {}};
    level.texels.reserve(ink_.size());
    for (const double ink : ink_) level.texels.push_back(quantize(kPaper + (kInk - kPaper) * ink));
    return level;
  }

 private:
  // The length that the unit interval at cell has in common with [from, from + length].
  static double overlap(int cell, double from, double length) {
    const double low = from > cell ? from : cell;
    const double high = from + length < cell + 1.0 ? from + length : cell + 1.0;
    return high > low ? high - low : 0.0;
  }

  void cover(double left, double top, double side) {
    for (int y = static_cast<int>(top); y < top + side && y < kSize; ++y) {
      for (int x = static_cast<int>(left); x < left + side && x < kSize; ++x) {
        ink_[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)] +=
            overlap(x, left, side) * overlap(y, top, side);
      }
    }
  }

  std::vector<double> ink_;
};

// Prints text from (kMargin, top), broken between words at the right margin.
void typeset(Sheet& sheet, std::string_view text, double top, double dot) {
  const double advance = (kGlyphWidth + 1) * dot;
  const double leading = (kGlyphHeight + 2.0) * dot;
  double x = kMargin;
  double y = top;
  const auto new_line = [&](double lines) {
    x = kMargin;
    y += lines * leading;
  };
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    if (x + static_cast<double>(word.size()) * advance > kSize - kMargin) new_line(1.0);
    for (const char character : word) {
      sheet.print(character, x, y, dot);
      x += advance;
    }
    if (end == std::string_view::npos) return;
    x += advance;
    if (text[end] == '\n') new_line(1.45);
    text.remove_prefix(end + 1);
  }
}

TexturePoint project_text(const Dual& x, const Dual& y) {
  constexpr GroundView kView = {.top = 0.09,
                                .bottom = 0.65,
                                .width = 0.56,
                                .cosine = 40.0 / 41.0,
                                .sine = 9.0 / 41.0,
                                .scale = 0.92,
                                .s_offset = 0.12,
                                .t_offset = 2.35};
  return ground_point(kView, x, y);
}

// 64 texels across the picture: at 512 pixels each texel is 8 pixels wide.
TexturePoint project_magnify(const Dual& x, const Dual& y) {
  constexpr double kAcross = 64.0 / kSize;
  constexpr double kCosine = 63.0 / 65.0;
  constexpr double kSine = 16.0 / 65.0;
  const Dual right = kAcross * (x - 0.5);
  const Dual down = kAcross * (y - 0.5);
  return {0.1016 + kCosine * right + kSine * down, 0.3486 + kCosine * down - kSine * right};
}

}  // namespace

MipLevel paint_text() {
  Sheet sheet;
  typeset(sheet, kTitle, kMargin, kTitleDot);
  typeset(sheet, kBody, kMargin + 1.4 * kGlyphHeight * kTitleDot, kBodyDot);
  return sheet.develop();
}

Scene text_scene() {
  return {"text", "pages of text seen at a grazing angle; R8", TexelFormat::kR8, false, paint_text, project_text};
}

Scene magnify_scene() {
  return {"magnify",        "the same text from so close that a texel is 8 pixels at 512 x 512; R8",
          TexelFormat::kR8, false,
          paint_text,       project_magnify};
}

}  // namespace feline
