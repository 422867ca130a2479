#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure engines and resolutions that no committed scene of the firmware uses, on all targets, and write
host_sim/sweep/calibration.json: what scripts/fit_costs.py fits the cost of their steps to.

    scripts/measure_engines.py [PRESET]...    all targets, or only these; what is known of the others stays

Needs build/host/fixrad and count_work. Works on a copy of the sources in build/engines, since the programs' scenes are
listed in the sources. Takes about a minute a target. Run it when the inner loops of an engine have changed, then
scripts/fit_costs.py.
"""

import json
import shutil
import subprocess
import sys

import measure_targets
from measure_targets import Failure, commands_of, measure_scene, run, target_presets, write

ROOT = measure_targets.ROOT
COPY = ROOT / "build/engines"
CALIBRATION = ROOT / "host_sim/sweep/calibration.json"
TOOL = ROOT / "build/host/fixrad"
COUNT = ROOT / "build/host/host_sim/cli/count_work"

# Name: scene, engine, R, further options. The first fit every board, the others need the profile `small`.
EVERYWHERE = {
    "cornell_pixels": ("cornell", "pixels", 16, []),
    "cornell_grey_pixels": ("cornell_grey", "pixels", 8, []),
    "closed_box_pixels": ("closed_box", "pixels", 16, []),
    "cornell_rows": ("cornell", "rows", 16, []),
    "closed_box_rows": ("closed_box", "rows", 8, []),
}
LARGER = {
    "colonnade_rows": ("colonnade", "rows", 8, ["--unshot", "0.01"]),
    "cornell_pixels32": ("cornell", "pixels", 32, []),
    "cornell_lunes64": ("cornell", "lunes", 64, ["--flux-per-row", "0.00004"]),
}


def runs_on(profile):
    return EVERYWHERE if profile == "tiny" else {**EVERYWHERE, **LARGER}


def options_of(profile, run_of):
    _, engine, resolution, further = run_of
    return ["--profile", profile, "--engine", engine, "--resolution", str(resolution), *further]


def copy_sources():
    """The sources with firmware/scenes.cmake listing these runs, one profile a board."""
    shutil.rmtree(COPY, ignore_errors=True)
    shutil.copytree(ROOT, COPY, ignore=shutil.ignore_patterns("build", "out", ".git", "node_modules"))
    listing = COPY / "firmware/scenes.cmake"
    text = listing.read_text()
    for scenes, names in (("tiny", EVERYWHERE), ("larger", {**EVERYWHERE, **LARGER})):
        text = text.replace(f"set(FIXRAD_SCENES_{scenes} ", f"set(FIXRAD_SCENES_{scenes} {' '.join(names)} ")
    for second in ("medium", "large"):
        text = text.replace(f" small {second})", " small)")
    listing.write_text(text)


def export(profile, known):
    """Writes the scenes' headers into the copy; {name: record} with what is known of the targets."""
    records = {}
    for name, run_of in runs_on(profile).items():
        full, scene, options = f"{name}_{profile}", ROOT / f"scenes/{run_of[0]}.obj", options_of(profile, run_of)
        run(TOOL, "--quiet", "export", scene, *options, "-o", COPY / f"firmware/scenes/{full}.h")
        counted = json.loads(run(COUNT, scene, *options))
        is_known = known.get(full, {}).get("work") == counted["work"]
        records[full] = {"scene": run_of[0], "options": options, **counted,
                         "solve": known[full]["solve"] if is_known else {}}
    return records


def measure(preset, board, records):
    profile = "tiny" if board == "atmega2560" else "small"
    names = [f"{name}_{profile}" for name in runs_on(profile)]
    run("cmake", "--fresh", "--preset", preset)
    run("cmake", "--build", "--preset", preset, "--target", *[f"solve_{name}" for name in names])
    commands = commands_of(preset)
    for name in names:
        solved = measure_scene(preset, name, commands[f"Solve.{name}.GivesTheBitsOfTheHost"])
        records[name]["solve"][preset] = solved["solve"]


def main():
    presets = target_presets()
    unknown = set(sys.argv[1:]) - set(presets)
    if unknown:
        sys.exit(f"measure_engines: no such target: {', '.join(sorted(unknown))}\n{__doc__}")
    try:
        known = json.loads(CALIBRATION.read_text())["runs"] if CALIBRATION.exists() else {}
        copy_sources()
        records = {**export("tiny", known), **export("small", known)}
        measure_targets.ROOT = COPY
        for preset in sys.argv[1:] or presets:
            measure(preset, presets[preset][1], records)
            write(CALIBRATION, json.dumps({"runs": records}, indent=1) + "\n")
    except (Failure, OSError, KeyError, subprocess.SubprocessError) as error:
        sys.exit(f"measure_engines: {type(error).__name__}: {error}")


if __name__ == "__main__":
    main()
