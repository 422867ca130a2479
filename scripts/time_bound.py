#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bound the instructions of step() and step(budget) on a Cortex-M0 (docs/bounded_time.md).

    scripts/time_bound.py --measure             measure the constants, write firmware/time_bound.json and the page
    scripts/time_bound.py --page                write the page's tables again
    scripts/time_bound.py --limits V F E S C    the bounds for these limits (with --rows R, --no-sights)
    scripts/time_bound.py --check-scene HEADER COUNTS [--no-sights]   fail if what was counted passes its bound
    scripts/time_bound.py --check-constants COUNTS                    fail if an operation costs more than its constant

--measure builds the preset cortex-m0 and needs its emulator. COUNTS are what firmware/emulators/run.py writes.
"""

import argparse
import dataclasses
import json
import math
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CONSTANTS = ROOT / "firmware/time_bound.json"
PAGE = ROOT / "docs/bounded_time.md"
BUILD = ROOT / "build/cortex-m0"
# What is added to a measured cost: nobody knows the dearest input of an operation, only the dearest that was tried.
MARGIN = 1.25
# Scenes whose calls tell what an element costs where no row is sampled, in one channel and in three.
SCENES = ("closed_box_small", "colonnade_small", "cornell_small")
WORST = ("worst_row_small", "worst_step_small")
PROBES, LOOKS, STARTS = 14, 16, 4
BAND, STRETCH = 16, 16


class Failure(Exception):
    """What was counted does not fit what is claimed."""


@dataclasses.dataclass
class Size:
    """What the bounds depend on: limits of the solver, grid lines of all faces, rows of the finest table and of a probe."""
    vertices: int
    faces: int
    elements: int
    spans: int
    channels: int
    lines: int = 0
    rows: int = 32
    probe_rows: int = 4
    has_sights: bool = True

    def __post_init__(self):
        # A grid of n x m elements has n + m - 2 lines, which is less than n m; sliver rows at the borders come on top.
        self.lines = self.lines or self.elements + 2 * self.faces


def constants_of_operations(regions):
    """What one turn of each loop costs, from the largest counts of firmware/apps/slices/operations.cpp."""
    top = {name: region["largest"] for name, region in regions.items()}
    vertex = (top["view_64_vertices"] - top["view_8_vertices"]) / 56
    band_vertex = (top["band_64_vertices"] - top["band_8_vertices"]) / 56
    return {
        "view": top["view_8_vertices"] - 8 * vertex, "vertex": vertex,
        "face": (top["view_16_faces"] - top["view_64_vertices"]) / 16, "grid": top["grid_16_faces"] / 16,
        "depth": top["depth_16_faces"] / 16, "band": top["band_8_vertices"] - 8 * band_vertex,
        "band_vertex": band_vertex, "band_face": (top["band_16_faces"] - top["band_64_vertices"]) / 16,
        "row": top["row_0_faces"], "turn": (top["row_16_faces"] - top["row_0_faces"]) / 16, "interval": top["interval"],
        "meet": max(top["meet_8_spans"] / 8, top["meet_32_spans"] / 32),
        "move": (top["shift_32_spans"] - top["shift_8_spans"]) / 24, "span": top["span"], "piece": top["piece"],
        "sum": top["sum"], "candidate": top["candidate"]}


def constants_of_scene(regions, size):
    """What an element costs where sources are looked for and shots are booked, and what a call costs."""
    units = ("search", "sample", "book", "book_face")
    calls = sum(regions[name]["entries"] for name in units if name in regions)
    sliced = sum(regions[name]["count"] for name in units if name in regions)
    book = max(regions[name]["largest"] for name in units[2:] if name in regions)
    c = size.channels
    return {f"search_{c}": regions["search"]["largest"] / size.elements, f"book_{c}": book / size.elements,
            "call": (sliced - regions["step"]["count"]) / calls}


def with_margin(measured):
    return {name: math.ceil(value * MARGIN) for name, value in measured.items()}


class Bound:
    """The formulas of docs/bounded_time.md."""

    def __init__(self, k, size):
        self.k, self.s = k, size

    def view(self):
        k, s = self.k, self.s
        return k["view"] + s.vertices * k["vertex"] + s.faces * (k["face"] + k["grid"])

    def band(self):
        return self.k["band"] + self.s.vertices * self.k["band_vertex"] + self.s.faces * self.k["band_face"]

    def depths(self):
        return self.s.faces * self.k["depth"]

    def row(self):
        k, s = self.k, self.s
        # Before face i of F there are at most S - 2 (F - i + 1) spans: each that is to come may still need two. At most S
        # borders come up on a row and as many go, and each moves what lies behind it.
        met = sum(max(1, s.spans - 2 * (s.faces - i + 1)) for i in range(1, s.faces + 1))
        inserted = s.faces * (k["turn"] + k["interval"]) + met * k["meet"] + 2 * s.spans ** 2 * k["move"]
        pieces = s.spans * k["span"] + (s.spans + s.lines) * (k["piece"] + k["sum"])
        return k["row"] + inserted + pieces

    def search(self):
        return self.s.elements * self.k[f"search_{self.s.channels}"]

    def book(self):
        return self.s.elements * self.k[f"book_{self.s.channels}"]

    def between(self):
        """What lies between two units: a call, and the candidates for eyes that need no probe."""
        return self.k["call"] + (PROBES - 1) * self.k["candidate"]

    def sample(self):
        return max(self.view(), self.row() + self.band() + self.depths())

    def call(self, budget):
        return budget * (max(self.sample(), self.search(), self.book()) + self.between())

    def whole_view(self, rows):
        return self.view() + self.depths() + math.ceil(rows / BAND) * self.band() + rows * self.row() + self.between()

    def step(self):
        s = self.s
        probes = PROBES - 1 if s.has_sights else 2 * s.elements + LOOKS + PROBES - 1
        return (probes * self.whole_view(s.probe_rows) + LOOKS * self.whole_view(s.rows) + 2 * STARTS * self.search()
                + self.book())


def size_of(header, has_sights=True):
    """The sizes of an exported scene."""
    text = pathlib.Path(header).read_text()
    v, f, e, s, c = (int(x) for x in re.search(r"Limits<([\d, ]+)>", text)[1].split(",")[:5])
    faces = re.search(r"kFaces\[\] = \{(.*?)\n\};", text, re.DOTALL)[1]
    cells = [(int(u), int(w)) for u, w in re.findall(r"\{\d+, \d+, \d+, \d+, (\d+), (\d+), \{", faces)]
    lines = sum(u + w - 2 for u, w in cells)
    tables = int(re.search(r"table_count = (\d+)", text)[1])
    return Size(v, f, e, s, c, max(lines, 1), 4 << (tables - 1), 4, has_sights)


def regions_of(counts):
    return json.loads(pathlib.Path(counts).read_text())["regions"]


def read_constants():
    return json.loads(CONSTANTS.read_text())["constants"]


def largest_of(regions):
    """Largest count of a call of one unit, of a call of eight and of a step, by region."""
    units = {n: regions[n]["largest"] for n in ("search", "sample", "book", "book_face") if n in regions}
    return {**units, "call 1": max(units.values()), "call 8": regions["call_8"]["largest"], "step": regions["step"]["largest"]}


def bounds_of(k, size):
    bound = Bound(k, size)
    return {"search": bound.search() + bound.between(), "sample": bound.sample() + bound.between(),
            "book": bound.book() + bound.between(), "book_face": bound.book() + bound.between(),
            "call 1": bound.call(1), "call 8": bound.call(8), "step": bound.step()}


def check_scene(header, counts, has_sights):
    found, bounds = largest_of(regions_of(counts)), bounds_of(read_constants(), size_of(header, has_sights))
    for name, count in found.items():
        print(f"{name}: {count:,} instructions, bound {bounds[name]:,}")
    over = [name for name, count in found.items() if count > bounds[name]]
    if over:
        raise Failure(f"{header}: over the bound: {', '.join(over)}; see docs/bounded_time.md")


def check_constants(counts):
    k = read_constants()
    over = [f"{name}: {value:.0f} instructions, the constant is {k[name]}"
            for name, value in constants_of_operations(regions_of(counts)).items() if value > k[name]]
    if over:
        raise Failure("\n".join(over + ["measure again: scripts/time_bound.py --measure"]))


def run(*command):
    done = subprocess.run([str(c) for c in command], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")


def count(program):
    """Regions of a run of a program of the preset."""
    folder = BUILD / "firmware/apps/slices"
    run(sys.executable, "-B", "firmware/emulators/run.py", "--board", "microbit", "--helper",
        BUILD / "firmware/emulators/count_plugin.so", "--expect-exit", "0", "--counts", folder / f"{program}.json",
        folder / f"{program}.elf")
    return regions_of(folder / f"{program}.json")


def measure():
    programs = ["operations"] + [f"slices_{s}" for s in SCENES + WORST]
    if not (BUILD / "build.ninja").exists():
        run("cmake", "--preset", "cortex-m0")
    run("cmake", "--build", "--preset", "cortex-m0", "--target", *programs)
    measured = constants_of_operations(count("operations"))
    largest = {}
    for scene in SCENES + WORST:
        regions = count(f"slices_{scene}")
        size = size_of(ROOT / f"firmware/scenes/{scene}.h", scene not in WORST)
        for name, value in constants_of_scene(regions, size).items():
            measured[name] = max(measured.get(name, 0), value)
        largest[scene] = largest_of(regions)
    measured = {name: round(value, 1) for name, value in measured.items()}
    CONSTANTS.write_text(json.dumps({"measured": measured, "constants": with_margin(measured), "largest": largest}, indent=1) + "\n")


def table(head, rows):
    align = ["---"] + ["---:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(str(c) for c in row) + " |" for row in [head, align, *rows])


WHAT = {
    "view": "beginning of a view", "vertex": "a vertex turned into a direction", "face": "a face of eight corners looked at",
    "grid": "a face's element grid", "depth": "a face's depth", "band": "beginning of a band of 16 rows",
    "band_vertex": "a vertex sorted among its rows", "band_face": "a face of eight corners sorted among its rows",
    "row": "a row that shows nothing", "turn": "a face that does not cross the row", "interval": "where a face of eight corners crosses a row",
    "meet": "a face meets a span", "move": "a span moved to make room", "span": "a visible span entered",
    "piece": "a piece of an element on it", "sum": "a piece written into the row of form factors",
    "candidate": "a place for an eye", "search_1": "an element, where a pass is started, 1 channel",
    "search_3": "the same, 3 channels", "book_1": "an element, where a shot is booked, 1 channel", "book_3": "the same, 3 channels",
    "call": "going on where the last call ended"}


def blocks():
    data = json.loads(CONSTANTS.read_text())
    k = data["constants"]
    constants = table(["constant", "what it is", "measured", "constant, + 25 %"],
                      [[f"`{n}`", WHAT[n], f"{data['measured'][n]:,}", f"{k[n]:,}"] for n in WHAT])
    scenes = []
    for scene, found in data["largest"].items():
        size = size_of(ROOT / f"firmware/scenes/{scene}.h", scene not in WORST)
        bounds = bounds_of(k, size)
        for what in ("search", "sample", "book_face", "call 1", "call 8", "step"):
            if what in found:
                scenes.append([scene if what == "search" else "", what, f"{found[what]:,}", f"{bounds[what]:,}",
                               f"{found[what] / bounds[what]:.2f}"])
    limits = []
    for name, size in (("cornell_small", Size(28, 20, 254, 42, 3)), ("8 KB", Size(64, 24, 200, 50, 1)),
                       ("large", Size(200, 120, 2000, 242, 3, rows=64))):
        bound = Bound(k, size)
        limits.append([name, size.vertices, size.faces, size.elements, size.spans, size.channels, f"{bound.call(1):,}", f"{bound.step():,}"])
    return {"constants": constants,
            "scenes": table(["scene", "what", "largest found", "bound", "found / bound"], scenes),
            "limits": table(["", "V", "F", "E", "S", "C", "`step(1)`", "`step()`"], limits)}


def write_page():
    text = PAGE.read_text()
    for name, block in blocks().items():
        pattern = re.compile(rf"(<!-- generated: {name} -->\n).*?(<!-- end generated -->)", re.DOTALL)
        if not pattern.search(text):
            raise Failure(f"{PAGE}: no place for the table {name}")
        text = pattern.sub(lambda m, b=block: f"{m[1]}\n{b}\n\n{m[2]}", text)
    PAGE.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measure", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--limits", nargs=5, type=int, metavar=("V", "F", "E", "S", "C"))
    parser.add_argument("--rows", type=int, default=32, help="R of the finest table")
    parser.add_argument("--no-sights", action="store_true", help="the scene does not say which eyes are clear")
    parser.add_argument("--check-scene", nargs=2, metavar=("HEADER", "COUNTS"))
    parser.add_argument("--check-constants", metavar="COUNTS")
    options = parser.parse_args()
    try:
        if options.measure:
            measure()
        if options.measure or options.page:
            write_page()
        if options.limits:
            bound = Bound(read_constants(), Size(*options.limits, rows=options.rows, has_sights=not options.no_sights))
            print(f"step(1): {bound.call(1):,} instructions\nstep(): {bound.step():,} instructions")
        if options.check_scene:
            check_scene(*options.check_scene, not options.no_sights)
        if options.check_constants:
            check_constants(options.check_constants)
    except (Failure, OSError, KeyError, ValueError) as error:
        sys.exit(f"time_bound: {type(error).__name__}: {error}")


if __name__ == "__main__":
    main()
