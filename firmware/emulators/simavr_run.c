// SPDX-License-Identifier: MIT
// Runs a program for an AVR in simavr:
//   simavr_run MCU ELF MAX_CYCLES [out=FILE] [region=NAME@HEXADDRESS]...
// The board writes console characters to GPIOR0 and its exit code to GPIOR2. Ends with that code; 101 if the
// core crashed or went to sleep for good; 124 if MAX_CYCLES were not enough. With out= it writes the cycles
// at each address (counts.h) and the lowest stack pointer.
#include <inttypes.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "counts.h"

// Addresses in data space, the same on every AVR with these registers.
enum { kGpior0 = 0x3e, kGpior1 = 0x4a, kGpior2 = 0x4b, kStackLow = 0x5d, kStackHigh = 0x5e };
enum { kExitKey = 0x5a };
enum { kExitFault = 101, kExitOutOfTime = 124, kExitRunner = 125 };

static int has_exited, exit_code;
static const char* out_path;

static void on_console(struct avr_t* avr, avr_io_addr_t address, uint8_t value, void* unused) {
  (void)avr;
  (void)address;
  (void)unused;
  putchar(value);
}

static void on_exit_code(struct avr_t* avr, avr_io_addr_t address, uint8_t value, void* unused) {
  (void)address;
  (void)unused;
  has_exited = 1;
  exit_code = avr->data[kGpior1] == kExitKey ? value : kExitFault;
  if (avr->data[kGpior1] != kExitKey) {
    fprintf(stderr, "simavr_run: an exit code that the board did not write, at 0x%" PRIx32 "\n",
            (uint32_t)avr->pc);
  }
}

static void read_options(int argc, char** argv) {
  for (int i = 4; i < argc; ++i) {
    char* at = strchr(argv[i], '@');
    if (strncmp(argv[i], "out=", 4) == 0) {
      out_path = argv[i] + 4;
    } else if (strncmp(argv[i], "region=", 7) == 0 && at != NULL) {
      *at = '\0';
      counts_declare_region(argv[i] + 7, strtoull(at + 1, NULL, 16));
    } else {
      fprintf(stderr, "simavr_run: unknown argument %s\n", argv[i]);
      exit(kExitRunner);
    }
  }
}

// simavr reports each section that it loads; that is not the program's console.
static void be_silent(struct avr_t* avr, const int level, const char* format, va_list arguments) {
  (void)avr;
  (void)level;
  (void)format;
  (void)arguments;
}

static avr_t* make_avr(const char* mcu, const char* path) {
  static elf_firmware_t firmware;
  avr_global_logger_set(be_silent);
  if (elf_read_firmware(path, &firmware) != 0) {
    fprintf(stderr, "simavr_run: cannot read %s\n", path);
    exit(kExitRunner);
  }
  avr_t* avr = avr_make_mcu_by_name(mcu);
  if (avr == NULL) {
    fprintf(stderr, "simavr_run: this simavr does not know %s\n", mcu);
    exit(kExitRunner);
  }
  avr_init(avr);
  avr->log = LOG_NONE;
  avr->frequency = 16000000;
  avr_load_firmware(avr, &firmware);
  avr_register_io_write(avr, kGpior0, on_console, NULL);
  avr_register_io_write(avr, kGpior2, on_exit_code, NULL);
  return avr;
}

static int is_running(const avr_t* avr, int state, uint64_t max_cycles) {
  // Nothing here sleeps on purpose: a core asleep would never wake.
  const int has_stopped = state == cpu_Crashed || state == cpu_Done || state == cpu_Sleeping;
  return !has_exited && !has_stopped && avr->cycle < max_cycles;
}

// Cycles of each instruction go to its address; a region begins before its first instruction is counted.
static uint64_t run_counting(avr_t* avr, uint64_t max_cycles, int* state) {
  uint64_t stack_low = UINT64_MAX;
  while (is_running(avr, *state, max_cycles)) {
    const uint64_t address = avr->pc, before = avr->cycle;
    const int region = counts_region_at(address);
    if (region >= 0) {
      counts_enter(region);
    }
    *state = avr_run(avr);
    *counts_at(address) += avr->cycle - before;
    const uint64_t stack = (uint64_t)(avr->data[kStackLow] | avr->data[kStackHigh] << 8);
    // Start-up code sets the two bytes of the pointer one after the other.
    if (stack >= 0x200 && stack < stack_low) {
      stack_low = stack;
    }
  }
  return stack_low;
}

int main(int argc, char** argv) {
  if (argc < 4) {
    fprintf(stderr, "usage: simavr_run MCU ELF MAX_CYCLES [out=FILE] [region=NAME@HEXADDRESS]...\n");
    return kExitRunner;
  }
  read_options(argc, argv);
  avr_t* avr = make_avr(argv[1], argv[2]);
  const uint64_t max_cycles = strtoull(argv[3], NULL, 10);
  int state = cpu_Running;
  uint64_t stack_low = UINT64_MAX;
  if (out_path != NULL) {
    stack_low = run_counting(avr, max_cycles, &state);
  } else {
    while (is_running(avr, state, max_cycles)) {
      state = avr_run(avr);
    }
  }
  fflush(stdout);
  if (out_path != NULL && counts_write(out_path, "cycles", stack_low) != 0) {
    return kExitRunner;
  }
  if (has_exited) {
    return exit_code;
  }
  if (avr->cycle < max_cycles) {
    fprintf(stderr, "simavr_run: the core stopped at 0x%" PRIx32 "\n", (uint32_t)avr->pc);
    return kExitFault;
  }
  fprintf(stderr, "simavr_run: not finished after %" PRIu64 " cycles\n", max_cycles);
  return kExitOutOfTime;
}
