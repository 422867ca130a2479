#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Code and tables that a library brings into a program, from the linker's map, against a budget.

Counts the sections .text and .rodata of the library's members, and the .text of the named object, which holds what the
compiler has put inline there. Exit code 0 if they fit, else 1.
"""

import argparse
import re
import sys

# " .text.name  0x00001234  0x56 path" on one line, or the name alone on the line before.
ENTRY = re.compile(r"^ (\.\S+)(?:\n)?\s+0x[0-9a-f]+\s+0x([0-9a-f]+) (\S+)$", re.MULTILINE)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", required=True, help="file name, as libfixrad.a")
    parser.add_argument("--object", required=True, help="file name, as main.cpp.obj")
    parser.add_argument("--budget", type=int, required=True, metavar="BYTES")
    parser.add_argument("map")
    options = parser.parse_args()
    with open(options.map, encoding="utf-8") as file:
        text = file.read()
    placed = text.split("Linker script and memory map", 1)[-1]  # before it: what was left out
    sizes, files = {"code": 0, "tables": 0, "inline": 0}, {}
    for section, size, path in ENTRY.findall(placed):
        of_library = f"{options.library}(" in path
        is_program = path.endswith("/" + options.object)
        kinds = {"text": "code", "rodata": "tables"} if of_library else {"text": "inline"} if is_program else {}
        kind = kinds.get(section.split(".")[1])
        if kind:
            sizes[kind] += int(size, 16)
            name = re.split(r"[/(]", path.rstrip(")"))[-1]
            files[name] = files.get(name, 0) + int(size, 16)
    total = sum(sizes.values())
    if not all(sizes.values()):
        print(f"{options.map}: found nothing of one kind: {sizes}")
        return 1
    for name, size in sorted(files.items(), key=lambda item: -item[1]):
        print(f"{size:6d} {name}")
    print(f"code and tables: {total} bytes of {options.budget}: " + ", ".join(f"{k} {v}" for k, v in sizes.items()))
    return 0 if total <= options.budget else 1


if __name__ == "__main__":
    sys.exit(main())
