// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/journal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/testbench/temp_dir.h"

namespace feline::prove {
namespace {

using Done = std::map<std::pair<std::string, std::uint64_t>, std::string>;

Done read(const std::filesystem::path& file, const std::string& key) {
  Done done;
  const Journal journal(file, key, [&](const Journal::Entry& entry) {
    EXPECT_EQ(entry.sources, "gates");
    done[{entry.leaf, entry.chunk}] = entry.result.digest;
  });
  return done;
}

std::string write_three(const std::filesystem::path& file) {
  Journal journal(file, "key", [](const Journal::Entry&) {});
  for (std::uint64_t chunk = 0; chunk < 3; ++chunk) {
    journal.append({"a.leaf", "gates", chunk, {"digest" + std::to_string(chunk), {}, {}, {{0.5, 11}}}});
  }
  return read_bytes(file);
}

TEST(prove_journal, holds_what_was_done) {
  const TempDir dir;
  write_three(dir / "j");
  const Done done = read(dir / "j", "key");
  EXPECT_EQ(done.size(), 3U);
  EXPECT_EQ(done.at({"a.leaf", 2}), "digest2");
}

TEST(prove_journal, of_another_program_is_begun_anew) {
  const TempDir dir;
  write_three(dir / "j");
  EXPECT_TRUE(read(dir / "j", "other").empty());
  EXPECT_TRUE(read(dir / "j", "key").empty());
}

// Killed at any byte: what was whole is there, and goes on as if nothing had been.
TEST(prove_journal, cut_short_anywhere_loses_the_last_line_alone) {
  const TempDir dir;
  const std::string bytes = write_three(dir / "j");
  std::size_t most = 0;
  for (std::size_t length = 0; length <= bytes.size(); ++length) {
    write_bytes(dir / "j", bytes.substr(0, length));
    const std::size_t lines =
        static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    ASSERT_EQ(read(dir / "j", "key").size(), lines == 0 ? 0 : lines - 1) << length;
    {
      Journal journal(dir / "j", "key", [](const Journal::Entry&) {});
      journal.append({"b.leaf", "gates", 9, {"more", {}, {}, {}}});
    }
    const Done done = read(dir / "j", "key");
    ASSERT_EQ(done.size(), lines == 0 ? 1 : lines) << length;
    ASSERT_EQ(done.at({"b.leaf", 9}), "more") << length;
    most = std::max(most, done.size());
  }
  EXPECT_EQ(most, 4U);
}

// What is no entry ends what is read, whatever it is.
TEST(prove_journal, other_lines_are_as_good_as_none) {
  const TempDir dir;
  for (const std::string line : {"5", "{}", "{\"leaf\":5}", "[1]", "null",
                                 R"({"leaf":"a","sources":"gates","chunk":-1,"digest":"d","worst":[]})",
                                 R"({"leaf":"a","sources":"gates","chunk":1e300,"digest":"d","worst":[]})",
                                 R"({"leaf":"a","sources":"gates","chunk":1,"digest":"d","worst":[[0.5,1.5]]})",
                                 R"({"leaf":"a","sources":"gates", "chunk":1,"digest":"d","worst":[]})"}) {
    const std::string bytes = write_three(dir / "j");
    write_bytes(dir / "j", fmt::format("{}\n{}", line, bytes));
    EXPECT_TRUE(read(dir / "j", "key").empty()) << line;
    write_three(dir / "j");
    write_bytes(dir / "j", read_bytes(dir / "j") + line + "\n");
    EXPECT_EQ(read(dir / "j", "key").size(), 3U) << line;
    std::filesystem::remove(dir / "j");
  }
}

TEST(prove_journal, says_where_it_cannot_be_written) {
  EXPECT_NE(input_error([] { read("/nonexistent/j", "key"); }).find("/nonexistent/j"), std::string::npos);
}

}  // namespace
}  // namespace feline::prove
