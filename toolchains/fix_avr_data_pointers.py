#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Repairs pointers to flash in the initial values of an AVR object file, in place.

clang takes whatever lies in address_space(1) for code and emits its address in words, as if it were a function
(relocation R_AVR_16_PM): a table of pointers to tables in flash then holds half of each address. Data is addressed in
bytes (R_AVR_16). Pointers that code computes are right, and those to functions stay as they are.

usage: fix_avr_data_pointers.py OBJECT
"""

import struct
import sys

AVR_16, AVR_16_PM = 4, 5
RELA = 4
STT_OBJECT, STT_FUNC, STT_SECTION = 1, 2, 3


def text_at(data, at):
    return data[at:data.index(b"\0", at)].decode()


def is_mangled_variable(name):
    """A C++ name without parameters: `_ZN` names `E`, or `_Z` length name. Functions always have parameters."""
    if name.startswith("_ZN"):
        rest = name[3:]
        while rest[:1].isdigit():
            digits = len(rest) - len(rest.lstrip("0123456789"))
            rest = rest[digits + int(rest[:digits]):]
            if rest.startswith("12_GLOBAL__N_1"):
                rest = rest[14:]
        return rest == "E"
    if name.startswith("_Z") and name[2:3].isdigit():
        digits = len(name[2:]) - len(name[2:].lstrip("0123456789"))
        return len(name) == 2 + digits + int(name[2:2 + digits])
    return False


def points_to_data(data, sections, table, index):
    name_at, _, _, info, _, where = struct.unpack_from("<IIIBBH", data, table[4] + 16 * index)
    kind = info & 15
    if kind == STT_SECTION:
        names = sections[struct.unpack_from("<H", data, 50)[0]][4]
        return not text_at(data, names + sections[where][0]).startswith(".text")
    if where != 0:
        return kind == STT_OBJECT
    # Undefined symbols have no kind.
    return is_mangled_variable(text_at(data, sections[table[6]][4] + name_at))


def repair(data):
    """Returns the number of relocations changed in the bytearray `data`."""
    start, = struct.unpack_from("<I", data, 32)
    count, = struct.unpack_from("<H", data, 48)
    sections = [struct.unpack_from("<10I", data, start + 40 * i) for i in range(count)]
    changed = 0
    for section in sections:
        if section[1] != RELA:
            continue
        for at in range(section[4], section[4] + section[5], 12):
            info, = struct.unpack_from("<I", data, at + 4)
            if info & 255 == AVR_16_PM and points_to_data(data, sections, sections[section[6]], info >> 8):
                struct.pack_into("<I", data, at + 4, info & ~255 | AVR_16)
                changed += 1
    return changed


def main():
    if len(sys.argv) != 2:
        print("usage: fix_avr_data_pointers.py OBJECT", file=sys.stderr)
        return 2
    with open(sys.argv[1], "r+b") as file:
        data = bytearray(file.read())
        if data[:6] != b"\x7fELF\x01\x01":
            print(f"{sys.argv[1]}: not a 32-bit little-endian ELF file", file=sys.stderr)
            return 1
        if repair(data):
            file.seek(0)
            file.write(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
