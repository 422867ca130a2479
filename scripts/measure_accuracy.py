#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure how far the tool is from the truth, and write it where readers look: docs/accuracy.md as a whole, and the
passages of README.md that stand between <!-- generated: NAME --> and <!-- end generated -->. Bakes the pictures in
docs/images/ too. Every engine that the tool knows, every scene of scenes/ and twenty random rooms, on three meshes.

    scripts/measure_accuracy.py                everything, with build/host/fixrad; up to ten minutes on two cores
    scripts/measure_accuracy.py --tool PATH    another build of the tool
    scripts/measure_accuracy.py --work FOLDER  keep there what the tool writes, and run no command again whose result
                                               is there (of the same tool, scene and options)
"""

import argparse
import concurrent.futures
import hashlib
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

import accuracy_page
from closed_forms import form_factor, pairs, radiosity_cases, write_scene
from face_errors import error_of, read_faces, uncertainty_of
from random_rooms import write_rooms

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHOWN = "scenes/cornell.obj"  # the scene of the README's tables
SHOWN_PROFILES = ("tiny", "small", "medium", "large")
BUDGET_PROFILE = "small"
PICTURES = {"cornell": [],
            "furnished_room": ["--camera", "1.3,1.6,0.3,3.8,0.75,2.9,78", "--exposure", "-0.5"]}
DEFAULT_ENGINE = "lunes"
PROFILES = ("large", "small", "tiny")
OTHER_PROFILES = ("large", "small")  # of the other engines
# Rays between all pairs of 2,000 elements take minutes a scene; the page says that this is left out.
SLOW_ENGINES = ("rays",)
SLOW_PROFILES = ("small",)
MESHES = 3
# Of the elements that a profile takes by itself; those after the third stand in where two give the same mesh.
MESH_FACTORS = (1, 0.9, 1.1, 0.8, 1.2, 0.7, 1.4, 1.6)
DOES_NOT_FIT = "does not fit"
ANGLES = (0, 18, 36, 54, 72)
SAMPLES, ROOMS, TURNED = "sample scenes", "random rooms", "Cornell turned"
TURNED_PROFILES = ("small",)


class Failure(Exception):
    """A command ended as it should not."""


class Refusal(Exception):
    """The tool says that it cannot take a scene; the text is its reason."""


@dataclass
class Run:
    """One bake against the truth."""

    elements: int
    error: object
    record: dict


@dataclass
class Measured:
    """A scene on several meshes, or the reason why there is none."""

    scene: str
    runs: list
    refusal: str = ""


class Tool:
    """The tool, and the folder that keeps what it has written: the same command is not run twice."""

    def __init__(self, path, folder):
        self.path, self.folder = path, folder
        self.digest = hashlib.sha256(path.read_bytes())

    def __call__(self, *arguments):
        done = subprocess.run([self.path, *map(str, arguments), "--quiet"], cwd=ROOT, capture_output=True, text=True,
                              check=False)
        if done.returncode == 1 and "error: " in done.stderr:
            raise Refusal(done.stderr.strip().split("error: ", 1)[1])
        if done.returncode != 0:
            raise Failure(f"{self.path} {' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stderr}")
        return done.stdout

    def files(self, command, scene, outputs, *options):
        """Paths of what the command writes; outputs: [(option, suffix)]. Files appear complete or not at all."""
        key = self.digest.copy()
        for part in (command, *map(str, options)):
            key.update(part.encode() + b"\0")
        for path in (ROOT / scene, (ROOT / scene).with_suffix(".mtl")):
            key.update(path.read_bytes() if path.exists() else b"")
        stem = f"{command}_{pathlib.Path(scene).stem}_{key.hexdigest()[:16]}"
        paths = [self.folder / (stem + suffix) for _, suffix in outputs]
        if not all(path.exists() for path in paths):
            written = [word for (option, _), path in zip(outputs, paths) for word in (option, path)]
            self(command, scene, *options, *written)
            print(command, scene, *options, file=sys.stderr)
        return paths

    def engines(self):
        """From the tool itself, so that none is forgotten; the default first."""
        found = re.search(r"--engine TEXT:\{([a-z,]+)\}", self("bake", "--help"))
        if not found or DEFAULT_ENGINE not in found[1].split(","):
            raise Failure(f"{self.path} bake --help: no list of engines with {DEFAULT_ENGINE}")
        return sorted(found[1].split(","), key=lambda name: (name != DEFAULT_ENGINE, name))

    def truth(self, scene):
        return read_faces(self.files("truth", scene, [("--csv", ".csv")])[0])

    def bake(self, scene, *options):
        """(faces, record)"""
        faces, record = self.files("bake", scene, [("--faces-csv", ".csv"), ("-o", ".json")], *options)
        return read_faces(faces), json.loads(record.read_text())

    def form_factor(self, scene, engine):
        """From the first face to the second."""
        path = self.files("form-factors", scene, [("--csv", ".csv")], "--engine", engine)[0]
        factors = dict(line.rsplit(",", 1) for line in path.read_text().splitlines())
        return float(factors.get("0,1", 0))

    def compare(self, scene, profile):
        """The record of `compare`, or None where the scene does not fit."""
        try:
            return json.loads(self.files("compare", scene, [("--json", ".json")], "--profile", profile)[0].read_text())
        except Refusal as refusal:
            if DOES_NOT_FIT not in str(refusal):
                raise
            return None


def measure_scene(tool, name, scene, truth, engine, profile, meshes=MESHES):
    """Bakes on meshes of nearly the same size until there are enough that differ."""
    runs, count = [], None
    for factor in MESH_FACTORS:
        options = ["--engine", engine, "--profile", profile]
        if count:
            options += ["--elements", math.floor(count * factor)]
        try:
            faces, record = tool.bake(scene, *options)
        except Refusal as refusal:
            if not runs:
                return Measured(name, [], re.sub(r"^.*?the scene", "the scene", str(refusal)))
            continue  # fewer elements than faces
        count = count or record["elements"]
        if record["elements"] not in [r.elements for r in runs]:
            runs.append(Run(record["elements"], error_of(faces, truth), record))
        if len(runs) == meshes:
            break
    return Measured(name, runs)


def turned(scene, angle, folder):
    """The scene turned about the vertical axis, beside a copy of its materials."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def turn(line):
        word, x, y, z = line.split()[:4]
        return f"{word} {c * float(x) + s * float(z):.9f} {y} {c * float(z) - s * float(x):.9f}"

    source = ROOT / scene
    lines = [turn(line) if line.startswith("v ") else line for line in source.read_text().splitlines()]
    path = folder / f"{source.stem}_{angle}.obj"
    path.write_text("\n".join(lines) + "\n")
    for library in source.parent.glob(source.stem + ".mtl"):
        (folder / library.name).write_bytes(library.read_bytes())
    return path


