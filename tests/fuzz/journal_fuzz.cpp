// SPDX-License-Identifier: Apache-2.0
// journal.jsonl of feline prove, damaged anywhere after its first line: what is kept is what Journal wrote itself.
#include "testbench/prove/journal.h"
#include "tests/fuzz/fuzz.h"

namespace feline::prove {
namespace {

std::vector<Journal::Entry> entries_of(const std::filesystem::path& path) {
  std::vector<Journal::Entry> entries;
  const Journal journal(path, "program", [&](const Journal::Entry& entry) { entries.push_back(entry); });
  return entries;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace
}  // namespace feline::prove

void feline::fuzz::run(Input input) {
  const std::string bytes = "{\"program\":\"program\"}\n" + std::string(input.rest());
  const auto path = file_with("journal.jsonl", bytes);
  const std::vector<prove::Journal::Entry> entries = prove::entries_of(path);
  const std::string kept = prove::bytes_of(path);
  require(bytes.starts_with(kept), "Journal: cuts off the end alone");
  const auto fresh = file_with("fresh.jsonl", "");
  {
    prove::Journal journal(fresh, "program", [](const prove::Journal::Entry&) {});
    for (const prove::Journal::Entry& entry : entries) journal.append(entry);
  }
  require(prove::bytes_of(fresh) == kept, "Journal: an entry is what append writes");
}
