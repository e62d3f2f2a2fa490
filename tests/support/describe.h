// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

#include "model/lookup.h"
#include "tables/pack.h"

namespace feline {

// `plan probes=5 weight_row=1c ...`: one line, raw values in hex, every field.
template <typename Beat>
std::string one_line(const Beat& beat) {
  std::string line(Beat::kName.view());
  for (const auto& [name, format, raw] : field_values(beat))
    line += fmt::format(" {}={}{:x}", name, raw < 0 ? "-" : "", raw < 0 ? -raw : raw);
  return line;
}

inline std::string one_line(const Lookup& lookup) {
  return fmt::format("lookup s={:a} t={:a} dsdx={:a} dtdx={:a} dsdy={:a} dtdy={:a}", lookup.s, lookup.t, lookup.dsdx,
                     lookup.dtdx, lookup.dsdy, lookup.dtdy);
}

// The grammar of a failure: inputs | got | want, one line.
template <typename Beat, typename... Inputs>
std::string mismatch(const Beat& got, const Beat& want, const Inputs&... inputs) {
  std::string line;
  ((line += one_line(inputs) + " "), ...);
  return line + "| got " + one_line(got) + " | want " + one_line(want);
}

}  // namespace feline
