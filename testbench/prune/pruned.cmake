# SPDX-License-Identifier: Apache-2.0
# The check of a pruned unit: its RTL, its model, and the full unit's model to compare the picture with. FELINE_UNIT is
# a directory with unit.h, which defines kUnit, and generated/, the package and ROMs of that configuration.
file(GLOB PRUNED_SOURCES CONFIGURE_DEPENDS testbench/cosim/*.cpp)
list(REMOVE_ITEM PRUNED_SOURCES ${CMAKE_SOURCE_DIR}/testbench/cosim/fast_unit.cpp
     ${CMAKE_SOURCE_DIR}/testbench/cosim/trace_unit.cpp)
add_executable(feline_pruned testbench/prune/pruned_main.cpp testbench/prune/check.cpp
               testbench/prune/observe.cpp testbench/prune/profile.cpp testbench/prune/prune.cpp
               testbench/program/command_line.cpp testbench/program/frames.cpp testbench/program/frames_profile.cpp
               testbench/program/subject.cpp
               ${PRUNED_SOURCES})
target_compile_options(feline_pruned PRIVATE ${FELINE_WARNINGS})
target_link_libraries(feline_pruned PRIVATE feline_scenes feline_fast CLI11::CLI11)
foreach(target feline_pruned feline_model feline_fast)
  target_compile_definitions(${target} PRIVATE FELINE_UNIT_HEADER="${FELINE_UNIT}/unit.h")
endforeach()
