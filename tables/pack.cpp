// SPDX-License-Identifier: Apache-2.0
#include "tables/pack.h"

namespace feline {

std::string element_name(std::string_view field, int element, int count) {
  if (count == 4 && (field == "colour" || field == "border" || field.starts_with("fine_0") ||
                     field.starts_with("fine_1") || field.starts_with("coarse_0") || field.starts_with("coarse_1"))) {
    return std::string(field) + "." + "rgba"[element];
  }
  return std::string(field) + "[" + std::to_string(element) + "]";
}

}  // namespace feline
