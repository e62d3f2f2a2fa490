# SPDX-License-Identifier: Apache-2.0
# One binary a room. Test suites are named after stages and files, so that ctest names read room.stage.case and
# `ctest -R '\.plan\.'` is one stage's whole story. Suites ending in _long carry the label long.
include(GoogleTest)

function(feline_tests room)
  # A room's folders mirror the source's; what is no test there supports those that are.
  file(GLOB sources CONFIGURE_DEPENDS tests/${room}/*_test.cpp tests/${room}/*/*.cpp)
  add_executable(${room}_test ${sources} ${TESTS_SUPPORT})
  target_compile_options(${room}_test PRIVATE ${FELINE_WARNINGS} -O1)
  target_compile_definitions(${room}_test PRIVATE FELINE_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                                  FELINE_PROGRAM="$<TARGET_FILE:feline>"
                                                  FELINE_BROKEN="$<TARGET_FILE:feline_broken>")
  target_link_libraries(${room}_test PRIVATE ${ARGN} feline_exact GTest::gtest GTest::gtest_main)
  feline_together(${room}_test)
  gtest_discover_tests(${room}_test TEST_PREFIX ${room}. TEST_FILTER "-*_long.*" NO_PRETTY_VALUES
                       DISCOVERY_MODE PRE_TEST)
  gtest_discover_tests(${room}_test TEST_PREFIX ${room}. TEST_FILTER "*_long.*" TEST_SUFFIX .long TEST_LIST ${room}_long
                       NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST PROPERTIES LABELS long)
endfunction()

# Twenty configurations, each once: the optimizer would take a minute and gigabytes over them.
set_source_files_properties(tests/tables/generated_test.cpp PROPERTIES COMPILE_OPTIONS -O0)

include(tests/rtl/faults.cmake)
file(GLOB TESTS_SUPPORT CONFIGURE_DEPENDS tests/support/*.cpp)
feline_tests(tables feline_tables)
feline_tests(model feline_model feline_reference)
feline_tests(testbench feline_program)
add_dependencies(testbench_test feline)
feline_tests(rtl feline_bench feline_faulty)
add_dependencies(rtl_test feline feline_broken)
