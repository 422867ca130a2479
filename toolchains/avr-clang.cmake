# SPDX-License-Identifier: MIT
# 8-bit AVR: clang compiles, since avr-gcc of most distributions has no C++17; avr-g++ links, since clang brings
# neither libgcc nor start-up code for AVR. FIXRAD_CORE names the chip.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXRAD_CORE)

set(flags_atmega2560 "-mmcu=atmega2560")
if(NOT flags_${FIXRAD_CORE})
  message(FATAL_ERROR "toolchains/avr-clang.cmake has no flags for the chip '${FIXRAD_CORE}'; use a preset")
endif()

# Version 14 and no other: 19 was seen to compile integer code wrongly for this target.
find_program(FIXRAD_AVR_CLANG clang++-14 REQUIRED)
find_program(FIXRAD_AVR_LINKER avr-g++ REQUIRED)
find_program(FIXRAD_AVR_AR avr-ar REQUIRED)
find_program(FIXRAD_AVR_RANLIB avr-ranlib REQUIRED)
find_path(FIXRAD_AVR_LIBC avr/io.h PATHS /usr/lib/avr/include /usr/avr/include REQUIRED NO_DEFAULT_PATH)
set(CMAKE_CXX_COMPILER "${FIXRAD_AVR_CLANG}")
set(CMAKE_CXX_COMPILER_TARGET avr)
set(CMAKE_AR "${FIXRAD_AVR_AR}" CACHE FILEPATH "Archiver")
set(CMAKE_RANLIB "${FIXRAD_AVR_RANLIB}" CACHE FILEPATH "Archive indexer")
set(FIXRAD_BINUTILS_PREFIX avr-)
# Not -ffreestanding: clang then gives main() a C++ name, and start-up code does not find it. The C library's headers
# leave the limits out for C++ before C++11 unless asked.
set(CMAKE_CXX_FLAGS_INIT
  "${flags_${FIXRAD_CORE}} -nostdlibinc -isystem ${FIXRAD_AVR_LIBC} -D__STDC_LIMIT_MACROS -D__STDC_CONSTANT_MACROS")
include("${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake")
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(CMAKE_CXX_COMPILE_OBJECT
  "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>"
  "\"${Python3_EXECUTABLE}\" -B \"${CMAKE_CURRENT_LIST_DIR}/fix_avr_data_pointers.py\" <OBJECT>")
# Read by toolchains/check_avr_arguments.py.
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_LINK_EXECUTABLE
  "\"${FIXRAD_AVR_LINKER}\" ${flags_${FIXRAD_CORE}} <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--gc-sections -Wl,--fatal-warnings")
