# SPDX-License-Identifier: MIT
# Reference 1: the core's own algorithm in double.
set(sources twin.cpp twin_delta_table.cpp twin_hemisphere.cpp twin_pairs.cpp twin_recorder.cpp twin_scanline.cpp twin_scene.cpp
            twin_spans.cpp twin_view.cpp)
list(TRANSFORM sources PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
add_library(fixrad_twin STATIC ${sources})
add_library(fixrad::twin ALIAS fixrad_twin)
fixrad_compile_options(fixrad_twin)
target_include_directories(fixrad_twin PUBLIC ${FIXRAD_HOST_INCLUDE})
target_link_libraries(fixrad_twin PUBLIC fixrad::fixrad glm::glm PRIVATE fixrad::tables fixrad::reference)

fixrad_whole_program(fixrad_twin)