def profiles_of(group, engine):
    if group == TURNED:
        return TURNED_PROFILES if engine == DEFAULT_ENGINE else ()
    if engine in SLOW_ENGINES:
        return SLOW_PROFILES
    return PROFILES if engine == DEFAULT_ENGINE else OTHER_PROFILES


def mesh_count(group, engine):
    """Random rooms are many: of the engines that are not the default they take one mesh."""
    return MESHES if engine == DEFAULT_ENGINE or group == SAMPLES else 1


def measure_pairs(tool, engines, pool):
    """Rows of (name, expected, {engine: form factor, or why there is none})."""
    def measure(case):
        number, (name, source, receiver) = case
        scene = write_scene(tool.folder, f"pair_{number}", [("grey", source), ("grey", receiver)], {"grey": (0.5, 1)})
        found = {}
        for engine in engines:
            try:
                found[engine] = tool.form_factor(scene, engine)
            except Refusal as refusal:
                found[engine] = str(refusal)
        return name, form_factor(source, receiver), found

    return list(pool.map(measure, enumerate(pairs())))


def measure_radiosities(tool, pool):
    """Rows of (case, {profile: radiosity})."""
    def measure(numbered):
        number, case = numbered
        scene = write_scene(tool.folder, f"case_{number}", case.faces, case.materials)
        return case, {p: case.value(tool.bake(scene, "--profile", p, *case.options)[0]) for p in PROFILES}

    return list(pool.map(measure, enumerate(radiosity_cases())))


