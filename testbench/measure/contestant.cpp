// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/contestant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "testbench/measure/oiio_texture.h"
#include "testbench/measure/render_rows.h"
#include "testbench/measure/unit_contestants.h"

namespace feline {
namespace {

Contestant reference_contestant(const reference::Filter& filter) {
  Contestant contestant{
      filter.name, Contestant::Kind::kReference, std::string(filter.description), std::string(filter.source), {}, {}};
  contestant.pyramid = filter.pyramid;
  contestant.render = [&filter](const View& view, Progress* progress) {
    const reference::Images& images = view.surface->images;
    if (!filter.axis_system) {
      return render_rows(view, progress, [&](std::size_t i, reference::Cost& cost) {
        return filter.run(images, view.pixels[i], cost);
      });
    }
    const auto axes = interpolate_axes(view, *filter.axis_system);
    return render_rows(view, progress, [&](std::size_t i, reference::Cost& cost) {
      reference::Pixel pixel = view.pixels[i];
      pixel.axes = axes[i];
      return filter.run(images, pixel, cost);
    });
  };
  return contestant;
}

std::vector<Contestant> make_contestants() {
  std::vector<Contestant> all;
  for (const reference::Filter& filter : reference::filters()) all.push_back(reference_contestant(filter));
  for (Contestant& contestant : unit_contestants()) all.push_back(std::move(contestant));
  all.push_back(oiio_contestant());
  return all;
}

}  // namespace

std::span<const Contestant> contestants() {
  static const std::vector<Contestant> all = make_contestants();
  return all;
}

const Contestant* find_contestant(std::string_view name) {
  const auto found = std::ranges::find(contestants(), name, &Contestant::name);
  return found == contestants().end() ? nullptr : &*found;
}

std::string contestant_names() {
  std::vector<std::string_view> names;
  for (const Contestant& contestant : contestants()) names.push_back(contestant.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string filter_names() {
  std::vector<std::string_view> names;
  for (const Contestant& contestant : contestants()) {
    if (contestant.kind != Contestant::Kind::kUnit) names.push_back(contestant.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace feline
