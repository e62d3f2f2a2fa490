# SPDX-License-Identifier: Apache-2.0
# The check of a pruned unit: its RTL, its model, and the full unit's model to compare the picture with. FELINE_UNIT is
# a directory with unit.h, which defines kUnit, and generated/, the package and ROMs of that configuration.
add_executable(feline_pruned testbench/prune/pruned_main.cpp testbench/prune/check.cpp testbench/prune/observe.cpp
               testbench/prune/profile.cpp testbench/prune/prune.cpp testbench/program/command_line.cpp
               testbench/program/frames.cpp testbench/program/frames_profile.cpp testbench/program/subject.cpp
               testbench/cosim/cosimulation.cpp testbench/cosim/job.cpp testbench/cosim/memory_model.cpp
               testbench/cosim/mismatch.cpp testbench/cosim/scoreboard.cpp)
target_compile_options(feline_pruned PRIVATE ${FELINE_WARNINGS})
target_link_libraries(feline_pruned PRIVATE feline_scenes feline_fast CLI11::CLI11)
set_source_files_properties(testbench/prune/pruned_main.cpp testbench/prune/profile.cpp testbench/prune/prune.cpp
                            testbench/program/frames.cpp testbench/program/frames_profile.cpp
                            testbench/program/command_line.cpp testbench/program/subject.cpp testbench/cosim/mismatch.cpp
                            PROPERTIES COMPILE_OPTIONS -O0)
# Only what knows kUnit is compiled anew for every unit.
set_property(SOURCE testbench/prune/check.cpp testbench/cosim/cosimulation.cpp testbench/cosim/job.cpp
             testbench/cosim/mismatch.cpp testbench/cosim/scoreboard.cpp testbench/cosim/fast_unit.cpp model/sampler.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS FELINE_UNIT_HEADER="${FELINE_UNIT}/unit.h")

# What counts the unit's toggles, if asked for.
if(FELINE_ACTIVITY)
  add_executable(feline_activity testbench/area/activity_main.cpp testbench/area/activity.cpp testbench/area/toggles.cpp
                 testbench/program/activity_options.cpp testbench/program/command_line.cpp testbench/program/frames.cpp
                 testbench/program/subject.cpp testbench/program/timing_options.cpp testbench/cosim/cosimulation.cpp
                 testbench/cosim/memory_model.cpp testbench/cosim/mismatch.cpp testbench/cosim/scoreboard.cpp)
  target_compile_options(feline_activity PRIVATE ${FELINE_WARNINGS})
  target_link_libraries(feline_activity PRIVATE feline_scenes feline_trace CLI11::CLI11)
  set_source_files_properties(testbench/area/activity_main.cpp PROPERTIES COMPILE_OPTIONS -O0)
  set_property(SOURCE testbench/area/activity.cpp testbench/program/activity_options.cpp testbench/cosim/trace_unit.cpp
               APPEND PROPERTY COMPILE_DEFINITIONS FELINE_UNIT_HEADER="${FELINE_UNIT}/unit.h")
endif()
