# SPDX-License-Identifier: MIT
# The files of this folder that run on the host and on every target; read by both builds. Grouped so that a group and
# the core make one program of a small chip.
set(FIXRAD_DEVICE_GROUPS numbers tables boxes scenes saves)
set(numbers_TESTS arithmetic_test.cpp q_test.cpp platform_test.cpp digest_test.cpp)
set(tables_TESTS row_test.cpp delta_table_test.cpp view_test.cpp)
set(tables_HELPERS box_scene.cpp)
set(boxes_TESTS ledger_test.cpp furnace_test.cpp load_test.cpp)
set(boxes_HELPERS box_scene.cpp)
set(scenes_TESTS scene_test.cpp)
set(saves_TESTS save_test.cpp)

set(FIXRAD_DEVICE_TESTS "")
set(FIXRAD_DEVICE_TEST_COUNT 0)
foreach(group ${FIXRAD_DEVICE_GROUPS})
  list(TRANSFORM ${group}_TESTS PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
  list(TRANSFORM ${group}_HELPERS PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
  # A program must run as many tests as its files hold.
  set(${group}_COUNT 0)
  foreach(file ${${group}_TESTS})
    file(STRINGS "${file}" tests REGEX "^TEST\\(")
    list(LENGTH tests count)
    math(EXPR ${group}_COUNT "${${group}_COUNT} + ${count}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  math(EXPR FIXRAD_DEVICE_TEST_COUNT "${FIXRAD_DEVICE_TEST_COUNT} + ${${group}_COUNT}")
  list(APPEND FIXRAD_DEVICE_TESTS ${${group}_TESTS} ${${group}_HELPERS})
endforeach()
list(REMOVE_DUPLICATES FIXRAD_DEVICE_TESTS)

set(FIXRAD_SMALL_TEST_SOURCES "${CMAKE_CURRENT_LIST_DIR}/small_test.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/../../firmware/apps/selftest/main.cpp")

# A program whose tests are to fail, and what it says.
set(FIXRAD_FAILING_TEST "${CMAKE_CURRENT_LIST_DIR}/failing_test.cpp")
set(FIXRAD_FAILING_COUNT "2 passed, 15 failed")
set(FIXRAD_FAILING_MESSAGE "tests/device/failing_test.cpp:[0-9]+: expected hidden\\(-3\\) == 70000, got -0x3 and 0x11170")
