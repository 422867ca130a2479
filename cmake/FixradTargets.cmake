# SPDX-License-Identifier: MIT
# What every target of this project shares: the language level, warnings as errors, sanitizers on request.

function(fixrad_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
  if(FIXRAD_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  if(FIXRAD_FUZZ)
    target_compile_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# fixrad_light(target...): what only calls the work, tests and the command line, is not worth a third of all build time.
function(fixrad_light)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-fno-lto>)
  endforeach()
endfunction()

# fixrad_test(NAME SOURCES files... LINK targets...): one GoogleTest executable, one ctest entry per TEST.
function(fixrad_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  if(FIXRAD_CHECKED)
    target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests/place_counts.cpp")
    target_link_libraries(${name} PRIVATE fixrad::fixrad)
  endif()
  fixrad_compile_options(${name})
  fixrad_light(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE FIXRAD_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()

# fixrad_whole_program(target...): optimise across files where the final link asks for it too. Fat objects keep the
# libraries usable for links that do not.
function(fixrad_whole_program)
  if(FIXRAD_WHOLE_PROGRAM AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT FIXRAD_SANITIZE)
    foreach(target ${ARGN})
      set_target_properties(${target} PROPERTIES INTERPROCEDURAL_OPTIMIZATION ON)
      target_compile_options(${target} PRIVATE -ffat-lto-objects)
    endforeach()
  endif()
endfunction()