def replace_generated(path, passages):
    """Renews each passage NAME of a page; a page without the marker is an error."""
    text = path.read_text()
    for name, passage in passages.items():
        pattern = rf"(<!-- generated: {re.escape(name)} -->\n).*?(<!-- end generated -->)"
        text, count = re.subn(pattern, lambda m, p=passage: m[1] + "\n" + p + "\n" + m[2], text, flags=re.DOTALL)
        if count != 1:
            raise Failure(f"{path}: {count} passages <!-- generated: {name} -->, 1 is needed")
    write(path, text)


def write(path, text):
    temporary = path.with_name(path.name + ".new")
    temporary.write_text(text)
    temporary.rename(path)


def measure(tool, pool):
    engines = tool.engines()
    groups = {SAMPLES: {p.stem: p for p in sorted((ROOT / "scenes").glob("*.obj"))},
              ROOMS: {p.stem: p for p in write_rooms(tool.folder)}}
    scenes = {name: path for group in groups.values() for name, path in group.items()}
    truths = {name: tool.truth(path) for name, path in scenes.items()}
    cornell = pathlib.Path(SHOWN).stem
    groups[TURNED] = {f"{cornell}, {a}°": turned(SHOWN, a, tool.folder) for a in ANGLES}
    truths.update({name: truths[cornell] for name in groups[TURNED]})
    wanted = {(group, engine, profile): pool.map(
        measure_scene, itertools.repeat(tool), members, members.values(), [truths[name] for name in members],
        itertools.repeat(engine), itertools.repeat(profile), itertools.repeat(mesh_count(group, engine)))
              for group, members in groups.items() for engine in engines for profile in profiles_of(group, engine)}
    pair_rows, case_rows = measure_pairs(tool, engines, pool), measure_radiosities(tool, pool)
    results = {key: list(values) for key, values in wanted.items()}
    budget = {name: tool.compare(path, BUDGET_PROFILE) for name, path in groups[SAMPLES].items()}
    shown = {profile: tool.compare(SHOWN, profile) for profile in SHOWN_PROFILES}
    return {"engines": engines, "groups": (SAMPLES, ROOMS, TURNED), "results": results,
            "uncertainty": {n: uncertainty_of(t) for n, t in truths.items()},
            "pairs": pair_rows, "cases": case_rows, "budget": budget, "shown": shown}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", type=pathlib.Path, default=ROOT / "build/host/fixrad")
    parser.add_argument("--work", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            work = (arguments.work or pathlib.Path(folder)).resolve()
            work.mkdir(parents=True, exist_ok=True)
            tool = Tool(arguments.tool.resolve(), work)
            found = measure(tool, pool)
            for name, view in PICTURES.items():
                tool("bake", f"scenes/{name}.obj", *view, "-o", f"docs/images/{name}.png")
            memory = "```\n" + tool("info", SHOWN).rsplit("\n\n", 1)[1].rstrip("\n") + "\n```\n"
        write(ROOT / "docs/accuracy.md", accuracy_page.page(found))
        replace_generated(ROOT / "README.md",
                          {"memory": memory, "accuracy": accuracy_page.budget_table("profile", found["shown"])})
    except (Failure, Refusal, OSError) as error:
        sys.exit(f"measure_accuracy: {error}")


if __name__ == "__main__":
    main()
