// SPDX-License-Identifier: MIT
// QEMU TCG plugin: counts the executed instructions of the guest at each address, apart for each region.
//   -plugin count_plugin.so,out=FILE,region=NAME@HEXADDRESS,region=...
// QEMU's header is not packaged; the few functions of its plugin interface, version 1, are declared here.
// Without interrupts or -icount no translation block is left in the middle, so that the counts are exact.
#define _POSIX_C_SOURCE 200809L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "counts.h"

#define PLUGIN_EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { kInlineAddU64 = 0, kNoRegisters = 0 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, void (*)(plugin_id, struct qemu_plugin_tb*));
extern void qemu_plugin_register_atexit_cb(plugin_id, void (*)(plugin_id, void*), void*);
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb*);
extern struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb*, size_t);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn*);
extern void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn*, int operation, void*,
                                                       uint64_t);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn*, void (*)(unsigned, void*),
                                                   int flags, void*);

PLUGIN_EXPORT int qemu_plugin_version = 1;
PLUGIN_EXPORT int qemu_plugin_install(plugin_id id, const void* info, int argc, char** argv);

static const char* out_path;

// Runs before the first instruction of the region is counted.
static void on_region(unsigned cpu, void* region) {
  (void)cpu;
  counts_enter((int)(intptr_t)region);
}

static void on_translate(plugin_id id, struct qemu_plugin_tb* block) {
  (void)id;
  const size_t count = qemu_plugin_tb_n_insns(block);
  for (size_t i = 0; i < count; ++i) {
    struct qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    const uint64_t address = qemu_plugin_insn_vaddr(instruction);
    const int region = counts_region_at(address);
    if (region >= 0) {
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_region, kNoRegisters, (void*)(intptr_t)region);
    }
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, kInlineAddU64, counts_at(address), 1);
  }
}

static void on_exit(plugin_id id, void* unused) {
  (void)id;
  (void)unused;
  // A missing file is what run.py notices; an exit code cannot be set from here.
  counts_write(out_path, "instructions", UINT64_MAX);
}

int qemu_plugin_install(plugin_id id, const void* info, int argc, char** argv) {
  (void)info;
  for (int i = 0; i < argc; ++i) {
    if (strncmp(argv[i], "out=", 4) == 0) {
      out_path = strdup(argv[i] + 4);
    } else if (strncmp(argv[i], "region=", 7) == 0 && strchr(argv[i], '@') != NULL) {
      char* at = strchr(argv[i], '@');
      *at = '\0';
      counts_declare_region(argv[i] + 7, strtoull(at + 1, NULL, 16));
    } else {
      fprintf(stderr, "count_plugin: unknown argument %s\n", argv[i]);
      return -1;
    }
  }
  if (out_path == NULL) {
    fprintf(stderr, "count_plugin: out=FILE is missing\n");
    return -1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translate);
  qemu_plugin_register_atexit_cb(id, on_exit, NULL);
  return 0;
}
