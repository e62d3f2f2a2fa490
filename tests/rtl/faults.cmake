# SPDX-License-Identifier: Apache-2.0
# A copy of the RTL in which any one of a list of faults can be switched on at run time: feline_faulty.
# Each fault replaces an expression by (feline_fault() == number ? mutant : original). An original that is not there
# exactly once leaves the RTL as it is: the fault's test then finds no mismatch and fails, so that no fault silently goes
# away when the RTL changes, and yet the rest builds.

# The copy is made when CMake configures.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${RTL_FILES} tests/rtl/fault_list.cmake)
set(FAULTY_DIR ${CMAKE_BINARY_DIR}/faulty)
file(REMOVE_RECURSE ${FAULTY_DIR})
file(MAKE_DIRECTORY ${FAULTY_DIR})
foreach(file IN LISTS RTL_FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  file(WRITE ${FAULTY_DIR}/${name} "${text}")
endforeach()
file(WRITE ${FAULTY_DIR}/feline_fault_pkg.sv
"package feline_fault_pkg;\n  import \"DPI-C\" pure function int feline_fault();\nendpackage\n")
set(FAULT_COUNT 0)
set(FAULT_TABLE "")

function(feline_replace_once file original replacement)
  file(READ ${FAULTY_DIR}/${file}.sv text)
  string(FIND "${text}" "${original}" first)
  string(FIND "${text}" "${original}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(WARNING "tests/rtl/faults.cmake: ${file}.sv must hold exactly once: ${original}")
    return()
  endif()
  string(REPLACE "${original}" "${replacement}" text "${text}")
  file(WRITE ${FAULTY_DIR}/${file}.sv "${text}")
endfunction()

macro(feline_count_fault stage what)
  math(EXPR FAULT_COUNT "${FAULT_COUNT} + 1")
  string(APPEND FAULT_TABLE "    {${FAULT_COUNT}, \"${stage}\", \"${what}\"},\n")
endmacro()

# feline_fault(stage what file context original mutant): `context` holds `original` once and shows where it is.
function(feline_fault stage what file context original mutant)
  feline_count_fault(${stage} ${what})
  string(REPLACE "${original}" "(feline_fault_pkg::feline_fault() == ${FAULT_COUNT} ? (${mutant}) : (${original}))" changed
         "${context}")
  feline_replace_once(${file} "${context}" "${changed}")
  set(FAULT_COUNT ${FAULT_COUNT} PARENT_SCOPE)
  set(FAULT_TABLE "${FAULT_TABLE}" PARENT_SCOPE)
endfunction()

# One bit of one word of a ROM.
function(feline_rom_fault stage rom word bit)
  feline_count_fault(${stage} rom_${rom}_word_${word}_bit_${bit})
  file(READ ${FAULTY_DIR}/feline_rom_${rom}.sv text)
  if(text MATCHES "'d${word}: data_o = ([0-9]+)'h([0-9a-f]+)")
    set(literal "${CMAKE_MATCH_1}'h${CMAKE_MATCH_2}")
    set(mask "(${CMAKE_MATCH_1}'d1 << ${bit})")
    feline_replace_once(feline_rom_${rom} "'d${word}: data_o = ${literal}"
      "'d${word}: data_o = ${literal} ^ (feline_fault_pkg::feline_fault() == ${FAULT_COUNT} ? ${mask} : '0)")
  else()
    message(WARNING "tests/rtl/faults.cmake: feline_rom_${rom}.sv has no word ${word}")
  endif()
  set(FAULT_COUNT ${FAULT_COUNT} PARENT_SCOPE)
  set(FAULT_TABLE "${FAULT_TABLE}" PARENT_SCOPE)
endfunction()

include(tests/rtl/fault_list.cmake)

# What the rules of mutants say of each stage's input, watched; further ports that they look at may follow.
function(feline_watch stage input has_sampler)
  set(changed "1'b0")
  if(has_sampler)
    set(sampler " .sampler_i,")
    set(changed "sampler_i != u_rules.u_sampler.sampler_q")
  endif()
  set(others "")
  foreach(port IN LISTS ARGN)
    string(APPEND others " .${port},")
  endforeach()
  feline_replace_once(feline_${stage} "endmodule" "  logic rules_legal;
  feline_rules_${stage} u_rules (.clk_i, .rst_i,${sampler}${others} .${input}_valid_i, .${input}_ready_o, .${input}_i,
                                 .legal_o(rules_legal));
  feline_rules_watch #(.Stage(\"${stage}\")) u_watch (.clk_i, .rst_i, .changed_i(${changed}), .legal_i(rules_legal));
endmodule")
  # Unlike a fault, rules that nobody watches would break no test.
  file(READ ${FAULTY_DIR}/feline_${stage}.sv text)
  if(NOT text MATCHES "feline_rules_watch")
    message(FATAL_ERROR "tests/rtl/faults.cmake: feline_${stage}.sv is not watched")
  endif()
endfunction()

feline_watch(group request TRUE)
feline_watch(footprint group TRUE)
feline_watch(plan footprint TRUE)
feline_watch(walk plan FALSE)
feline_watch(address walk TRUE)
feline_watch(fetch address TRUE flush_i fetch_valid_o fetch_ready_i memory_request_valid_o memory_request_ready_i
             memory_response_valid_i memory_response_ready_o)
feline_watch(accumulate filter FALSE)
file(GLOB RULES_FILES CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/testbench/mutation/rules/*.sv)

file(WRITE ${FAULTY_DIR}/fault_table.inc "${FAULT_TABLE}")
list(TRANSFORM RTL_FILES REPLACE ".*/" "${FAULTY_DIR}/" OUTPUT_VARIABLE FAULTY_FILES)
# Mutants need not be lint-clean, but a port of rules that is not connected would read as 0.
feline_verilated(feline_faulty tests/rtl/faulty_unit.cpp -O1 TRACE_FST WARNINGS "-Wno-lint;-Wwarn-PINMISSING" FILES ${FAULTY_DIR}/feline_fault_pkg.sv ${FAULTY_FILES}
                ${RULES_FILES} ${CMAKE_SOURCE_DIR}/tests/rtl/feline_rules_watch.sv)
target_include_directories(feline_faulty PUBLIC ${FAULTY_DIR})

# The program with a fault in its RTL. Its own units come before those of the bench's libraries.
add_executable(feline_broken testbench/program/main.cpp tests/rtl/broken_units.cpp)
target_compile_options(feline_broken PRIVATE ${FELINE_WARNINGS})
target_link_libraries(feline_broken PRIVATE feline_program feline_faulty)
