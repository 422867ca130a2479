#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure error against elements for every kind of mesh that the tool knows, and write docs/meshing.md with its plots and
pictures: irradiance at points as elements, vertex colours and gathers tell it, and means of faces.

    scripts/measure_meshing.py                everything, with build/host/fixrad; about ten minutes on two cores
    scripts/measure_meshing.py --tool PATH    another build of the tool
    scripts/measure_meshing.py --work FOLDER  keep there what the tool writes, and run no command again whose result
                                              is there (of the same tool, scene and options); the truth at the points is
                                              kept by scene and serves every build of the tool
"""

import argparse
import concurrent.futures
import hashlib
import json
import math
import os
import pathlib
import re
import sys
import tempfile
from dataclasses import dataclass

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

import meshing_page
from face_errors import error_of
from measure_accuracy import ROOT, Failure, Refusal, Tool, write

POINTS = 1000
PROFILE = "large"
TABLE_ELEMENTS = 250
CURVES = ("cornell", "small_lamp", "shadow_room")
POINT_PATHS, CURVE_PATHS = 4096, 32768  # the truth's own error is to be small against that of the finest mesh
CURVE_ELEMENTS = (60, 125, 250, 500, 1000)
STAGES = (145, 1021, 1306)  # of the lecture's slides: coarse, fine and adaptive
STAGE_SCENE = "scenes/cornell.obj"


@dataclass
class Run:
    """One scene on one mesh: {display: mean, median and 95th percentile}, error of face means."""

    elements: int
    vertices: int
    points: dict
    faces: object
    uncertainty: float


class MeshTool(Tool):
    """The tool with its kinds of meshes."""

    def kinds(self):
        """From the tool itself, so that none is forgotten; a tool without the option knows one."""
        found = re.search(r"--mesh TEXT:\{([a-z,]+)\}", self("bake", "--help"))
        return found[1].split(",") if found else ["uniform"]

    def mesh_options(self, kind):
        return ["--mesh", kind] if "--mesh " in self("bake", "--help") else []

    def show_options(self):
        return ["--show", "mesh"] if "--show " in self("bake", "--help") else []

    @staticmethod
    def paths(scene):
        return CURVE_PATHS if pathlib.Path(scene).stem in CURVES else POINT_PATHS

    def points_truth(self, scene):
        key = hashlib.sha256()
        for path in (ROOT / scene, (ROOT / scene).with_suffix(".mtl")):
            key.update(path.read_bytes() if path.exists() else b"")
        return self.folder / f"points{self.paths(scene)}_{pathlib.Path(scene).stem}_{key.hexdigest()[:16]}.json"

    def measure(self, scene, kind, elements, truth):
        """A Run, or why there is none."""
        options = ["--profile", PROFILE, "--elements", elements, *self.mesh_options(kind)]
        try:
            files = self.files("compare", scene, [("--json", ".json")], *options, "--points", POINTS, "--points-paths",
                               self.paths(scene), "--points-only", "--points-truth", self.points_truth(scene))
            record = json.loads(files[0].read_text())
            faces, _ = self.bake(scene, *options)
        except Refusal as refusal:
            return str(refusal)
        points = record["points"]
        return Run(record["elements"], points["vertices"], {line["name"]: line for line in points["errors"]},
                   error_of(faces, truth), points["truth_standard_error"])


def elements_for(runs, error, display):
    """Elements at which a curve has this error, between two of its points; None beyond its ends."""
    for a, b in zip(runs, runs[1:]):
        high, low = a.points[display]["mean"], b.points[display]["mean"]
        if high >= error >= low > 0:
            part = math.log(high / error) / math.log(high / low) if high > low else 0
            return a.elements * (b.elements / a.elements) ** part
    return None


def ratios(curves):
    """Rows of (scene, display, better kind, worse kind, elements, elements for the same error, error ratio)."""
    found = []
    for scene, kinds in curves.items():
        for better, worse in (("adaptive", "uniform"), ("discontinuity", "adaptive")):
            at = [r for r in kinds.get(better, []) if r.elements <= 1.2 * TABLE_ELEMENTS]
            if not at or worse not in kinds:
                continue
            run = at[-1]
            other = min(kinds[worse], key=lambda r: abs(math.log(r.elements / run.elements)))
            for display in meshing_page.COMPARED:
                error = run.points[display]["mean"]
                found.append((scene, display, better, worse, run.elements,
                              elements_for(kinds[worse], error, display), other.points[display]["mean"] / error))
    return found


def measure(tool, pool):
    scenes = {path.stem: f"scenes/{path.name}" for path in sorted((ROOT / "scenes").glob("*.obj"))}
    kinds = tool.kinds()
    truths = dict(zip(scenes, pool.map(tool.truth, scenes.values())))
    wanted = {(name, kind, n): pool.submit(tool.measure, scenes[name], kind, n, truths[name])
              for name in scenes for kind in kinds
              for n in (CURVE_ELEMENTS if name in CURVES else (TABLE_ELEMENTS,))}
    runs = {key: future.result() for key, future in wanted.items()}
    curves = {name: {kind: [runs[name, kind, n] for n in CURVE_ELEMENTS if isinstance(runs[name, kind, n], Run)]
                     for kind in kinds} for name in CURVES}
    table = {(name, kind): runs[name, kind, TABLE_ELEMENTS] for name in scenes for kind in kinds}
    return {"kinds": kinds, "scenes": list(scenes), "table": table, "curves": curves, "ratios": ratios(curves)}


def draw_stages(tool, kinds):
    """The pictures of the three stages, the last of them adaptive if the tool can; with the mesh if it can show it."""
    drawn = []
    kind_of = {STAGES[-1]: "adaptive" if "adaptive" in kinds else kinds[0]}
    for number in STAGES:
        kind = kind_of.get(number, kinds[0])
        options = ["--profile", PROFILE, "--elements", number, *tool.mesh_options(kind)]
        files = []
        for suffix, more in (("", []), ("_mesh", tool.show_options())):
            if suffix and not more:
                continue
            path = f"images/meshing_{number}{suffix}.png"
            tool("bake", STAGE_SCENE, *options, *more, "-o", ROOT / "docs" / path)
            files.append(path)
        drawn.append((number, kind, files))
    return drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", type=pathlib.Path, default=ROOT / "build/host/fixrad")
    parser.add_argument("--work", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            work = (arguments.work or pathlib.Path(folder)).resolve()
            work.mkdir(parents=True, exist_ok=True)
            tool = MeshTool(arguments.tool.resolve(), work)
            found = measure(tool, pool)
            found["stages"] = draw_stages(tool, found["kinds"])
        for name, kinds in found["curves"].items():
            write(ROOT / f"docs/images/meshing_{name}.svg", meshing_page.plot(name, kinds))
        write(ROOT / "docs/meshing.md", meshing_page.page(found))
    except (Failure, Refusal, OSError) as error:
        sys.exit(f"measure_meshing: {error}")


if __name__ == "__main__":
    main()
