# SPDX-License-Identifier: Apache-2.0
# feline_coverage: what the suite reaches of RTL and model. Built by tests/coverage.sh.
file(GLOB COVERAGE_SOURCES CONFIGURE_DEPENDS testbench/coverage/*.cpp)
list(REMOVE_ITEM COVERAGE_SOURCES ${CMAKE_SOURCE_DIR}/testbench/coverage/covered_unit.cpp)
add_executable(feline_coverage ${COVERAGE_SOURCES} testbench/cosim/conditions.cpp
               testbench/cosim/cosimulation.cpp testbench/cosim/float_patterns.cpp testbench/cosim/job.cpp
               testbench/cosim/memory_model.cpp testbench/cosim/mismatch.cpp testbench/cosim/random_batches.cpp
               testbench/cosim/scoreboard.cpp testbench/page/heat_map.cpp testbench/page/html.cpp)
target_compile_options(feline_coverage PRIVATE ${FELINE_WARNINGS})
target_link_libraries(feline_coverage PRIVATE feline_scenes feline_covered CLI11::CLI11)
set_source_files_properties(testbench/page/heat_map.cpp testbench/page/html.cpp testbench/cosim/mismatch.cpp PROPERTIES COMPILE_OPTIONS -O0)
