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

# fixrad_light(LEVEL target...): what only calls the work, tests and the command line, is not worth a third of all build
# time. LEVEL is O0 or O1; under sanitizers it is O0.
function(fixrad_light level)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-${level}> $<$<CONFIG:RelWithDebInfo>:-O0>)
  endforeach()
endfunction()

# fixrad_test_headers(target): what every test includes, parsed once, with the first of them.
function(fixrad_test_headers target)
  get_property(first GLOBAL PROPERTY FIXRAD_FIRST_TEST)
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
    set_property(GLOBAL PROPERTY FIXRAD_FIRST_TEST ${target})
  endif()
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
  fixrad_light(O0 ${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE FIXRAD_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  fixrad_test_headers(${name})
  gtest_discover_tests(${name} NO_PRETTY_VALUES PROPERTIES TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()

# fixrad_whole_program(target...): each of these libraries as one translation unit, which shows the compiler the small
# functions that one stage calls of another.
function(fixrad_whole_program)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${FIXRAD_WHOLE_PROGRAM} UNITY_BUILD_BATCH_SIZE 0)
endfunction()
