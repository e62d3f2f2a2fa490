// SPDX-License-Identifier: Apache-2.0
#include "model/reference/mip_map.h"

#include <algorithm>

namespace feline::reference {

int wrap_index(std::int64_t index, int size, Wrap wrap) {
  if (index >= 0 && index < size) return static_cast<int>(index);
  switch (wrap) {
    case Wrap::kRepeat: {
      const auto rest = static_cast<int>(index % size);
      return rest < 0 ? rest + size : rest;
    }
    case Wrap::kMirroredRepeat: {
      const std::int64_t period = 2 * std::int64_t{size};
      const std::int64_t rest = (index % period + period) % period;
      return static_cast<int>(rest < size ? rest : period - 1 - rest);
    }
    case Wrap::kClampToEdge: return static_cast<int>(std::clamp<std::int64_t>(index, 0, size - 1));
    case Wrap::kClampToBorder: return -1;
  }
  return 0;
}

const Texel& wrapped_texel(const Level& level, const Wrapping& wrapping, std::int64_t x, std::int64_t y) {
  const int column = wrap_index(x, level.width, wrapping.s);
  const int row = wrap_index(y, level.height, wrapping.t);
  return column < 0 || row < 0 ? wrapping.border : level.at(column, row);
}

}  // namespace feline::reference
