#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worst-case stack of the functions in object files, from what the compiler says of each frame and each call.

Beside every object lies either FILE.ci (gcc, -fcallgraph-info=su) or FILE.su (clang, -fstack-usage; the calls then
come from the object's relocations). Refused: recursion, frames of a size that is not known, calls through pointers
that are not listed, calls of functions that are neither there nor listed. Prints the deepest chain.

Exit code 0 if it fits the budget, else 1.
"""

import argparse
import os
import re
import subprocess
import sys

# What may be called through a pointer, by caller. Settings::engine is called where an eye is sampled; a firmware's
# Settings::observer is null. shoot() chooses a loop by the number of channels.
ENGINES = ("hemicube_rows", "lune_rows", "hemicube_pixels")
INDIRECT = (
    ("sample_source", ENGINES),
    ("look", ENGINES),
    ("shoot", ("scan_patches",)),
    ("scan_patches", ("scan_patches",)),
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
    "avr-": {r"u?divdi3|u?moddi3|muldi3": 48, r"u?divmod[hs]i4|u?divmodqi4|mulsi3|u?mulhisi3|umulsidi3|mulsidi3": 24,
             r"ash[lr][sd]i3|lshr[sd]i3|ash[lr]hi3|lshrhi3": 12},
}
# memcpy and its like: the boards' own, or the C library's.
MEMORY = re.compile(r"mem(cpy|move|set)|__aeabi_mem\w+")
MEMORY_BYTES = 48

RETURN_ADDRESS = {"avr-": 3}  # which the compilers for the others count themselves


class Refused(Exception):
    pass


class Function:
    def __init__(self, title, label=""):
        self.title, self.label, self.frame, self.calls = title, label or title, None, set()


def demangled(title):
    """The unqualified name in a mangled one: _ZN6fixrad12_GLOBAL__N_14lookE... -> look."""
    title = title.rsplit(":", 1)[-1]
    names, rest = [], re.sub(r"^_ZNK?", "", title)
    while match := re.match(r"L?(\d+)", rest):
        end = match.end() + int(match.group(1))
        names.append(rest[match.end():end])
        rest = rest[end:]
    return names[-1] if title.startswith("_Z") and names else title


def one_constructor(text):
    """A constructor is defined once, C2, and called C1 where it makes a whole object."""
    return re.sub(r"([CD])1E", r"\g<1>2E", text)


def read_ci(path, functions):
    with open(path, encoding="utf-8") as file:
        text = one_constructor(file.read())
    for title, label in re.findall(r'^node: \{ title: "([^"]*)" label: "([^"]*)"', text, re.MULTILINE):
        function = functions.setdefault(title, Function(title))
        usage = re.search(r"\\n(\d+) bytes \(([^)]*)\)", label)
        if usage:
            if "static" not in usage.group(2) and "bounded" not in usage.group(2):
                raise Refused(f"{demangled(title)}: the size of its frame is not known: {usage.group(2)}")
            function.frame = max(function.frame or 0, int(usage.group(1)))
    for source, target in re.findall(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', text, re.MULTILINE):
        functions.setdefault(source, Function(source)).calls.add(target)


def read_su(path, functions, prefix, obj):
    with open(path, encoding="utf-8") as file:
        for line in map(one_constructor, file):
            where, size, kind = line.rstrip("\n").split("\t")
            title = where.rsplit(":", 1)[-1]
            if kind.split(",")[0] != "static":
                raise Refused(f"{demangled(title)}: the size of its frame is not known: {kind}")
            key = local_key(obj, title)
            functions.setdefault(key, Function(key)).frame = int(size) + RETURN_ADDRESS.get(prefix, 0)
    read_calls(obj, functions, prefix)


def local_key(obj, title):
    """clang names static functions alike in several objects."""
    return f"{obj}:{title}" if "_GLOBAL__N_" in title or not title.startswith("_Z") else title


def read_calls(obj, functions, prefix):
    done = subprocess.run([prefix + "objdump", "-dr", obj], capture_output=True, text=True, check=True)
    at_section, section, caller, pending = {}, "", None, None
    lines = one_constructor(done.stdout).splitlines()
    for line in lines:
        if match := re.match(r"Disassembly of section (\S+):", line):
            section = match.group(1)
        elif match := re.match(r"([0-9a-f]+) <(\S+)>:", line):
            at_section[(section, int(match.group(1), 16))] = match.group(2)
    for line in lines:
        if match := re.match(r"Disassembly of section (\S+):", line):
            section = match.group(1)
        elif match := re.match(r"[0-9a-f]+ <(\S+)>:", line):
            caller = functions.setdefault(local_key(obj, match.group(1)), Function(local_key(obj, match.group(1))))
        elif match := re.match(r"\s+[0-9a-f]+:\s+(?:[0-9a-f]{2} )+\s+(\S+)", line):
            pending = match.group(1)
            if pending in ("icall", "eicall", "ijmp", "eijmp"):
                caller.calls.add("__indirect_call")
        elif (match := re.match(r"\s+[0-9a-f]+: R_AVR_(CALL|13_PCREL)\s+(\S+)", line)) and pending in (
                "call", "rcall", "jmp", "rjmp"):
            name, _, offset = match.group(2).partition("+")
            target = at_section.get((name, int(offset or "0", 16)), name)
            # A jump inside the function is no call.
            if name.startswith(".") and (name, int(offset or "0", 16)) not in at_section:
                continue
            if local_key(obj, target) != caller.title or pending in ("call", "rcall"):
                caller.calls.add(local_key(obj, target) if local_key(obj, target) in functions else target)


def helper_bytes(title, prefix):
    if MEMORY.fullmatch(title):
        return MEMORY_BYTES
    name = re.sub(r"^__(aeabi_)?", "", title)
    for pattern, size in HELPERS.get(prefix, {}).items():
        if title.startswith("__") and re.fullmatch(pattern, name):
            return size + RETURN_ADDRESS.get(prefix, 0)
    return None


class Depths:
    def __init__(self, functions, prefix):
        self.functions, self.prefix, self.known, self.path = functions, prefix, {}, []
        self.by_name = {}
        for title, function in functions.items():
            if function.frame is not None:
                self.by_name.setdefault(demangled(title), []).append(title)

    def targets(self, caller):
        for target in sorted(caller.calls):
            if target != "__indirect_call":
                yield target
                continue
            listed = [names for name, names in INDIRECT if name == demangled(caller.title)]
            if not listed:
                raise Refused(f"{demangled(caller.title)} calls through a pointer")
            for name in listed[0]:
                if name != demangled(caller.title):
                    yield from self.by_name.get(name, [])

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
        elif os.path.exists(base + ".su"):
            read_su(base + ".su", functions, prefix, obj)
        elif has_code(obj, prefix):
            raise Refused(f"{obj}: neither {base}.ci nor {base}.su is there")
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
        depths = Depths(functions, options.prefix)
        titles = [t for name, ts in depths.by_name.items() for t in ts if options.root in (None, name)]
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
