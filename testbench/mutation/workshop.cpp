// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/workshop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <stdexcept>
#include <system_error>

#include "testbench/area/yosys.h"
#include "testbench/error.h"
#include "testbench/mutation/elaboration.h"
#include "testbench/mutation/sat.h"
#include "testbench/tool.h"

namespace feline::mutation {
namespace {

// Files of a room, without its rooms. A name begins so; survivors.json and certificates decide nothing here.
struct Part {
  std::string_view room;
  std::string_view begin{};
};
constexpr std::array kTrials{Part{"", "CMakeLists.txt"},
                             Part{"rtl"},
                             Part{"model"},
                             Part{"model/reference"},
                             Part{"tables"},
                             Part{"tables/generated"},
                             Part{"testbench"},
                             Part{"testbench/cosim"},
                             Part{"testbench/mutation", "build.sh"},
                             Part{"testbench/mutation", "feline_mutation_"},
                             Part{"testbench/mutation", "model_"},
                             Part{"testbench/mutation", "mutated_"},
                             Part{"testbench/mutation", "mutation.cmake"},
                             Part{"testbench/mutation", "trial"},
                             Part{"testbench/prove"},
                             Part{"testbench/stability"},
                             Part{"tests/model"},
                             Part{"tests/support"},
                             Part{"tests/tables", "rounding_test"}};
constexpr std::array kProofs{Part{"rtl"},
                             Part{"model"},
                             Part{"tables"},
                             Part{"tables/generated"},
                             Part{"testbench"},
                             Part{"testbench/mutation"},
                             Part{"testbench/mutation/rules"},
                             Part{"testbench/prove"},
                             Part{"testbench/prove/rtl_leaves"}};

std::string hash_of(const std::filesystem::path& source, std::span<const Part> parts) {
  std::set<std::filesystem::path> files;
  for (const Part& part : parts) {
    for (const auto& entry : std::filesystem::directory_iterator(source / part.room)) {
      const std::filesystem::path& file = entry.path();
      const bool is_wanted = entry.is_regular_file() && file.filename().string().starts_with(part.begin);
      if (is_wanted && file.extension() != ".json") files.insert(file);
    }
  }
  std::string all;
  for (const std::filesystem::path& file : files) all += content_hash(file);
  return all;
}

Finished finish(const std::vector<std::string>& command, const std::string& input) {
  try {
    return run_process(command, input);
  } catch (const std::system_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", command.front(), error.what()));
  }
}

std::string output_of(const std::vector<std::string>& command, const Finished& finished) {
  if (finished.code != 0) {
    throw std::runtime_error(
        fmt::format("{}: exit code {}\n{}{}", command.front(), finished.code, finished.output, finished.errors));
  }
  return finished.output;
}

const std::filesystem::path& ready(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  return directory;
}

}  // namespace

void check_source(const std::filesystem::path& source) {
  if (!std::filesystem::exists(source / "rtl" / "feline_unit.sv") ||
      !std::filesystem::exists(source / "testbench" / "mutation" / "build.sh")) {
    bad_input(source.string(), "--source", "no rtl/feline_unit.sv and testbench/mutation/build.sh in it",
              "this project's sources");
  }
}

Workshop::Workshop(const std::filesystem::path& of_source, const std::filesystem::path& of_directory)
    : source(of_source),
      directory(of_directory),
      lock(ready(directory) / "lock"),
      cache(Cache::of_parts(directory / "cache")),
      trials(run_tool({"verilator", "--version"}, "verilator", kMutantsNeedIt).output + hash_of(source, kTrials)),
      proofs(yosys_version(kMutantsNeedIt) + solver_version() + hash_of(source, kProofs)) {}

std::string run_program(const std::vector<std::string>& command, const std::string& input) {
  return output_of(command, finish(command, input));
}

std::string run_trials(const std::vector<std::string>& command, const std::string& input) {
  const Finished finished = finish(command, input);
  if (finished.code == 1) throw WitnessMismatch(finished.errors.substr(0, finished.errors.find_last_not_of('\n') + 1));
  return output_of(command, finished);
}

}  // namespace feline::mutation
