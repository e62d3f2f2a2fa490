# SPDX-License-Identifier: Apache-2.0
# The units of mutation: FELINE_MUTANTS is a directory of feline mutate with a directory a stage, in it the stage with a
# site at every port, feline_STAGE.v, and its ROMs, of which any bit can be wrong.
file(GLOB MUTATED_STAGES CONFIGURE_DEPENDS ${FELINE_MUTANTS}/*/feline_*.v)
add_library(feline_trial OBJECT testbench/mutation/mutated_main.cpp testbench/mutation/trial.cpp
            testbench/cosim/close_batches.cpp testbench/cosim/conditions.cpp testbench/cosim/cosimulation.cpp
            testbench/cosim/float_patterns.cpp testbench/cosim/memory_model.cpp testbench/cosim/random_batches.cpp
            testbench/cosim/scoreboard.cpp)
target_compile_options(feline_trial PRIVATE ${FELINE_WARNINGS})
target_link_libraries(feline_trial PUBLIC feline_scenes)
foreach(source IN LISTS MUTATED_STAGES)
  get_filename_component(module ${source} NAME_WE)
  get_filename_component(directory ${source} DIRECTORY)
  set(files ${RTL_FILES} ${CMAKE_SOURCE_DIR}/testbench/mutation/feline_mutation_site.sv
            ${CMAKE_SOURCE_DIR}/testbench/mutation/feline_mutation_source.sv ${source})
  list(REMOVE_ITEM files ${CMAKE_SOURCE_DIR}/rtl/${module}.sv)
  file(GLOB roms ${directory}/feline_rom_*.sv)
  foreach(rom IN LISTS roms)
    get_filename_component(name ${rom} NAME)
    list(TRANSFORM files REPLACE ".*/${name}$" ${rom})
  endforeach()
  string(REPLACE feline_ feline_mutated_ target ${module})
  feline_verilated(${target}_unit testbench/mutation/mutated_unit.cpp -O1 PREFIX Vfeline_mutated WARNINGS -Wno-lint FILES ${files})
  add_executable(${target} $<TARGET_OBJECTS:feline_trial>)
  target_link_libraries(${target} PRIVATE feline_scenes ${target}_unit)
endforeach()

# The model with its sites (testbench/mutation/model_mutants.cpp), its leaves and its tests.
file(GLOB MUTATED_MODEL CONFIGURE_DEPENDS ${FELINE_MUTANTS}/model/sources/model/*.cpp)
if(MUTATED_MODEL)
  file(GLOB leaves testbench/prove/domains_*.cpp testbench/prove/exact_*.cpp testbench/prove/model_*.cpp)
  file(GLOB tests tests/model/*_test.cpp tests/support/*.cpp)
  list(APPEND tests tests/tables/rounding_test.cpp)
  add_executable(feline_mutated_model testbench/mutation/model_main.cpp testbench/prove/leaf.cpp testbench/prove/errors.cpp
                 ${leaves} ${tests} ${MUTATED_MODEL})
  target_include_directories(feline_mutated_model BEFORE PRIVATE ${FELINE_MUTANTS}/model/sources)
  # What is put into the sources is not written as they are.
  target_compile_options(feline_mutated_model PRIVATE -O1 -w -Wno-narrowing)
  # An index past an array's end is found as what it is, whatever lies there.
  target_compile_definitions(feline_mutated_model PRIVATE _GLIBCXX_ASSERTIONS)
  target_link_libraries(feline_mutated_model PRIVATE feline_tables GTest::gtest mpfr gmpxx gmp)
endif()
