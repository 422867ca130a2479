#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares a target's programs with firmware/measurements.json: the count of one region, which may differ by two per
cent, and the RAM of every solver, which may not differ. Exit code 0 if they agree."""

import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
from program_sizes import sizes  # noqa: E402

TOLERANCE = 0.02


def differences(measured, preset, scene, count, rams):
    """Lines that say what differs. rams: {scene: bytes} of this build."""
    target = measured["targets"].get(preset)
    if target is None:
        return [f"{preset} has not been measured"]
    lines = [f"{name}: {target['scenes'].get(name, {}).get('ram')} bytes of RAM were measured, the program has {ram}"
             for name, ram in rams.items() if target["scenes"].get(name, {}).get("ram") != ram]
    known = target["bench"].get(scene, {}).get("core", {}).get("solve", 0)
    if abs(count - known) > TOLERANCE * known:
        lines.append(f"{scene}: {known:,} were measured, this build takes {count:,}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--measurements", default=ROOT / "firmware/measurements.json")
    parser.add_argument("--preset", required=True)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--counts", required=True, help="what run.py --counts has written")
    parser.add_argument("--programs", required=True, help="the folder of solve_<scene>.elf")
    options = parser.parse_args()
    measured = json.loads(pathlib.Path(options.measurements).read_text())
    count = json.loads(pathlib.Path(options.counts).read_text())["regions"]["core_solve"]["count"]
    programs = sorted(pathlib.Path(options.programs).glob("solve_*.elf"))
    rams = {p.stem[len("solve_"):]: sizes(p, p.stem[len("solve_"):])["ram"] for p in programs if "flipped" not in p.stem}
    lines = differences(measured, options.preset, options.scene, count, rams)
    if not rams:
        lines.append(f"no program in {options.programs}")
    print("\n".join(lines + ["run scripts/measure_targets.py"]) if lines else
          f"{options.scene}: {count:,} and {len(rams)} solvers as measured")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
