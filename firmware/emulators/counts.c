// SPDX-License-Identifier: MIT
#include "counts.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kMaxRegions = 64, kPageBytes = 4096, kNameBytes = 64 };

/// The counters of one page of addresses; one for each byte, since instructions may start anywhere.
struct page {
  uint64_t base;
  struct page* next;
  uint64_t current[kPageBytes];      ///< of the current region
  uint64_t* of_region[kMaxRegions];  ///< [kPageBytes] each, or null
};

struct region {
  char name[kNameBytes];
  uint64_t address;
  int entered;  ///< its place in the order of first entries, from 1; 0: never
  uint64_t entries, largest;
};

static struct page* pages;
static struct region regions[kMaxRegions] = {{"start", UINT64_MAX, 1, 1, 0}};
static int region_count = 1, entered_count = 1, current_region;

static void* allocate(size_t bytes) {
  void* memory = calloc(1, bytes);
  if (memory == NULL) {
    fprintf(stderr, "emulator: out of memory for counters\n");
    exit(125);
  }
  return memory;
}

void counts_declare_region(const char* name, uint64_t address) {
  if (region_count == kMaxRegions || strlen(name) >= kNameBytes) {
    fprintf(stderr, "emulator: too many regions, or too long a name: %s\n", name);
    exit(125);
  }
  strcpy(regions[region_count].name, name);
  regions[region_count].address = address;
  ++region_count;
}

int counts_region_at(uint64_t address) {
  for (int i = 1; i < region_count; ++i) {
    if (regions[i].address == address) {
      return i;
    }
  }
  return -1;
}

uint64_t* counts_at(uint64_t address) {
  static struct page* last;  // most calls are for the page of the call before
  const uint64_t base = address & ~(uint64_t)(kPageBytes - 1);
  if (last != NULL && last->base == base) {
    return &last->current[address - base];
  }
  struct page* page = pages;
  while (page != NULL && page->base != base) {
    page = page->next;
  }
  if (page == NULL) {
    page = allocate(sizeof *page);
    page->base = base;
    page->next = pages;
    pages = page;
  }
  last = page;
  return &page->current[address - base];
}

// Returns what was counted on the page since the region was entered.
static uint64_t credit(struct page* page) {
  uint64_t sum = 0;
  uint64_t** counters = &page->of_region[current_region];
  for (int i = 0; i < kPageBytes; ++i) {
    if (page->current[i] != 0) {
      if (*counters == NULL) {
        *counters = allocate(kPageBytes * sizeof **counters);
      }
      (*counters)[i] += page->current[i];
      sum += page->current[i];
      page->current[i] = 0;
    }
  }
  return sum;
}

// What was counted since the current region was entered belongs to it.
static void leave_region(void) {
  uint64_t sum = 0;
  for (struct page* page = pages; page != NULL; page = page->next) {
    sum += credit(page);
  }
  struct region* left = &regions[current_region];
  left->largest = sum > left->largest ? sum : left->largest;
}

void counts_enter(int region) {
  leave_region();
  current_region = region;
  ++regions[region].entries;
  if (regions[region].entered == 0) {
    regions[region].entered = ++entered_count;
  }
}

static uint64_t region_total(int region) {
  uint64_t total = 0;
  for (const struct page* page = pages; page != NULL; page = page->next) {
    for (int i = 0; page->of_region[region] != NULL && i < kPageBytes; ++i) {
      total += page->of_region[region][i];
    }
  }
  return total;
}

static void write_region(FILE* file, int region) {
  fprintf(file, "  \"%s\": {\"count\": %" PRIu64 ", \"entries\": %" PRIu64 ", \"largest\": %" PRIu64 ", \"by_pc\": {",
          regions[region].name, region_total(region), regions[region].entries, regions[region].largest);
  const char* separator = "";
  for (const struct page* page = pages; page != NULL; page = page->next) {
    for (int i = 0; page->of_region[region] != NULL && i < kPageBytes; ++i) {
      if (page->of_region[region][i] != 0) {
        fprintf(file, "%s\"0x%" PRIx64 "\": %" PRIu64, separator, page->base + (uint64_t)i,
                page->of_region[region][i]);
        separator = ", ";
      }
    }
  }
  fprintf(file, "}}");
}

int counts_write(const char* path, const char* unit, uint64_t stack_low) {
  leave_region();
  FILE* file = fopen(path, "w");
  if (file == NULL) {
    fprintf(stderr, "emulator: cannot write %s\n", path);
    return -1;
  }
  uint64_t total = 0;
  for (int i = 0; i < region_count; ++i) {
    total += region_total(i);
  }
  fprintf(file, "{\"unit\": \"%s\", \"total\": %" PRIu64 ", \"stack_low\": ", unit, total);
  if (stack_low == UINT64_MAX) {
    fprintf(file, "null");
  } else {
    fprintf(file, "%" PRIu64, stack_low);
  }
  fprintf(file, ", \"regions\": {\n");
  for (int place = 1; place <= entered_count; ++place) {
    for (int i = 0; i < region_count; ++i) {
      if (regions[i].entered == place) {
        write_region(file, i);
        fprintf(file, "%s\n", place < entered_count ? "," : "");
      }
    }
  }
  fprintf(file, "}}\n");
  const int failed = ferror(file);
  return fclose(file) != 0 || failed != 0 ? -1 : 0;
}
