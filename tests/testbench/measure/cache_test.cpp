// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/cache.h"

#include <gtest/gtest.h>

#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

TEST(measure_cache, hit_and_miss) {
  const TempDir dir;
  const Cache cache(dir / "a" / "b");
  const std::string key = cache.key({"cell", "bricks"});
  EXPECT_FALSE(cache.read(key));
  const std::string content("bytes \0 of any kind\n", 20);
  cache.write(key, content);
  EXPECT_EQ(cache.read(key), content);
  EXPECT_FALSE(cache.read(cache.key({"cell", "curves"})));
  cache.write(key, "");
  EXPECT_EQ(cache.read(key), "");
  // Another one in the same place knows it, one elsewhere does not.
  EXPECT_EQ(Cache(dir / "a" / "b").read(key), "");
  EXPECT_FALSE(Cache(dir / "c").read(key));
}

TEST(measure_cache, keys_are_of_all_parts_in_their_order) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const std::vector<std::string> keys{cache.key({"ab", "c"}), cache.key({"a", "bc"}),     cache.key({"abc"}),
                                      cache.key({"c", "ab"}), cache.key({"ab", "c", ""}), cache.key({}),
                                      cache.key({"2:ab1:c"}), cache.key({"ab", "1:c"})};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(keys[i], keys[j]) << i << " " << j;
  }
  EXPECT_EQ(cache.key({"ab", "c"}), keys[0]);
}

TEST(measure_cache, a_damaged_entry_is_none) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const std::string key = cache.key({"part"});
  cache.write(key, "what was measured");
  const std::string whole = read_bytes(dir / "cache" / key);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 4);
    write_bytes(dir / "cache" / key, bytes);
    EXPECT_FALSE(cache.read(key)) << i;
    write_bytes(dir / "cache" / key, whole.substr(0, i));
    EXPECT_FALSE(cache.read(key)) << i;
  }
  write_bytes(dir / "cache" / key, whole + "x");
  EXPECT_FALSE(cache.read(key));
  write_bytes(dir / "cache" / key, whole);
  EXPECT_EQ(cache.read(key), "what was measured");
}

TEST(measure_cache, a_directory_that_cannot_be_made) {
  const TempDir dir;
  write_bytes(dir / "file", "");
  for (const std::filesystem::path& path :
       {dir / "file", dir / "file" / "within", std::filesystem::path("/proc/none")}) {
    const std::string message = input_error([&] { const Cache cache(path); });
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("directory"), std::string::npos) << message;
  }
}

TEST(measure_cache, content_of_files) {
  const TempDir dir;
  write_bytes(dir / "a", "abc");
  write_bytes(dir / "b", "abc");
  write_bytes(dir / "c", "abd");
  // FIPS 180-4: SHA-1 of "abc".
  EXPECT_EQ(content_hash(dir / "a"), "A9993E364706816ABA3E25717850C26C9CD0D89D");
  EXPECT_EQ(content_hash(dir / "a"), content_hash(dir / "b"));
  EXPECT_NE(content_hash(dir / "a"), content_hash(dir / "c"));
  EXPECT_NE(input_error([&] { content_hash(dir / "none"); }).find("none"), std::string::npos);
}

TEST(measure_cache, of_parts_is_that_of_any_program) {
  const TempDir dir;
  const Cache of_program(dir / "cache");
  const Cache of_parts = Cache::of_parts(dir / "cache");
  EXPECT_NE(of_parts.key({"a"}), of_program.key({"a"}));
  EXPECT_EQ(of_parts.key({"a"}), Cache::of_parts(dir / "other").key({"a"}));
  EXPECT_NE(of_parts.key({"a"}), of_parts.key({"b"}));
}

}  // namespace
}  // namespace feline
