# SPDX-License-Identifier: MIT
# Programs for a board, and tests that run them in the board's emulator.

# fixrad_board(SOURCES files... LINKER_SCRIPT file [SCRIPT_PARTS files...] [LINK_OPTIONS options...]): the library
# fixrad_board, which every program of this build links: start-up, board.h, memories.
function(fixrad_board)
  cmake_parse_arguments(ARG "" "LINKER_SCRIPT" "SOURCES;SCRIPT_PARTS;LINK_OPTIONS" ${ARGN})
  # Objects and not an archive: nothing refers to start-up code.
  add_library(fixrad_board OBJECT ${ARG_SOURCES})
  fixrad_compile_options(fixrad_board)
  target_include_directories(fixrad_board PUBLIC "${PROJECT_SOURCE_DIR}")
  set(script "${CMAKE_CURRENT_SOURCE_DIR}/${ARG_LINKER_SCRIPT}")
  target_link_options(fixrad_board INTERFACE "-T${script}" ${ARG_LINK_OPTIONS})
  foreach(part ${ARG_SCRIPT_PARTS})
    get_filename_component(directory "${part}" DIRECTORY)
    target_link_options(fixrad_board INTERFACE "-L${directory}")
  endforeach()
  set_property(TARGET fixrad_board PROPERTY INTERFACE_LINK_DEPENDS "${script}" ${ARG_SCRIPT_PARTS})
endfunction()

# fixrad_firmware(NAME SOURCES files... [LINK targets...]): a program for the board. `add_test(NAME x COMMAND NAME)`
# runs it in the emulator; give every test a TIMEOUT.
function(fixrad_firmware name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  fixrad_compile_options(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} fixrad_board)
  add_dependencies(${name} fixrad_emulator)
endfunction()

# fixrad_firmware_test(NAME TARGET [EXIT code] [OUTPUT regex] [TIMEOUT seconds]): runs the program of TARGET; passes
# if it ends with this exit code (default 0) and its console matches the expression, both at once.
function(fixrad_firmware_test name target)
  cmake_parse_arguments(ARG "" "EXIT;OUTPUT;TIMEOUT" "" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(checks "")
  if(DEFINED ARG_EXIT)
    list(APPEND checks --expect-exit "${ARG_EXIT}")
  endif()
  if(DEFINED ARG_OUTPUT)
    list(APPEND checks --expect-output "${ARG_OUTPUT}")
  endif()
  add_test(NAME ${name} COMMAND ${FIXRAD_RUN} ${checks} "$<TARGET_FILE:${target}>")
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()
