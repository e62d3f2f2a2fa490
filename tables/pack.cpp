// SPDX-License-Identifier: Apache-2.0
#include "tables/pack.h"

#include <fmt/format.h>

namespace feline {

std::string element_name(std::string_view field, int element, int count) {
  if (count == 4 && (field == "colour" || field == "border" || field.starts_with("fine_0") ||
                     field.starts_with("fine_1") || field.starts_with("coarse_0") || field.starts_with("coarse_1"))) {
    return std::string(field) + "." + "rgba"[element];
  }
  return std::string(field) + "[" + std::to_string(element) + "]";
}

std::string hex_text(const FieldValue& value) {
  const std::uint64_t mask = (std::uint64_t{1} << value.format.width()) - 1;
  return fmt::format("0x{:0{}x}", static_cast<std::uint64_t>(value.raw) & mask, (value.format.width() + 3) / 4);
}

}  // namespace feline
