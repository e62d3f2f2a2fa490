# SPDX-License-Identifier: Apache-2.0
# model_coverage: the tests of the model's stages, in which clang++ counts what is in model/ (tests/coverage.list). Built
# and run by tests/coverage.sh.
file(GLOB sources CONFIGURE_DEPENDS tests/model/*_test.cpp tests/support/*.cpp)
add_executable(model_coverage ${sources} testbench/prove/exact_tables.cpp)
target_link_libraries(model_coverage PRIVATE feline_model feline_reference mpfr gmpxx gmp GTest::gtest GTest::gtest_main)
target_compile_options(model_coverage PRIVATE -O1)
target_link_options(model_coverage PRIVATE -fprofile-instr-generate)
foreach(target feline_model model_coverage)
  target_compile_options(${target} PRIVATE -fprofile-instr-generate -fcoverage-mapping
                                           -fprofile-list=${CMAKE_SOURCE_DIR}/tests/coverage.list)
endforeach()
