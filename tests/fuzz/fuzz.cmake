# SPDX-License-Identifier: Apache-2.0
# One program a parser: PARSER_fuzz.cpp.
file(GLOB FUZZ_SOURCES CONFIGURE_DEPENDS tests/fuzz/*_fuzz.cpp)
foreach(source IN LISTS FUZZ_SOURCES)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source} tests/fuzz/entry.cpp)
  target_compile_options(${name} PRIVATE ${FELINE_WARNINGS})
  target_link_libraries(${name} PRIVATE feline_program)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
endforeach()
