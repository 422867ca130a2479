#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Looks into a library for what the core must not contain.

  symbols   it may call nothing from outside but integer helpers of the compiler and memcpy, memmove, memset
  float     no floating-point instruction (Arm; elsewhere soft float shows as a symbol)
  ram       no static data: on AVR also no constant outside of flash

Exit code 0 and a line of what was seen, or 1 and a line for each find.
"""

import argparse
import re
import subprocess
import sys

# Integer products, divisions, shifts and bit counts, by the names that gcc and clang give them.
ALLOWED = re.compile(
    r"mem(cpy|move|set)"
    r"|__(u|s)?(mul|umul|smul|div|udiv|mod|umod|divmod|udivmod|mulhi|umulhi)(q|h|s|d|ps)i[a-z0-9]*"
    r"|__(mul|umul|mulu|muls|umulh)?(u|s)?(hi|si|qi)(hi|si|di)3"
    r"|__(ashl|ashr|lshr|neg|cmp|ucmp|add|sub)(h|s|d)i[0-9]?(_s8)?"
    r"|__(clz|ctz|ffs|popcount|bswap)(q|h|s|d)i2"
    r"|__aeabi_(l|ll|ul)?(mul|lsl|lsr|asr|cmp|divmod)|__aeabi_u?i?(div|divmod)|__aeabi_mem(cpy|move|set|clr)[48]?"
    r"|__gnu_thumb1_case_[us][qhi]i?"
    # Asked for wherever there are tables in flash, too; that there is nothing to copy or clear, `ram` shows.
    r"|__do_(copy_data|clear_bss)")

FORBIDDEN = (
    ("soft float", re.compile(r"__aeabi_(f|d|i2f|i2d|ui2f|ui2d|l2f|l2d|ul2f|ul2d|cf|cd)|__\w+[sdt]f[0-9]?$|__\w*[sdt]f\w+i$")),
    ("heap", re.compile(r"(m|c|re)alloc$|free$|_?_?sbrk|_Zn[aw]|_Zd[al]")),
    ("exception", re.compile(r"__cxa_(throw|allocate|begin|end|rethrow)|_Unwind|__gxx_personality|__aeabi_unwind")),
    ("guard of a static object", re.compile(r"__cxa_(guard|atexit)|__aeabi_atexit|atexit$|__dso_handle")),
    ("constructor of a static object", re.compile(r"__do_global_[cd]tors")),
    ("output", re.compile(r"v?f?s?n?i?printf|puts|putchar|abort|__assert")),
)

RAM_SECTIONS = r"\.(data|bss|sdata|sbss|tdata|tbss|noinit|init_array|ctors|preinit_array)(\.|$)"
AVR_RAM_SECTIONS = r"\.(data|bss|rodata|noinit|init_array|ctors)(\.|$)"

# Vector and scalar floating-point mnemonics of Thumb all begin with v; v is no other instruction's first letter.
FLOAT_INSTRUCTION = re.compile(r"^\s+[0-9a-f]+:\s+(?:[0-9a-f]{4} ?)+\s+(v[a-z][a-z0-9.]*)", re.MULTILINE)


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"check_library.py: {' '.join(command)}: {done.stderr.strip()}")
    return done.stdout


def kind_of(name):
    for kind, pattern in FORBIDDEN:
        if pattern.match(name):
            return kind
    return "from outside"


def symbols(options):
    undefined, defined = set(), set()
    for line in run(options.prefix + "nm", options.library).splitlines():
        fields = line.split()
        if len(fields) >= 2 and fields[-2] in ("U", "w"):
            undefined.add(fields[-1])
        elif len(fields) == 3:
            defined.add(fields[2])
    if not defined:
        return ["no symbols at all"], ""
    outside = sorted(undefined - defined)
    finds = [f"{kind_of(name)}: {name}" for name in outside if not ALLOWED.fullmatch(name)]
    return finds, f"calls from outside: {' '.join(outside) or 'none'}"


def floats(options):
    text = run(options.prefix + "objdump", "-d", options.library)
    if not re.search(r"^\s+[0-9a-f]+:\s+[0-9a-f]{4}", text, re.MULTILINE):
        return ["no Thumb instructions at all"], ""
    return [f"floating-point instruction: {name}" for name in FLOAT_INSTRUCTION.findall(text)], "no floating-point instruction"


def ram(options):
    pattern = re.compile(AVR_RAM_SECTIONS if options.prefix == "avr-" else RAM_SECTIONS)
    finds, sections = [], 0
    for line in run(options.prefix + "objdump", "-h", options.library).splitlines():
        fields = line.split()
        if len(fields) >= 7 and fields[0].isdigit():
            sections += 1
            if pattern.match(fields[1]) and int(fields[2], 16) > 0:
                finds.append(f"static RAM: {int(fields[2], 16)} bytes in {fields[1]}")
    for line in run(options.prefix + "nm", options.library).splitlines():
        if len(line.split()) == 3 and line.split()[1] in "Cc":
            finds.append(f"static RAM: common symbol {line.split()[2]}")
    return (finds, "0 bytes of static RAM") if sections else (["no sections at all"], "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("symbols", "float", "ram"))
    parser.add_argument("--prefix", default="", help="of nm and objdump, as arm-none-eabi-")
    parser.add_argument("library")
    options = parser.parse_args()
    finds, seen = {"symbols": symbols, "float": floats, "ram": ram}[options.what](options)
    print("\n".join(finds) if finds else f"{options.library}: {seen}")
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
