#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if a function compiled for AVR takes arguments on the stack.

clang looks for them behind a return address of two bytes; on a chip with more than 128 KB of flash it has three, and
every such argument is read one byte off. Arguments that fit the registers (18 bytes, each rounded up to two) are safe.

usage: check_avr_arguments.py BUILD_FOLDER    (which holds compile_commands.json)
"""

import json
import os
import re
import shlex
import subprocess
import sys

STOP = ["-w", "-S", "-o", "-", "-mllvm", "-stop-after=finalize-isel"]


def machine_code(entry):
    """What the compiler makes of one source, as text, up to where arguments have got their places."""
    # What follows && repairs the object file.
    line = shlex.split(entry["command"].split("&&")[0])
    kept = [word for i, word in enumerate(line) if word not in ("-o", "-c") and line[i - 1] != "-o"]
    done = subprocess.run(kept + STOP, cwd=entry["directory"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{entry['file']}: does not compile:\n{done.stderr}")
    return done.stdout


def functions_with_stack_arguments(text):
    """Returns (functions seen, names of those with arguments on the stack)."""
    seen, found = 0, []
    for function in re.split(r"^name: +", text, flags=re.MULTILINE)[1:]:
        seen += 1
        if not re.search(r"^fixedStack: +\[\]$", function, flags=re.MULTILINE):
            found.append(function.split("\n", 1)[0].strip("'\" "))
    return seen, found


def main():
    if len(sys.argv) != 2:
        print(__doc__.rsplit("\n\n", 1)[1].strip(), file=sys.stderr)
        return 2
    with open(os.path.join(sys.argv[1], "compile_commands.json"), encoding="utf-8") as file:
        entries = [entry for entry in json.load(file) if entry["file"].endswith(".cpp")]
    total, bad = 0, 0
    for entry in entries:
        seen, found = functions_with_stack_arguments(machine_code(entry))
        total += seen
        bad += len(found)
        for name in found:
            print(f"{entry['file']}: {name} takes arguments on the stack, where clang for AVR misreads them")
    print(f"{total} functions in {len(entries)} files, {bad} with arguments on the stack")
    return 1 if bad or total == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
