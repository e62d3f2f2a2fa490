# SPDX-License-Identifier: Apache-2.0
# The RTL as C++ libraries: feline_fast for speed, feline_trace with waveforms, feline_covered with counters.

file(GLOB RTL_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.sv)
set(GENERATED_DIR ${CMAKE_SOURCE_DIR}/tables/generated)
if(FELINE_UNIT)
  set(GENERATED_DIR ${FELINE_UNIT}/generated)
endif()
file(GLOB RTL_GENERATED CONFIGURE_DEPENDS ${GENERATED_DIR}/feline_rom_*.sv)
# The package comes first: everything refers to it.
set(RTL_FILES ${GENERATED_DIR}/feline_pkg.sv ${RTL_GENERATED} ${RTL_SOURCES})

# feline_verilated(library source optimization [TRACE_FST] [COVERAGE] [WARNINGS option] [PREFIX class] FILES files...)
function(feline_verilated library source optimization)
  cmake_parse_arguments(PARSE_ARGV 3 UNIT "TRACE_FST;COVERAGE" "WARNINGS;PREFIX" "FILES")
  if(NOT UNIT_PREFIX)
    set(UNIT_PREFIX V${library})
  endif()
  if(NOT UNIT_WARNINGS)
    set(UNIT_WARNINGS -Wall)
  endif()
  if(FELINE_SANITIZE)
    set(optimization -O1)  # more takes minutes over what sanitizers add
  endif()
  set(options)
  if(UNIT_TRACE_FST)
    set(options TRACE_FST)
  endif()
  set(covered)
  if(UNIT_COVERAGE)
    set(options COVERAGE)
    # Whole beats and memory lines, which are wider than what is counted by default; not the words of the cache.
    set(covered --coverage-max-width 1024)
  endif()
  add_library(${library} STATIC ${source})
  if(FELINE_SANITIZE AND UNIT_TRACE_FST)
    # "fstapi.c:858:22: runtime error: store to misaligned address": in Verilator's copy of GTKWave's writer.
    target_compile_options(${library} PRIVATE -fno-sanitize=alignment)
  endif()
  target_include_directories(${library} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${library} PUBLIC feline_tables)
  verilate(${library} ${options} TOP_MODULE feline_bench PREFIX ${UNIT_PREFIX} SOURCES ${UNIT_FILES}
    ${CMAKE_SOURCE_DIR}/testbench/cosim/feline_bench.sv
    VERILATOR_ARGS ${UNIT_WARNINGS} ${covered} -O3 --x-assign unique --x-initial unique --no-timing
    OPT_FAST ${optimization} OPT_SLOW -O0 OPT_GLOBAL -O1)
endfunction()

if(FELINE_MUTANTS)
  return()
endif()
if(FELINE_UNIT)
  # "Bits of signal are not used: 'sampler_i'[...]" and the like: what is left out has inputs that nobody reads.
  feline_verilated(feline_fast testbench/cosim/fast_unit.cpp -O1 WARNINGS -Wno-UNUSED FILES ${RTL_FILES})
  if(FELINE_ACTIVITY)
    feline_verilated(feline_trace testbench/cosim/trace_unit.cpp -O0 TRACE_FST WARNINGS -Wno-UNUSED FILES ${RTL_FILES})
  endif()
  return()
endif()
if(FELINE_COVERAGE STREQUAL RTL)
  feline_verilated(feline_covered testbench/coverage/covered_unit.cpp -O1 COVERAGE
    FILES ${CMAKE_SOURCE_DIR}/testbench/coverage/coverage.vlt ${RTL_FILES})
  return()
endif()
feline_verilated(feline_fast testbench/cosim/fast_unit.cpp -O3 FILES ${RTL_FILES})
feline_verilated(feline_trace testbench/cosim/trace_unit.cpp -O0 TRACE_FST FILES ${RTL_FILES})

# The leaves that feline prove enumerates, each a class of its own; stages among them with wires for registers. Their
# wrappers are lint-clean (tests/lint.sh) in the default configuration; in others they may leave pins unread.
file(GLOB LEAF_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/testbench/prove/rtl_leaves/feline_leaf_*.sv)
set(LEAF_FILES ${RTL_FILES} ${CMAKE_SOURCE_DIR}/testbench/prove/rtl_leaves/feline_stream_register.sv)
list(REMOVE_ITEM LEAF_FILES ${CMAKE_SOURCE_DIR}/rtl/feline_stream_register.sv)
add_library(feline_leaves STATIC testbench/prove/rtl_leaf.cpp)
target_include_directories(feline_leaves PRIVATE ${CMAKE_SOURCE_DIR})
foreach(source IN LISTS LEAF_SOURCES)
  get_filename_component(name ${source} NAME_WE)
  verilate(feline_leaves TOP_MODULE ${name} PREFIX V${name} SOURCES ${LEAF_FILES} ${source}
    VERILATOR_ARGS -Wno-lint -O3 --x-assign unique --x-initial unique --no-timing)
endforeach()
# One file for the compiler instead of seven small ones of each leaf.
get_target_property(leaf_sources feline_leaves SOURCES)
foreach(source IN LISTS LEAF_SOURCES)
  get_filename_component(name ${source} NAME_WE)
  set(parts ${leaf_sources})
  list(FILTER parts INCLUDE REGEX "/V${name}[^/]*[.]cpp$")
  set_source_files_properties(${parts} PROPERTIES HEADER_FILE_ONLY ON)
  list(TRANSFORM parts REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE includes)
  list(JOIN includes "\n" includes)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/leaves/${name}.cpp CONTENT "${includes}\n" @ONLY)
  target_sources(feline_leaves PRIVATE ${CMAKE_BINARY_DIR}/leaves/${name}.cpp)
  set_source_files_properties(${CMAKE_BINARY_DIR}/leaves/${name}.cpp PROPERTIES COMPILE_OPTIONS -O2
    OBJECT_DEPENDS "${parts}")
endforeach()
