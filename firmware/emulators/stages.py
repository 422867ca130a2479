#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Says in which stage of the solver a program has spent its instructions (AVR: cycles).

An address belongs to the stage of the innermost inlined frame that lies in a source file of RULES; helpers that are
inlined everywhere (lib/fixed) count for who uses them. Addresses without such a frame go by the name of their function:
routines of libgcc and what a compiler calls to copy.

Where no frame says it, an address goes with the one before it in its function.
"""

import argparse
import bisect
import json
import re
import subprocess
import sys

import elf_symbols

# (file, function or None, stage); the first that fits. The float peer has the same files in a folder of its own.
RULES = [(re.compile(file), re.compile(function) if function else None, stage) for file, function, stage in [
    (r"(lib/form_factor|float_peer)/(view|eye)\.", None, "transform"),
    (r"(lib/form_factor|float_peer)/(scanline|row_plane)\.", None, "raster"),
    (r"(lib/form_factor|float_peer)/spans\.", None, "insert"),
    (r"lib/form_factor/(split|row|delta_table|lune_tables)\.|float_peer/(split|lune_table)\.", None, "split"),
    (r"(lib/form_factor|float_peer)/(rows|row_sampling|lunes|pixels|hidden_share)\.", None, "rows"),
    (r"lib/transport/sampling\.|lib/elements/|float_peer/sampling\.", None, "sampling"),
    (r"(lib/transport|float_peer)/unshot\.", None, "search"),
    (r"(lib/transport|float_peer)/(shooting|state)\.|lib/fixed/cutter\.", None, "distribute"),
    (r"lib/transport/gathering\.", None, "gathering"),
    (r"lib/vertices/|float_peer/vert", None, "vertex"),
    (r"lib/scene/", None, "load"),
    (r"lib/", None, "other of lib"),
    (r"boards/.*/rom_float\.", None, "float"),
]]
SYMBOLS = [(re.compile(pattern), stage) for pattern, stage in [
    (r"^__aeabi_(f|cf|i2f|ui2f|l2f|ul2f|d|i2d|ui2d)|[sd]f([23](x|_pse)?|[sd]i|[sd]f)?$|^__float|^__fix|_?fp_|^__fp", "float"),
    (r"div|mod", "division"),
    (r"mul", "multiplication"),
    (r"lasr|llsl|llsr|ash[lr]|lshr|clz|ctz", "shifts"),
    (r"(add|sub)di3|cmp[sd]i2|neg[sd]i2", "wide sums"),
    (r"^mem(cpy|move|set)$|^__(prologue|epilogue)", "copying"),
]]
ORDER = ["transform", "raster", "insert", "split", "rows", "sampling", "search", "distribute", "gathering", "vertex",
         "load", "other of lib", "multiplication", "division", "shifts", "wide sums", "float", "copying", "other"]


def frames_of(addresses, elf, prefix):
    """{address: [(function, file), innermost first]} by one run of addr2line."""
    command = [prefix + "addr2line", "-a", "-i", "-f", "-C", "-e", elf]
    text = subprocess.run(command, input="\n".join(hex(a) for a in addresses), capture_output=True, text=True,
                          check=True).stdout
    result, frames, lines = {}, None, iter(text.splitlines())
    for line in lines:
        if re.fullmatch(r"0x[0-9a-f]+", line):
            frames = result.setdefault(int(line, 16), [])
        else:
            frames.append((line, next(lines)))
    return result


def stage_by_file(frames):
    for function, file in frames:
        if "/lib/fixed/" in file and "cutter" not in file:
            continue
        for file_rule, function_rule, stage in RULES:
            if file_rule.search(file) and (not function_rule or any(function_rule.search(f) for f, _ in frames)):
                return stage
    return None


def function_names(elf):
    """A function from an address to the name of the symbol that covers it."""
    found = sorted((value & ~1, name) for name, value, _ in elf_symbols.symbols(elf) if not name.startswith(("$", ".")))
    starts = [value for value, _ in found]

    def name_of(address):
        i = bisect.bisect_right(starts, address) - 1
        while i > 0 and starts[i - 1] == starts[i]:
            i -= 1
        return found[i][1] if i >= 0 else ""
    return name_of


def stage_by_symbol(name):
    for pattern, stage in SYMBOLS:
        if pattern.search(name):
            return stage
    return "other"


def stages(counts, elf, prefix):
    """{stage: count} of {address: count}."""
    frames = frames_of(sorted(counts), elf, prefix)
    name_of = function_names(elf)
    total, last = {}, {}
    for address, count in sorted(counts.items()):
        name = name_of(address)
        stage = last[name] = stage_by_file(frames.get(address, [])) or last.get(name) or stage_by_symbol(name)
        total[stage] = total.get(stage, 0) + count
    return {stage: total[stage] for stage in ORDER if stage in total}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("counts", help="what run.py --counts has written")
    parser.add_argument("elf", help="the program, with debug information")
    parser.add_argument("--region", default="solve", help="which region of the program (default: solve)")
    parser.add_argument("--prefix", required=True, help="of the binutils, such as arm-none-eabi-")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    parser.add_argument("--require", nargs="+", default=[], metavar="STAGE", help="fail unless each has been executed")
    options = parser.parse_args()
    with open(options.counts, encoding="utf-8") as file:
        measured = json.load(file)
    if options.region not in measured["regions"]:
        print(f"stages.py: no region {options.region}; there are {', '.join(measured['regions'])}", file=sys.stderr)
        return 1
    region = measured["regions"][options.region]
    result = stages({int(at, 16): count for at, count in region["by_pc"].items()}, options.elf, options.prefix)
    missing = [stage for stage in options.require if stage not in result]
    if missing:
        print(f"stages.py: nothing executed in: {', '.join(missing)}; a rule fits no file", file=sys.stderr)
        return 1
    if options.json:
        print(json.dumps({"unit": measured["unit"], "count": region["count"], "stages": result}, indent=1))
        return 0
    for stage, count in result.items():
        print(f"{stage:16} {count:14,} {100 * count / region['count']:6.1f} %")
    print(f"{'all':16} {region['count']:14,} {measured['unit']}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
