// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace feline {

// Keeps what a bound was set from: model_test --gtest_output=xml:FILE writes it.
inline void measured(const std::string& name, double value) {
  ::testing::Test::RecordProperty(name, fmt::format("{:.4g}", value));
}

}  // namespace feline
