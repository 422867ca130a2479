#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs a program that prints the state that it saves, and compares the bytes with a committed file.

The lines are "saved_bytes COUNT" and "saved OFFSET 16_HEX_DIGITS", the last one filled up with zeros. Exit code: the
program's if it is not 0, 1 if the bytes differ.
"""

import argparse
import subprocess
import sys


def printed(console):
    lines = [line.split() for line in console.splitlines()]
    counts = [int(words[1]) for words in lines if words and words[0] == "saved_bytes"]
    data = b"".join(bytes.fromhex(words[2]) for words in lines if len(words) == 3 and words[0] == "saved")
    return data[:counts[0]] if counts and len(data) >= counts[0] else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--saved", required=True, metavar="FILE", help="what the program must save")
    parser.add_argument("--write", metavar="FILE", help="write what it saves to this file, too")
    parser.add_argument("command", nargs="+")
    options = parser.parse_args()
    done = subprocess.run(options.command, stdout=subprocess.PIPE, text=True, check=False)
    found = printed(done.stdout)
    sys.stdout.write("\n".join(line for line in done.stdout.splitlines() if not line.startswith("saved ")) + "\n")
    if done.returncode != 0:
        return done.returncode
    if found is None:
        print("the program prints no saved state")
        return 1
    if options.write:
        with open(options.write, "wb") as file:
            file.write(found)
    with open(options.saved, "rb") as file:
        wanted = file.read()
    if found != wanted:
        at = next((i for i, (a, b) in enumerate(zip(found, wanted)) if a != b), min(len(found), len(wanted)))
        print(f"{options.saved}: {len(wanted)} bytes, the program saves {len(found)}; they differ from byte {at} on")
        return 1
    print(f"saved state equal to {options.saved}, {len(found)} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
