# SPDX-License-Identifier: MIT
# Arm Cortex-M with the GNU Arm embedded compiler. FIXRAD_CORE names the core.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXRAD_CORE)

set(flags_cortex-m0 "-mcpu=cortex-m0")
set(flags_cortex-m3 "-mcpu=cortex-m3")
set(flags_cortex-m4f "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
set(flags_cortex-m7 "-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
if(NOT flags_${FIXRAD_CORE})
  message(FATAL_ERROR "toolchains/arm-none-eabi-gcc.cmake has no flags for the core '${FIXRAD_CORE}'; use a preset")
endif()

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(FIXRAD_BINUTILS_PREFIX arm-none-eabi-)
set(CMAKE_ASM_FLAGS_INIT "${flags_${FIXRAD_CORE}} -mthumb")
set(CMAKE_CXX_FLAGS_INIT "${flags_${FIXRAD_CORE}} -mthumb -ffreestanding")
include("${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments")
