#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Solve the hard cases in fixed point, double and float, check properties of random scenes, and write docs/stability.md.

    scripts/measure_stability.py                  everything, with the programs of build/host; half an hour on two cores
    scripts/measure_stability.py --build FOLDER   those of another build
    scripts/measure_stability.py --cases FILE     what measure_stability has printed before, instead of running it
    scripts/measure_stability.py --scenes FILE    what check_scenes has printed before, likewise
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

from stability_page import page

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "stability.md"
SCENES = {"KeepsItsBooks": 100000}  # of each property
SCENES_OF_OTHERS = 1000
LINE = re.compile(r"(\w+): seeds (\d+) to (\d+), (\d+) of them closed rooms: (all keep to it|FAILED)")


def run(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{program}: {done.stderr.strip() or 'failed'}; build it first: cmake --build --preset host")
    return done.stdout


def run_scenes(program):
    names = re.findall(r"^(\w+):", run(program, "--count", "1"), re.MULTILINE)
    return "".join(run(program, "--property", name, "--count", str(SCENES.get(name, SCENES_OF_OTHERS))) for name in names)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(ROOT / "build" / "host"), help="build folder")
    parser.add_argument("--cases", help="output of measure_stability")
    parser.add_argument("--scenes", help="output of check_scenes")
    options = parser.parse_args()
    programs = pathlib.Path(options.build) / "tests" / "stability"
    cases = pathlib.Path(options.cases).read_text() if options.cases else run(programs / "measure_stability")
    scenes = pathlib.Path(options.scenes).read_text() if options.scenes else run_scenes(programs / "check_scenes")
    claims = dict(line.split("\t", 1) for line in run(programs / "check_scenes", "--list").splitlines())
    rows = [(name, claims[name], int(last) - int(first) + 1, int(closed), verdict == "all keep to it")
            for name, first, last, closed, verdict in LINE.findall(scenes)]
    bounds = json.loads(run(programs / "measure_stability", "--bounds"))
    PAGE.write_text(page(json.loads(cases), bounds, rows))
    broken = [c["name"] for c in json.loads(cases) if not all(f["holds"] for f in c["fixed"]["findings"])]
    return 1 if broken or not all(row[-1] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
