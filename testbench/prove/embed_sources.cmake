# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, C++ with the text of each of FILES, paths from ROOT: what the program that has it was built from.
set(all "")
foreach(name IN LISTS FILES)
  file(READ ${ROOT}/${name} text)
  string(APPEND all "  sources[\"${name}\"] = R\"feline_text(${text})feline_text\";\n")
endforeach()
file(WRITE ${OUTPUT} "// Written by embed_sources.cmake.\n#include \"testbench/prove/sources.h\"\n
const feline::prove::Sources& feline::prove::built_in_sources() {
  static const Sources all = [] {\n  Sources sources;\n${all}  return sources;\n  }();\n  return all;\n}\n")
