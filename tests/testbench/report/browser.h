// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/testbench/temp_dir.h"

namespace feline {

// What a page did in a browser.
struct Visit {
  double scroll_width = 0;  // of the page: wider than its frame scrolls sideways
  double frame_width = 0;   // that the page has, without a scroll bar
  struct Box {
    double left = 0;
    double right = 0;
    double height = 0;
    double natural_width = 0;  // of images
    bool folded = false;       // within details that are not open
  };
  std::vector<Box> drawings;  // svg elements
  std::vector<Box> pictures;  // img elements
  std::vector<std::string> console;
  std::vector<std::string> requests;  // to the network, by the page
};

// Opens a page in headless Chromium in a frame of this width, its folds closed or open. Throws std::runtime_error when
// there is no Chromium, or when it does not load the page.
Visit visit(const TempDir& dir, const std::filesystem::path& page, int width, bool unfolded = false);

}  // namespace feline
