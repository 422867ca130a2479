# SPDX-License-Identifier: MIT
# What all targets' compilers have in common. -O3 since the figures that count are instructions; nothing of the C++
# run-time library is there; sections that nobody uses are left out; debug information costs no byte of flash, and version
# 4 of it is what the AVR linker reads.
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_CXX_FLAGS_INIT} -fno-exceptions -fno-rtti -fno-threadsafe-statics")
string(APPEND CMAKE_CXX_FLAGS_INIT " -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections -gdwarf-4")
set(CMAKE_CXX_FLAGS_RELEASE_INIT "-O3")
set(CMAKE_CXX_FLAGS_RELEASE "-O3" CACHE STRING "Flags of the Release configuration on a target")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lgcc")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)
set(CMAKE_EXECUTABLE_SUFFIX .elf)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
