// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "testbench/error.h"
#include "testbench/json_input.h"

namespace feline::prove {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what) {
  bad_input(path.string(), what, std::strerror(errno), "a file that can be written");
}

Json to_json(const Journal::Entry& entry) {
  Json worst = Json::array();
  for (const Worst& each : entry.result.worst) worst.push_back({each.value, each.input});
  return {{"leaf", entry.leaf},
          {"sources", entry.sources},
          {"chunk", entry.chunk},
          {"digest", entry.result.digest},
          {"worst", worst}};
}

// Nothing for a line that is none of to_json.
std::optional<Journal::Entry> entry_from(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    Journal::Entry entry{json.at("leaf"), json.at("sources"), whole_from_json<std::uint64_t>(json.at("chunk")), {}};
    entry.result.digest = json.at("digest");
    for (const Json& worst : json.at("worst")) {
      entry.result.worst.push_back({worst.at(0), whole_from_json<std::uint64_t>(worst.at(1))});
    }
    if (to_json(entry).dump() == line) return entry;
  } catch (const std::exception&) {
    // Of JSON's, of texts and numbers.
  }
  return std::nullopt;
}

}  // namespace

Journal::Journal(const std::filesystem::path& file, const std::string& program,
                 const std::function<void(const Entry&)>& done)
    : path_(file) {
  file_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail(path_, "open");
  const std::string head = Json{{"program", program}}.dump();
  std::uintmax_t kept = 0;
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line) && !in.eof(); kept += line.size() + 1) {
    if (kept == 0) {
      if (line != head) break;
      continue;
    }
    const auto entry = entry_from(line);
    if (!entry) break;
    done(*entry);
  }
  if (::ftruncate(file_, static_cast<off_t>(kept)) != 0) fail(path_, "write");
  if (kept == 0) write_line(head);
}

Journal::~Journal() { ::close(file_); }

void Journal::append(const Entry& entry) { write_line(to_json(entry).dump()); }

void Journal::write_line(const std::string& line) {
  const std::string text = line + "\n";
  if (::write(file_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) fail(path_, "write");
  if (::fdatasync(file_) != 0) fail(path_, "write");
}

}  // namespace feline::prove
