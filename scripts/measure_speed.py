#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure what accuracy costs on the host and write docs/speed.md: the integer core against shooting by ray casting at
equal error, and the cost of one shot as the mesh grows.

    scripts/measure_speed.py                   some minutes; builds the benchmark in build/host first
    scripts/measure_speed.py --bench PATH      another build of fixrad_bench
    scripts/measure_speed.py --results FILE    keep the benchmark's own JSON there; if it exists, only write the page
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/speed.md"
CORE, RAYS, KEPT, SHOT = "BM_CornellByCore", "BM_CornellByRays", "BM_CornellByRaysKept", "BM_ShotOfHostProfile"
ERRORS = (1.2, 1.0, 0.75, 0.5, 0.4, 0.3)  # per cent, at which speeds are compared
BAR_SLOPE = 0.7

HEAD = """# Speed on the host

Made by `scripts/measure_speed.py`; do not edit. One thread; times are the solvers' alone, the fastest of up to four
runs, on the machine that ran the script. Figures of the Cornell box are means over three meshes of about the same size,
since one mesh proves nothing. Error: face means against path-traced truth, mean weighted by area.
"""

EQUAL = """
## Equal error: the core against ray casting

The yardstick is progressive shooting in double with form factors by ray casting on Embree
([ray_cast_shooting.h](../host_sim/reference/ray_cast_shooting.h)), with overshooting as in the core, n stratified
rays a pair of elements, in packets. *Anew* casts the rays of each shot, in memory that grows with the elements, as
the core does; *kept* stores every pair once it is known, 4 bytes times the square of the elements, and uses it in
both directions. *Same mesh* is the core's; *cut mesh* is cut where faces touch
([contact_lines.h](../host_sim/meshing/contact_lines.h)), which removes most of the mesh error of the Cornell box: on
the core's mesh, elements that lie across the foot of a block carry light under it. The core's choice of eye points
avoids much of that, rays between areas do not. So the same mesh compares whole methods, the cut mesh the cost of
visibility alone. Times stand on each method's frontier, the fastest of its settings for an error (interpolated
between two settings, logarithms of both); ratios are times over the core's. The bar, on the same mesh, is 10.
"""

SHOTS = """
## One shot, from 200 to 3,200 elements

Profile host, lune rows. The slope is that of a straight line through the logarithms (least squares); 0 would mean that
a shot costs the same on any mesh, 1 that it grows as the elements do. The bar is 0.7.
"""

METHODS = (("same mesh, anew", RAYS, "0"), ("same mesh, kept", KEPT, "0"), ("cut mesh, anew", RAYS, "1"),
           ("cut mesh, kept", KEPT, "1"))

ALL = """
## All settings measured

| method | elements | setting | shots | error % | ms |
| --- | ---: | --- | ---: | ---: | ---: |
"""


class Failure(Exception):
    """A command ended as it should not."""


def run(*command):
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")


def benchmark(bench, results):
    """The records of the benchmark: a dictionary each, with what its name says under `family` and `arguments`."""
    if not results.exists():
        run(bench, "--benchmark_filter=^BM_(CornellBy|ShotOfHostProfile)", f"--benchmark_out={results}")
    records = json.loads(results.read_text())["benchmarks"]
    for record in records:
        family, *arguments = record["name"].split("/")
        record["family"] = family
        record["arguments"] = dict(a.split(":") for a in arguments if ":" in a and not a.startswith("iterations"))
    return records


def frontier(records, family, cut=None):
    """(error, milliseconds) of the settings that no other beats in both, most accurate last."""
    points = sorted((r["real_time"], r["error_percent"]) for r in records
                    if r["family"] == family and r["arguments"].get("cut") == cut)
    best = []
    for milliseconds, error in points:
        if not best or error < best[-1][0]:
            best.append((error, milliseconds))
    return best


def time_at(line, error):
    """Milliseconds to reach an error on a frontier; None beyond its ends."""
    for (coarse, fast), (fine, slow) in zip(line, line[1:]):
        if fine <= error <= coarse:
            part = math.log(error / coarse) / math.log(fine / coarse)
            return fast * (slow / fast) ** part
    return None


def cell(value, form):
    return "–" if value is None else form.format(value)


def equal_error(records):
    core = frontier(records, CORE)
    others = [(name, frontier(records, family, cut)) for name, family, cut in METHODS]
    text = "\n| error % | core ms |" + "".join(f" {name} ms | ratio |" for name, _ in others)
    text += "\n|" + " ---: |" * (2 + 2 * len(others)) + "\n"
    for error in ERRORS:
        mine = time_at(core, error)
        text += f"| {error:g} | {cell(mine, '{:.1f}')} |"
        for _, line in others:
            theirs = time_at(line, error)
            text += f" {cell(theirs, '{:.0f}')} | {cell(theirs / mine if mine and theirs else None, '{:.1f}')} |"
        text += "\n"
    best = [("core", core), *others]
    return text + "\nBest error measured: " + "; ".join(
        f"{name} {line[-1][0]:.2f} % in {line[-1][1]:.0f} ms" for name, line in best) + ".\n"


def slope(xs, ys):
    x_mean, y_mean = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys)) / sum((x - x_mean) ** 2 for x in xs)


def shots(records):
    mine = [r for r in records if r["family"] == SHOT]
    text = "\n| elements | R | shots | eye points | µs a shot | µs an eye point |\n" + "|" + " ---: |" * 6 + "\n"
    for r in mine:
        text += (f"| {r['elements']:.0f} | {r['resolution']:.0f} | {r['shots']:.0f} | {r['eyes']:.0f} | "
                 f"{r['real_time']:.1f} | {r['us_per_eye']:.1f} |\n")
    sizes = [math.log(r["elements"]) for r in mine]
    by_shot = slope(sizes, [math.log(r["real_time"]) for r in mine])
    by_eye = slope(sizes, [math.log(r["us_per_eye"]) for r in mine])
    verdict = "holds" if by_shot <= BAR_SLOPE else "missed"
    return text + f"\nSlope: {by_shot:.2f} a shot, {by_eye:.2f} an eye point; the bar {verdict}.\n"


def all_settings(records):
    names = {(family, cut): name for name, family, cut in METHODS}
    names[CORE, None] = "core, lunes"
    text = ALL
    for r in records:
        name = names.get((r["family"], r["arguments"].get("cut")))
        if name:
            key = "R" if "R" in r["arguments"] else "rays"
            text += (f"| {name} | {r['elements']:.0f} | {key} {r['arguments'][key]} | {r['shots']:.0f} | "
                     f"{r['error_percent']:.2f} | {r['real_time']:.1f} |\n")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bench", help="default: build/host/bench/fixrad_bench, built first")
    parser.add_argument("--results", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        bench = arguments.bench
        if bench is None:
            run("cmake", "--build", "--preset", "host", "--target", "fixrad_bench")
            bench = str(ROOT / "build/host/bench/fixrad_bench")
        with tempfile.TemporaryDirectory() as folder:
            records = benchmark(bench, (arguments.results or pathlib.Path(folder) / "speed.json").resolve())
        page = HEAD + EQUAL + equal_error(records) + SHOTS + shots(records) + all_settings(records)
        temporary = PAGE.with_name(PAGE.name + ".new")
        temporary.write_text(page)
        temporary.rename(PAGE)
    except (Failure, OSError) as error:
        sys.exit(f"measure_speed: {error}")


if __name__ == "__main__":
    main()
