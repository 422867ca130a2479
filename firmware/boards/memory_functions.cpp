// SPDX-License-Identifier: MIT
// The three functions that a compiler calls by itself to copy and clear objects; a freestanding program
// brings its own. Words where both sides are aligned, since that is what the compiler's calls nearly always
// are.

#include <stddef.h>
#include <stdint.h>

extern "C" {
void* memcpy(void* to, const void* from, size_t bytes);
void* memmove(void* to, const void* from, size_t bytes);
void* memset(void* to, int value, size_t bytes);
}

namespace {

// The objects have other types than words.
using Word [[gnu::may_alias]] = uint32_t;

bool is_aligned(uintptr_t addresses) {
  return addresses % sizeof(Word) == 0;
}

}  // namespace

void* memcpy(void* to, const void* from, size_t bytes) {
  auto* out = static_cast<uint8_t*>(to);
  const auto* in = static_cast<const uint8_t*>(from);
  if (is_aligned(reinterpret_cast<uintptr_t>(out) | reinterpret_cast<uintptr_t>(in))) {
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word), out += sizeof(Word), in += sizeof(Word)) {
      *reinterpret_cast<Word*>(out) = *reinterpret_cast<const Word*>(in);
    }
  }
  for (; bytes > 0; --bytes) {
    *out++ = *in++;
  }
  return to;
}

void* memmove(void* to, const void* from, size_t bytes) {
  auto* out = static_cast<uint8_t*>(to);
  const auto* in = static_cast<const uint8_t*>(from);
  if (reinterpret_cast<uintptr_t>(out) <= reinterpret_cast<uintptr_t>(in)) {
    return memcpy(to, from, bytes);
  }
  while (bytes > 0) {
    --bytes;
    out[bytes] = in[bytes];
  }
  return to;
}

void* memset(void* to, int value, size_t bytes) {
  auto* out = static_cast<uint8_t*>(to);
  const auto byte = static_cast<uint8_t>(value);
  if (is_aligned(reinterpret_cast<uintptr_t>(out))) {
    const Word word = byte * uint32_t{0x01010101};
    for (; bytes >= sizeof(Word); bytes -= sizeof(Word), out += sizeof(Word)) {
      *reinterpret_cast<Word*>(out) = word;
    }
  }
  for (; bytes > 0; --bytes) {
    *out++ = byte;
  }
  return to;
}
