// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace feline::coverage {

// What is counted: blocks of statements, branches and bits of the RTL, lines and branches of the model, functional
// bins.
enum class Kind : std::uint8_t { kRtlLine, kRtlBranch, kRtlToggle, kModelLine, kModelBranch, kBin };
inline constexpr std::array<std::string_view, 6> kKindNames{"rtl_line",   "rtl_branch",   "rtl_toggle",
                                                            "model_line", "model_branch", "bin"};
inline constexpr std::size_t kKindCount = kKindNames.size();
inline std::string_view kind_name(Kind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

struct Point {
  Kind kind = Kind::kRtlLine;
  // Its own within its kind. It does not change when lines move: exclusions and the ratchet call it so.
  std::string name;
  std::string file;  // from the source's root; of a bin the grid's name
  int line = 0;      // 0 for a bin
  std::uint64_t count = 0;
  std::string excluded = {};  // the reason; empty where it counts
};

// The lines of source files, read once each.
class SourceText {
 public:
  explicit SourceText(std::filesystem::path root) : root_(std::move(root)) {}
  const std::filesystem::path& root() const { return root_; }
  // From a column on, without blanks before and after. Throws InputError where there is no such file or line.
  std::string line(const std::string& file, int number, int column = 1);

 private:
  std::filesystem::path root_;
  std::map<std::string, std::vector<std::string>> files_;
};

// Names apart, points of one name get "#2", "#3" and so on, in their order.
void number_names(std::vector<Point>& points);

}  // namespace feline::coverage
