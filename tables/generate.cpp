// SPDX-License-Identifier: Apache-2.0
// Writes every generated file of the default configuration into a directory: what tables/generated/ holds.
#include <cstdio>
#include <fstream>

#include "tables/emit.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: feline_generate DIRECTORY\n", stderr);
    return 2;
  }
  for (const auto& file : feline::generate(feline::kDefaultConfig, feline::measured_roms(feline::kDefaultConfig))) {
    const std::string path = std::string(argv[1]) + "/" + file.name;
    std::ofstream out(path, std::ios::binary);
    out << file.text;
    out.close();
    if (!out) {
      std::fprintf(stderr, "feline_generate: %s: cannot write\n", path.c_str());
      return 2;
    }
  }
}
