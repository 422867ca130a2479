# SPDX-License-Identifier: MIT
# The Xtensa core of the ESP8266 with the GNU compiler. FIXRAD_CORE names the core.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR xtensa)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXRAD_CORE)

set(flags_lx106 "-mlongcalls")
if(NOT flags_${FIXRAD_CORE})
  message(FATAL_ERROR "toolchains/xtensa-lx106-elf-gcc.cmake has no flags for the core '${FIXRAD_CORE}'; use a preset")
endif()

set(CMAKE_CXX_COMPILER xtensa-lx106-elf-g++)
set(CMAKE_ASM_COMPILER xtensa-lx106-elf-gcc)
set(FIXRAD_BINUTILS_PREFIX xtensa-lx106-elf-)
set(CMAKE_CXX_FLAGS_INIT "${flags_${FIXRAD_CORE}} -ffreestanding")
include("${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments")
