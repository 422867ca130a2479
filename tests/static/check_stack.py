#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of the functions in object files, from what the compiler says of each frame and each call.

Beside every object lies FILE.ci (gcc, -fcallgraph-info=su); of AVR objects the machine code is read. Refused:
recursion, frames of a size that is not known, calls through pointers that are not listed, calls of functions that are
neither there nor listed. Prints the deepest chain.

Exit code 0 if it fits the budget, else 1.
"""

import argparse
import fnmatch
import os
import re
import subprocess
import sys

from avr_code import read_avr
from call_graph import INDIRECT_CALL, Function, Refused, demangled, read_ci

# What may be called through a pointer, by caller. Settings::engine is called where an eye is sampled; a firmware's
# Settings::observer is null; which of the functions round look() the compiler has merged with it differs.
# Functions that work pair by pair keep polygons on the stack, 2.6 KB in all: chips of 16 KB and less have none for
# them, and the programs of the project do not name them.
NEAR_FIELD = ("correct_near_field",)
DIRECT_LIGHT = ("correct_direct_light",)
PAIRS = ("ray_row", "contour_row", "add_faces", "add_face_elements", "add_pairs") + NEAR_FIELD + DIRECT_LIGHT
# A picture has highlights only where its scene names the function for them; an ATmega2560's does not.
HIGHLIGHTS = ("add_highlights",)
ENGINES = ("hemicube_rows", "lune_rows", "hemicube_pixels", "ray_row", "contour_row")
# Bytes of stack of a chip of 16 KB, and less.
SMALL = 2048
# A chip gathers, and refines its mesh, by rows.
ROWS = ("hemicube_rows", "lune_rows", "hemicube_pixels")
INDIRECT = (
    *((name, ENGINES) for name in ("look", "look_from_centroid", "look_from_whole", "look_from_drawn", "look_from_chosen",
                                   "do_stage", "go_on_with_source", "sample_element")),
    ("sample_matrix_row", ENGINES + NEAR_FIELD),
    ("gather_irradiance", ROWS + DIRECT_LIGHT),
    *((name, ()) for name in ("begin_row", "begin_source", "begin_if_strong", "begin_emission", "begin_reflection",
                              "begin_shot", "report_shot", "book_shot")),
    # An engine is identified by what it does; where a saved state goes to and comes from is the firmware's.
    ("mix_view", ENGINES + NEAR_FIELD),
    ("put", ()),
    ("get", ()),
    # Start-up code calls the static constructors, then main().
    ("reset_handler", ("_GLOBAL__sub_I_*",)),
    ("start", ("_GLOBAL__sub_I_*",)),
    # A picture asks the firmware for the light of its vertices, and hands it rows.
    *((name, ("read_vertex", "take_row")) for name in ("read_light", "fetch", "load", "draw", "hand_over",
                                                       "draw_picture")),
    *((name, HIGHLIGHTS) for name in ("own_light", "part", "draw_polygon", "draw_triangle")),
    *((name, ENGINES + NEAR_FIELD) for name in ("correct_row", "go_on", "shoot", "shoot_for")),
)

# Bytes that the compiler's helpers use in all, read off their disassembly and rounded up: the deepest path through
# them and what they call. Name without the leading __ or __aeabi_.
HELPERS = {
    "arm-none-eabi-": {
        r"(u?ldivmod|u?divdi3|u?moddi3)": 160, r"lmul|muldi3": 32, r"u?i?div(mod)?|u?divsi3|clz[sd]i2|l(lsl|lsr|asr)": 16,
        r"gnu_thumb1_case_\w+": 8},
    "riscv64-unknown-elf-": {r"u?divdi3|u?moddi3": 48, r"clz[sd]i2|muldi3|ashldi3|lshrdi3|ashrdi3": 16},
    "xtensa-lx106-elf-": {r"u?divdi3|u?moddi3|udivmoddi4": 160, r"u?divsi3|u?modsi3|u?mulsidi3|muldi3|clz[sd]i2": 48,
                          r"ashldi3|lshrdi3|ashrdi3": 16},
    "avr-": {r"u?divdi3|u?moddi3|muldi3": 48, r"u?divmod[hsq]i4|mulsi3|u?mulsidi3|(u|s|us|su)?mul(u|s)?hisi3": 24,
             r"(ash[lr]|lshr)[hsd]i3|(add|sub)di3(_s8)?|u?cmpdi2(_s8)?|negdi2|clz[sd]i2": 12},
}
# memcpy and its like: the boards' own, or the C library's.
MEMORY = re.compile(r"mem(cpy|move|set)|__aeabi_mem\w+")
MEMORY_BYTES = 48


def helper_bytes(title, prefix):
    if MEMORY.fullmatch(title):
        return MEMORY_BYTES
    name = re.sub(r"^__(aeabi_)?", "", title)
    for pattern, size in HELPERS.get(prefix, {}).items():
        if title.startswith("__") and re.fullmatch(pattern, name):
            return size
    return None


class Depths:
    def __init__(self, functions, prefix, unused=()):
        self.unused = unused
        self.functions, self.prefix, self.known, self.path = functions, prefix, {}, []
        self.by_name = {}
        for title, function in functions.items():
            if function.frame is not None:
                self.by_name.setdefault(demangled(title), []).append(title)

    def targets(self, caller):
        for target in sorted(caller.calls):
            if target != INDIRECT_CALL:
                yield target
                continue
            listed = [names for name, names in INDIRECT if name == demangled(caller.title)]
            if not listed:
                raise Refused(f"{demangled(caller.title)} calls through a pointer")
            for pattern in listed[0]:
                for name in fnmatch.filter(self.by_name, pattern):
                    if name != demangled(caller.title) and name not in self.unused:
                        yield from self.by_name[name]

    def of(self, title):
        """(bytes, chain of (name, frame)) below and with the function."""
        if title in self.known:
            return self.known[title]
        if title in self.path:
            chain = [demangled(t) for t in self.path[self.path.index(title):]]
            raise Refused(f"recursion: {' -> '.join(chain + [demangled(title)])}")
        function = self.functions.get(title)
        if function is None or function.frame is None:
            size = helper_bytes(title, self.prefix)
            if size is None:
                caller = demangled(self.path[-1]) if self.path else "?"
                raise Refused(f"{caller} calls {title}, of which nothing is known")
            return size, [(title, size)]
        self.path.append(title)
        deepest = max((self.of(target) for target in self.targets(function)), default=(0, []), key=lambda d: d[0])
        self.path.pop()
        self.known[title] = (function.frame + deepest[0], [(demangled(title), function.frame)] + deepest[1])
        return self.known[title]


def has_code(obj, prefix):
    done = subprocess.run([prefix + "nm", obj], capture_output=True, text=True, check=True)
    return re.search(r" [TtWw] ", done.stdout) is not None


def read_objects(objects, prefix):
    functions = {}
    for obj in objects:
        base = re.sub(r"\.(obj|o)$", "", obj)
        if os.path.exists(base + ".ci"):
            read_ci(base + ".ci", functions)
        elif prefix == "avr-":
            read_avr(obj, functions)
        elif has_code(obj, prefix):
            raise Refused(f"{obj}: no {base}.ci is there")
    return functions


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--prefix", default="", help="of the target's tools, as avr-")
    parser.add_argument("--budget", type=int, required=True, metavar="BYTES")
    parser.add_argument("--root", help="only what this function uses; default: the deepest of all")
    parser.add_argument("--leaf", action="append", default=[], metavar="NAME",
                        help="a function in assembly that uses no stack and calls nothing")
    parser.add_argument("objects", nargs="+")
    options = parser.parse_args()
    try:
        functions = read_objects(options.objects, options.prefix)
        for name in options.leaf:
            functions.setdefault(name, Function(name)).frame = 0
        is_program = options.root is not None
        unused = PAIRS if is_program or options.budget <= SMALL else ()
        unused += HIGHLIGHTS if is_program or options.prefix == "avr-" else ()
        depths = Depths(functions, options.prefix, unused)
        titles = [t for name, ts in depths.by_name.items() for t in ts
                  if options.root in (None, name) and name not in depths.unused]
        if not titles:
            raise Refused(f"no function {options.root or ''} to start from")
        size, chain = max((depths.of(title) for title in titles), key=lambda d: d[0])
    except Refused as refused:
        print(f"refused: {refused}")
        return 1
    print(f"worst-case stack: {size} bytes of {options.budget}: " + ", ".join(f"{name} {frame}" for name, frame in chain))
    return 0 if size <= options.budget else 1


if __name__ == "__main__":
    sys.exit(main())
