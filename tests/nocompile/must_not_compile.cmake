# SPDX-License-Identifier: MIT
# SOURCE must fail to compile with a message that matches EXPECTED, and must compile with -DFIXRAD_CONTROL, which takes
# the offending statement out: so it is that statement, and nothing else, that is refused.

set(command "${CMAKE_COMMAND}" -E env LC_ALL=C "${COMPILER}" -std=c++17 -fsyntax-only "-I${INCLUDE_DIR}" "${SOURCE}")

execute_process(COMMAND ${command} -DFIXRAD_CONTROL RESULT_VARIABLE result ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the control, without the offending statement, does not compile:\n${output}")
endif()

execute_process(COMMAND ${command} RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles, but must not")
endif()
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "refused, but not with a message like \"${EXPECTED}\":\n${output}")
endif()
