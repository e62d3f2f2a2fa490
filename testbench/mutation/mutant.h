// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace feline::mutation {

// A port of a cell of a stage's netlist, before any optimization that forgets what was written: an operator of the RTL.
struct Site {
  std::uint32_t number = 0;  // from 1
  std::string cell;          // Yosys' name and type
  std::string type;
  std::string port;
  std::string source;  // "/.../rtl/feline_walk.sv:42.12-42.30"; attribute `place`, or else `src`
  struct Bit {
    std::uint32_t place = 0;
    bool constant = false;
  };
  std::uint32_t width = 0;
  std::vector<Bit> bits;  // those that can matter: an output's that nothing reads are not among them
};

// A ROM of a stage.
struct Rom {
  std::string name;  // "ellipse"
  std::uint32_t words = 0;
  std::uint32_t width = 0;
};

// What is wrong at a site, as in Yosys' `mutate`: a bit inverted, stuck, or inverted when another bit of the same port
// is one or zero. Or a bit of a ROM's word.
enum class Kind : std::uint8_t { kInvert, kZero, kOne, kInvertWhenZero, kInvertWhenOne, kRomBit };
inline constexpr const char* kKindNames[] = {"invert", "zero", "one", "invert when zero", "invert when one", "rom bit"};

struct Mutant {
  std::uint32_t site = 0;  // of a ROM's bit: the ROM's number in the stage
  Kind kind = Kind::kInvert;
  std::uint32_t bit = 0;
  std::uint32_t control = 0;  // the other bit; the word of a ROM
  bool operator==(const Mutant&) const = default;
};

// What feline_mutation_site.sv takes: site, kind, bit, control from the least bit in 16, 4, 12 and 16 bits. 0: none.
std::uint64_t code(const Mutant& mutant);

// Every mutant of a site.
std::vector<Mutant> site_mutants(const Site& site);

// The numbers of the sites of mutants, each once, rising.
std::vector<std::uint32_t> site_numbers(const std::vector<Mutant>& mutants);

// `count` different mutants, or as many as there are: a site, then a bit and a kind, each as likely as any other. A
// function of the seed.
std::vector<Mutant> draw_mutants(const std::vector<Site>& sites, std::size_t count, std::uint64_t seed);

// Every bit of every word.
std::vector<Mutant> rom_mutants(const std::vector<Rom>& roms);

// A stage's RTL with a site at every port, as Yosys' JSON.
// NOLINTNEXTLINE(bugprone-exception-escape): "an exception may be thrown" by the JSON's move, which throws nothing.
struct InstrumentedStage {
  nlohmann::ordered_json netlist;
  std::vector<Site> sites;
  std::vector<Site> ports;        // the stage's own, numbered after `sites`; a mutant can be at those of `only` alone
  std::vector<std::string> roms;  // names of the ROMs it is made of
};

// From the netlist of module `top`; what it keeps as instances of other modules are cells, ROMs among them. With
// `only`, sites of other numbers stay as they are; with `port`, which of the mutants is a port `mutant` of the module,
// else feline_mutation_source says it. Throws std::runtime_error for a netlist without that module.
InstrumentedStage instrument(const nlohmann::ordered_json& netlist, const std::string& top,
                             const std::vector<std::uint32_t>* only, bool port);

}  // namespace feline::mutation
