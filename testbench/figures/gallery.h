// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "testbench/figures/figure.h"
#include "testbench/measure/contestant.h"
#include "testbench/measure/detail.h"
#include "testbench/page/sheet.h"

namespace feline {

// A built-in scene, what it ought to look like, and what contestants make of it.
class Exhibition {
 public:
  Exhibition(std::string_view scene, int size);

  const View& view() const { return view_; }
  const Truth& truth() const;  // made when first asked for

  // Of the whole picture, or of a detail of it, enlarged to the panel.
  page::Panel truth_panel(const std::string& label) const;
  page::Panel panel(const std::string& label, const Rendering& rendering) const;
  page::Panel probes_panel(const std::string& label, const Rendering& rendering) const;
  void show(const Detail& detail) { detail_ = detail; }

  // Root mean square difference from the truth, channels of 0 to 1.
  double error(const Rendering& rendering) const;
  // Scene, contestant and costs a pixel.
  nlohmann::ordered_json costs(const std::string& contestant, const Rendering& rendering) const;
  // The same with the error.
  nlohmann::ordered_json facts(const std::string& contestant, const Rendering& rendering) const;

 private:
  int channels() const { return bytes_per_texel(surface_->texture.format); }
  std::string picture(const FloatPicture& picture, const std::string& text) const;

  std::unique_ptr<Surface> surface_;
  View view_;
  mutable std::optional<Truth> truth_;
  Detail detail_;
};

// By a contestant's name; std::invalid_argument where there is none.
Rendering render_by(std::string_view contestant, const View& view);

}  // namespace feline
