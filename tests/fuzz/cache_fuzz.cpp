// SPDX-License-Identifier: Apache-2.0
// An entry of a cache, damaged or whole: what is read is what was written, and its truth the same again as bytes.
#include "testbench/measure/cache.h"
#include "testbench/measure/truth_store.h"
#include "tests/fuzz/fuzz.h"

void feline::fuzz::run(Input input) {
  static const Cache cache(directory() / "cache");
  static const std::string key = cache.key({"entry"});
  const bool is_whole = input.choose(2) == 0;
  const std::string bytes(input.rest());
  if (is_whole) {
    cache.write(key, bytes);
    require(cache.read(key) == bytes, "Cache: reads what it wrote");
  } else {
    const auto path = file_with("cache/" + key, bytes);
    if (const auto content = cache.read(key)) {
      cache.write(key, *content);
      std::ifstream in(path, std::ios::binary);
      require(std::string(std::istreambuf_iterator<char>(in), {}) == bytes, "Cache: damage is as good as none");
    }
  }
  accepts<std::runtime_error>(
      [&] { require(to_bytes(truth_from_bytes(bytes)) == bytes, "truth_from_bytes: the same bytes again"); });
}
