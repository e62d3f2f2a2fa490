// SPDX-License-Identifier: Apache-2.0
#include "testbench/figures/gallery.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "testbench/measure/errors.h"
#include "testbench/progress.h"

namespace feline {

Exhibition::Exhibition(std::string_view name, int size) : detail_{0, 0, size} {
  const Scene& scene = find_scene(name);
  constexpr std::array kPyramids{reference::Pyramid::kBox};
  surface_ = std::make_unique<Surface>(make_surface(scene.texture(), {}, MipEdge::kRepeat, kPyramids));
  view_ = make_view(scene, *surface_, size, size);
}

const Truth& Exhibition::truth() const {
  if (!truth_) {
    Progress progress(fmt::format("truth of {}", view_.name), view_.pixels.size());
    truth_ = compute_truth(view_, kTruthStrata, 1, &progress);
  }
  return *truth_;
}

std::string Exhibition::picture(const FloatPicture& picture, const std::string& text) const {
  return page::picture(detail_png(picture, detail_, surface_->texture.srgb, channels()), detail_.size, detail_.size,
                       text);
}

page::Panel Exhibition::truth_panel(const std::string& label) const {
  return {picture(truth().gaussian, label), label, fmt::format("standard error {:.4f}", truth().gaussian_error)};
}

page::Panel Exhibition::panel(const std::string& label, const Rendering& rendering) const {
  const double pixels = static_cast<double>(rendering.picture.pixels.size());
  return {picture(rendering.picture, label), label,
          fmt::format("{:.2f} cycles a pixel, error {:.4f}", rendering.cost.cycles / pixels, error(rendering))};
}

page::Panel Exhibition::probes_panel(const std::string& label, const Rendering& rendering) const {
  const std::vector<std::byte> png = probes_png(rendering.probes, view_.gbuffer.width, detail_);
  const double pixels = static_cast<double>(rendering.probes.size());
  return {page::picture(png, detail_.size, detail_.size, label), label,
          fmt::format("{:.2f} probes a pixel", rendering.cost.probes / pixels)};
}

double Exhibition::error(const Rendering& rendering) const {
  return compare(rendering.picture, truth().gaussian, channels()).rmse();
}

nlohmann::ordered_json Exhibition::costs(const std::string& contestant, const Rendering& rendering) const {
  const double pixels = static_cast<double>(rendering.picture.pixels.size());
  return {{"scene", view_.name},
          {"filter", contestant},
          {"probes", rendering.cost.probes / pixels},
          {"texels", rendering.cost.texels / pixels},
          {"cycles", rendering.cost.cycles / pixels}};
}

nlohmann::ordered_json Exhibition::facts(const std::string& contestant, const Rendering& rendering) const {
  nlohmann::ordered_json facts = costs(contestant, rendering);
  facts["error"] = error(rendering);
  return facts;
}

Rendering render_by(std::string_view contestant, const View& view) {
  const Contestant* const found = find_contestant(contestant);
  if (found == nullptr) throw std::invalid_argument("no contestant " + std::string(contestant));
  return found->render(view, nullptr);
}

}  // namespace feline
