/* SPDX-License-Identifier: MIT
   RV32 on QEMU's `virt`: stack, global pointer and trap vector, then start() in C++. */
  .section .text.start, "ax"
  .globl _start
_start:
  la sp, fixrad_stack_top
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  la t0, trap
  csrw mtvec, t0
  j start

  .balign 4
trap:
  la sp, fixrad_stack_top
  j fault
