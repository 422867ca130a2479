/* SPDX-License-Identifier: MIT
   Xtensa lx106 in QEMU's `sim`: reset, exception vectors, and the simulator's calls for console and exit. */
  .section .reset, "ax"
  .global reset
  .align 4
reset:
  j 1f
  .align 4
.Lstart: .word start_stack
1:
  l32r a0, .Lstart
  jx a0

/* Each vector has 16 bytes, the last 32; no interrupt is enabled, so whatever comes is a fault. */
  .section .vectors, "ax"
  .global vectors
vectors:
.Lstack_top: .word fixrad_stack_top
.Lfault: .word fault
  .org 0x10
  j fault_vector  /* debug */
  .org 0x20
  j fault_vector  /* NMI */
  .org 0x30
  j fault_vector  /* kernel exception */
  .org 0x50
  j fault_vector  /* user exception */
  .org 0x70
  j fault_vector  /* double exception */
  .org 0x80
fault_vector:
  l32r a1, .Lstack_top
  l32r a0, .Lfault
  jx a0

  .section .text.start, "ax"
  .literal_position
  .align 4
start_stack:
  movi a1, fixrad_stack_top
  movi a0, vectors
  wsr a0, vecbase
  /* PS as after boot: no interrupts, user vector mode, so that a fault takes the user vector. */
  movi a0, 0x2f
  wsr a0, ps
  rsync
  movi a0, start
  jx a0

/* void simulator_exit(int code) */
  .section .text.simulator_exit, "ax"
  .global simulator_exit
  .align 4
simulator_exit:
  mov a3, a2
  movi a2, 1
  .byte 0x00, 0x51, 0x00  /* simcall; the assembler has no name for it on this core */
1:
  j 1b

/* void simulator_write(const char* text, uint32_t bytes) */
  .section .text.simulator_write, "ax"
  .global simulator_write
  .align 4
simulator_write:
  mov a5, a3
  mov a4, a2
  movi a3, 1
  movi a2, 4
  .byte 0x00, 0x51, 0x00
  ret
