# SPDX-License-Identifier: Apache-2.0
# The RTL as C++ libraries: feline_fast for speed, feline_trace with waveforms.

file(GLOB RTL_SOURCES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.sv)
set(GENERATED_DIR ${CMAKE_SOURCE_DIR}/tables/generated)
if(FELINE_UNIT)
  set(GENERATED_DIR ${FELINE_UNIT}/generated)
endif()
file(GLOB RTL_GENERATED CONFIGURE_DEPENDS ${GENERATED_DIR}/feline_rom_*.sv)
# The package comes first: everything refers to it.
set(RTL_FILES ${GENERATED_DIR}/feline_pkg.sv ${RTL_GENERATED} ${RTL_SOURCES})

# feline_verilated(library source optimization [TRACE_FST] [WARNINGS option] FILES files...)
function(feline_verilated library source optimization)
  cmake_parse_arguments(PARSE_ARGV 3 UNIT "TRACE_FST" "WARNINGS" "FILES")
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
  add_library(${library} STATIC ${source})
  if(FELINE_SANITIZE AND UNIT_TRACE_FST)
    # "fstapi.c:858:22: runtime error: store to misaligned address": in Verilator's copy of GTKWave's writer.
    target_compile_options(${library} PRIVATE -fno-sanitize=alignment)
  endif()
  target_include_directories(${library} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${library} PUBLIC feline_tables)
  verilate(${library} ${options} TOP_MODULE feline_bench PREFIX V${library} SOURCES ${UNIT_FILES}
    ${CMAKE_SOURCE_DIR}/testbench/cosim/feline_bench.sv
    VERILATOR_ARGS ${UNIT_WARNINGS} -O3 --x-assign unique --x-initial unique --no-timing
    OPT_FAST ${optimization} OPT_SLOW -O0 OPT_GLOBAL -O1)
endfunction()

if(FELINE_UNIT)
  # "Bits of signal are not used: 'sampler_i'[...]" and the like: what is left out has inputs that nobody reads.
  feline_verilated(feline_fast testbench/cosim/fast_unit.cpp -O1 WARNINGS -Wno-UNUSED FILES ${RTL_FILES})
  if(FELINE_ACTIVITY)
    feline_verilated(feline_trace testbench/cosim/trace_unit.cpp -O0 TRACE_FST WARNINGS -Wno-UNUSED FILES ${RTL_FILES})
  endif()
  return()
endif()
feline_verilated(feline_fast testbench/cosim/fast_unit.cpp -O3 FILES ${RTL_FILES})
feline_verilated(feline_trace testbench/cosim/trace_unit.cpp -O0 TRACE_FST FILES ${RTL_FILES})
