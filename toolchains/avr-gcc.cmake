# SPDX-License-Identifier: MIT
# 8-bit AVR with avr-gcc 5.4, whose C++17 is called c++1z and is complete enough for the core. Not clang: version 14
# was seen to lose spilled registers in functions with more than 62 bytes of locals, to read arguments on the stack
# one byte off, and to halve addresses of flash in initial values. FIXRAD_CORE names the chip.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXRAD_CORE)

set(flags_atmega2560 "-mmcu=atmega2560")
if(NOT flags_${FIXRAD_CORE})
  message(FATAL_ERROR "toolchains/avr-gcc.cmake has no flags for the chip '${FIXRAD_CORE}'; use a preset")
endif()

set(CMAKE_CXX_COMPILER avr-g++)
set(FIXRAD_BINUTILS_PREFIX avr-)
# This old compiler does not know [[nodiscard]] and the unrolling of loops.
set(CMAKE_CXX_FLAGS_INIT "${flags_${FIXRAD_CORE}} -Wno-attributes -Wno-unknown-pragmas")
include("${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake")
set(CMAKE_EXE_LINKER_FLAGS_INIT "${flags_${FIXRAD_CORE}} -Wl,--gc-sections -Wl,--fatal-warnings")
