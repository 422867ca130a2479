#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program in the emulator of its board.

The program's console goes to stdout and its exit code becomes this one's; 101 is a fault of the program, 124 a
program that did not end in time, 125 an emulator that is missing or failed.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

import elf_symbols

OUT_OF_TIME = 124
NO_EMULATOR = 125

ARM = ["qemu-system-arm", "-nographic", "-monitor", "none", "-serial", "none", "-chardev", "stdio,id=console",
       "-semihosting-config", "enable=on,target=native,chardev=console"]
BOARDS = {
    "microbit": ARM + ["-M", "microbit"],
    "mps2-an385": ARM + ["-M", "mps2-an385"],
    "mps2-an386": ARM + ["-M", "mps2-an386"],
    "mps2-an500": ARM + ["-M", "mps2-an500"],
    "rv32-virt": ["qemu-system-riscv32", "-M", "virt", "-bios", "none", "-nographic", "-monitor", "none",
                  "-serial", "stdio"],
    "esp8266-sim": ["qemu-system-xtensa", "-M", "sim", "-cpu", "lx106", "-nographic", "-monitor", "none", "-serial",
                    "none", "-semihosting"],
    "atmega2560": ["simavr_run"],
}


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--board", required=True, choices=sorted(BOARDS))
    parser.add_argument("--helper", required=True, metavar="FILE",
                        help="the counting plugin, or for AVR the simulator, that the build has made")
    parser.add_argument("--counts", metavar="FILE", help="write what was executed at each address, by region (JSON)")
    parser.add_argument("--limit", type=float, default=600, metavar="SECONDS", help="end the program after this time")
    parser.add_argument("--max-cycles", type=int, default=20_000_000_000, help="the same in cycles (AVR only)")
    parser.add_argument("--expect-exit", type=int, metavar="CODE",
                        help="succeed if the program ends with this code, fail otherwise")
    parser.add_argument("--expect-output", metavar="REGEX", help="fail unless the console matches")
    parser.add_argument("--check", action="store_true", help="only see whether the emulator is installed")
    parser.add_argument("elf", nargs="?")
    options = parser.parse_args()
    if not options.check and not options.elf:
        parser.error("which program?")
    return options


def fail(text, code=NO_EMULATOR):
    sys.stdout.flush()
    print(f"run.py: {text}", file=sys.stderr)
    sys.exit(code)


def check_emulator(board):
    program = BOARDS[board][0]
    if program != "simavr_run" and not shutil.which(program):
        fail(f"{program} is not installed; it runs the programs for {board} (scripts/install_packages.sh targets)")


def counting(options, is_thumb):
    found = elf_symbols.regions(options.elf, is_thumb)
    return [f"out={options.counts}"] + [f"region={name}@{address:x}" for name, address in found]


def command(options):
    if options.board == "atmega2560":
        line = [options.helper, "atmega2560", options.elf, str(options.max_cycles)]
        return line + (counting(options, False) if options.counts else [])
    line = list(BOARDS[options.board])
    if options.counts:
        arguments = counting(options, line[0] == "qemu-system-arm")
        if any("," in argument for argument in arguments):
            fail(f"QEMU takes no comma in a file's name: {options.counts}")
        line += ["-plugin", ",".join([options.helper] + arguments)]
    return line + ["-kernel", options.elf]


def run(options):
    """Returns (exit code, console). The console is shown as it comes, but for what a test compares."""
    keeps = options.expect_output is not None
    with tempfile.TemporaryFile() as console:
        try:
            done = subprocess.run(command(options), stdin=subprocess.DEVNULL, stdout=console if keeps else None,
                                  timeout=options.limit, check=False)
            code = done.returncode
        except subprocess.TimeoutExpired:
            print(f"run.py: {options.elf}: not finished after {options.limit:g} s", file=sys.stderr)
            code = OUT_OF_TIME
        except OSError as error:
            fail(f"cannot start the emulator: {error}")
        if not keeps:
            return code, ""
        console.seek(0)
        text = console.read().decode(errors="replace")
    sys.stdout.write(text)
    return code, text


def main():
    options = parse()
    check_emulator(options.board)
    if options.check:
        return 0
    if not os.path.exists(options.elf):
        fail(f"no such program: {options.elf}")
    if options.counts and os.path.exists(options.counts):
        os.remove(options.counts)
    code, console = run(options)
    if options.counts and not os.path.exists(options.counts):
        fail(f"{options.counts} was not written: the emulator failed (its exit code is {code})")
    if code < 0:
        fail(f"the emulator was ended by signal {-code}")
    if options.expect_output is not None and not re.search(options.expect_output, console, re.MULTILINE):
        fail(f"the console does not match {options.expect_output!r}", 1)
    if options.expect_exit is None:
        return code
    if code != options.expect_exit:
        fail(f"exit code {code} instead of {options.expect_exit}", 1)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (elf_symbols.ElfError, OSError) as failure:
        fail(str(failure))
