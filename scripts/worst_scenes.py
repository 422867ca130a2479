#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Search for scenes on which a Cortex-M0 takes longest: for one unit of a shot (worst_row) and for a whole step
(worst_step). Writes scenes/worst/NAME.obj and .mtl.

    scripts/worst_scenes.py NAME [--tries N] [--seed N] [--tool PATH]

A scene is a room without a front wall, so that backs count, and panels in it that hide and pierce each other; two of
them are lamps. Hill climbing: some panels are changed, and the scene is kept if the emulator counts more instructions
in the largest call. What is counted is firmware/apps/slices, linked with the scene as it would be for the board, so
there is no model between the search and the figure. The same seed gives the same scene.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

from random_rooms import Dice

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/cortex-m0"
WORK = BUILD / "worst_scenes"
LIKE = "cornell_small"  # whose program's commands are used
ROOM = 4000             # mm
OPTIONS = {
    "worst_row": "--elements 160 --unshot 0.2 --flux-per-row 0.001 --flux-per-eye 0.2",
    "worst_step": "--elements 160 --unshot 0.2 --flux-per-row 0.0002 --flux-per-eye 0.004"}
REGIONS = {"worst_row": ("sample",), "worst_step": ("step",)}
PANELS = 18


def panel(dice):
    """A parallelogram: a corner and two sides, mm."""
    corner = [dice.between(200, ROOM - 200) for _ in range(3)]
    sides = [[dice.between(-ROOM // 2, ROOM // 2) for _ in range(3)] for _ in range(2)]
    return [corner, *sides]


def corners(shape):
    p, a, b = shape
    return [p, [x + y for x, y in zip(p, a)], [x + y + z for x, y, z in zip(p, a, b)], [x + z for x, z in zip(p, b)]]


def fits(shape):
    a, b = shape[1:]
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return sum(c * c for c in cross) > 10 ** 10 and all(50 <= x <= ROOM - 50 for p in corners(shape) for x in p)


def fresh_panel(dice):
    while True:
        shape = panel(dice)
        if fits(shape):
            return shape


def slats_before_panels():
    """Half of the panels side by side, the others behind all of them: each of these meets every span of a row."""
    half = PANELS // 2
    pitch = (ROOM - 400) // half
    slats = [[[200 + pitch * i, 800, 2000], [0, 2400, 0], [pitch // 2, 0, 10 * i]] for i in range(half)]
    behind = [[[300, 400 + 40 * j, 2300 + 90 * j], [0, 2800, 60 * (j % 3)], [3300, 0, 40 * (j % 4)]] for j in range(PANELS - half)]
    return slats + behind


def changed(dice, shapes):
    """One to three panels moved a little, or replaced."""
    shapes = [[list(v) for v in shape] for shape in shapes]
    for _ in range(dice.between(1, 3)):
        i = dice.between(0, len(shapes) - 1)
        if dice.chance(40):
            shapes[i] = fresh_panel(dice)
            continue
        moved = [[x + dice.between(-400, 400) for x in v] for v in shapes[i]]
        if fits(moved):
            shapes[i] = moved
    return shapes


def write(path, shapes):
    low, high = 0, ROOM
    walls = [[(low, low, low), (low, low, high), (high, low, high), (high, low, low)],
             [(low, high, low), (high, high, low), (high, high, high), (low, high, high)],
             [(low, low, low), (low, high, low), (low, high, high), (low, low, high)],
             [(high, low, low), (high, low, high), (high, high, high), (high, high, low)],
             [(low, low, low), (high, low, low), (high, high, low), (low, high, low)]]
    faces = [("wall", w) for w in walls]
    faces += [("lamp" if i < 2 else "panel", corners(s)) for i, s in enumerate(shapes)]
    lines = [f"# Made by scripts/worst_scenes.py {path.stem}; do not edit.", f"mtllib {path.stem}.mtl"]
    count = 0
    for material, face in faces:
        lines += [f"v {x / 1000:.3f} {y / 1000:.3f} {z / 1000:.3f}" for x, y, z in face]
        lines += [f"usemtl {material}", "f " + " ".join(str(count + k) for k in range(1, 5))]
        count += 4
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")
    path.with_suffix(".mtl").write_text(
        "newmtl wall\nKd 0.7 0.6 0.5\nnewmtl panel\nKd 0.5 0.6 0.7\nnewmtl lamp\nKd 0.2 0.2 0.2\nKe 9 8 7\n")


def commands(folder):
    """Those that compile and link the program of LIKE, for the candidate."""
    done = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", f"firmware/apps/slices/slices_{LIKE}.elf"],
                          capture_output=True, text=True, check=True)
    lines = [line for line in done.stdout.splitlines() if f"slices_{LIKE}" in line]
    lines = [re.sub(r'FIXRAD_SCENE_HEADER=\S+', r'FIXRAD_SCENE_HEADER=\\"candidate.h\\"', line) for line in lines]
    lines = [line.replace(f"FIXRAD_SCENE={LIKE}", "FIXRAD_SCENE=candidate -DFIXRAD_PROBES") for line in lines]
    return [line.replace(f"slices_{LIKE}.dir/main.cpp.obj", "candidate.obj").replace(f"slices_{LIKE}.elf", "candidate.elf")
            .replace("firmware/apps/slices/CMakeFiles/candidate.obj", f"{folder}/candidate.obj")
            .replace("firmware/apps/slices/candidate.elf", f"{folder}/candidate.elf")
            .replace(" -c ", f" -I{folder} -c ") for line in lines]


def score(name, tool, shapes, folder, build):
    """Instructions of the largest call; 0 for a scene that does not fit or has a row of too many spans."""
    write(folder / "candidate.obj", shapes)
    steps = [([str(tool), "--quiet", "export", str(folder / "candidate.obj"), "--profile", "small", *OPTIONS[name].split(),
               "-o", str(folder / "candidate.h")], False), *((command, True) for command in build),
             ([sys.executable, "-B", str(ROOT / "firmware/emulators/run.py"), "--board", "microbit", "--helper",
               str(BUILD / "firmware/emulators/count_plugin.so"), "--expect-exit", "0", "--counts", str(folder / "counts.json"),
               str(folder / "candidate.elf")], False)]
    for command, shell in steps:
        if subprocess.run(command, shell=shell, cwd=BUILD, capture_output=True, check=False).returncode != 0:
            return 0
    regions = json.loads((folder / "counts.json").read_text())["regions"]
    return max(regions[region]["largest"] for region in REGIONS[name])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", choices=sorted(OPTIONS))
    parser.add_argument("--tries", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tool", type=pathlib.Path, default=ROOT / "build/host/fixrad")
    options = parser.parse_args()
    dice = Dice(options.seed)
    tool, folder = options.tool.resolve(), WORK / options.name
    build = commands(folder)
    best, most = slats_before_panels(), 0
    for attempt in range(options.tries):
        tried = best if attempt == 0 else changed(dice, best)
        count = score(options.name, tool, tried, folder, build)
        if count > most:
            best, most = tried, count
            write(ROOT / f"scenes/worst/{options.name}.obj", best)
            print(f"{attempt}: {most:,} instructions", flush=True)


if __name__ == "__main__":
    main()
