# SPDX-License-Identifier: MIT
# cmake -DFIXRAD_BOARD=board -P print_scenes.cmake: the scenes that the board solves, on stdout.
include("${CMAKE_CURRENT_LIST_DIR}/../../firmware/scenes.cmake")
fixrad_board_scenes(scenes)
list(JOIN scenes "\n" text)
execute_process(COMMAND "${CMAKE_COMMAND}" -E echo "${text}")
