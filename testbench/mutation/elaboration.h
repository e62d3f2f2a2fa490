// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace feline::mutation {

// For the message when a tool is not there.
inline constexpr std::string_view kMutantsNeedIt = "mutants need it";

// A module of the project, flattened, ROMs kept as instances.
// NOLINTNEXTLINE(bugprone-exception-escape): "an exception may be thrown" by the JSON's move, which throws nothing.
struct Elaboration {
  nlohmann::ordered_json netlist;
  // By its path, as "u_count_probes.u_fit_radius": the module of each instance, named after its parameters, too; "" is
  // the module itself.
  std::map<std::string, std::string> instances;
};

// Runs Yosys, which is told to read `sources` by its commands; writes files to `directory`. Throws InputError when
// Yosys is not there, std::runtime_error when it fails.
Elaboration elaborate(const std::string& top, const std::string& sources, const std::filesystem::path& directory);
// A module that an instance of `top` is of, alone, after elaborate() has written to the directory.
Elaboration elaborate_module(const std::string& module, const std::string& top, const std::filesystem::path& directory);

// Yosys' command to read files, and one that takes them in place of modules of the same name. With `library` they stay
// instances.
std::string read_command(const std::vector<std::filesystem::path>& files, bool library = false);
// The files NAME*.sv of a directory, in the order of their names.
std::vector<std::filesystem::path> sources_in(const std::filesystem::path& directory, std::string_view begin);

// The path of the instance that a cell of a flattened netlist is in, or that it is: "u_length" of
// "$flatten\u_length.$add$...".
std::string instance_of(std::string_view cell);

// A module without its memories: what they read are inputs cut_N_RD_DATA_i, what they are given outputs cut_N_PORT_o.
// As long as two of them give the same there, their memories hold the same.
void cut_memories(nlohmann::ordered_json& module);

// The netlist's text, which is in directory/TOP.v afterwards.
std::string to_verilog(const nlohmann::ordered_json& netlist, const std::string& top,
                       const std::filesystem::path& directory);

// Gates of a netlist whose modules `sources` reads, as binary AIGER with names; memories become registers.
std::string to_gates(const nlohmann::ordered_json& netlist, const std::string& top, const std::string& sources,
                     const std::filesystem::path& directory);

}  // namespace feline::mutation
