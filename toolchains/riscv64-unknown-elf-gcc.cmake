# SPDX-License-Identifier: MIT
# 32-bit RISC-V with the GNU compiler. FIXRAD_CORE names the instruction set.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FIXRAD_CORE)

set(flags_rv32imc "-march=rv32imc -mabi=ilp32")
if(NOT flags_${FIXRAD_CORE})
  message(FATAL_ERROR "toolchains/riscv64-unknown-elf-gcc.cmake has no flags for the core '${FIXRAD_CORE}'; use a preset")
endif()

set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
set(FIXRAD_BINUTILS_PREFIX riscv64-unknown-elf-)
# Start-up code sets the trap vector, a control register: an extension of its own to the assembler.
set(CMAKE_ASM_FLAGS_INIT "-march=${FIXRAD_CORE}_zicsr -mabi=ilp32")
set(CMAKE_CXX_FLAGS_INIT "${flags_${FIXRAD_CORE}} -mcmodel=medany -ffreestanding")
include("${CMAKE_CURRENT_LIST_DIR}/freestanding.cmake")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -nostdlib -Wl,--gc-sections -Wl,--no-warn-rwx-segments")
