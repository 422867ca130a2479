#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure the programs of all seven targets in their emulators and write firmware/measurements.json, docs/targets.md
and the table of targets in README.md.

    scripts/measure_targets.py                      build, test and measure everything
    scripts/measure_targets.py cortex-m0 rv32imc    only these; what is known of the others stays
    scripts/measure_targets.py --pages              write the pages again from firmware/measurements.json
    scripts/measure_targets.py --tool PATH          the fixrad to compare with the truth (default: build/host/fixrad)

The error of a scene is measured again only if its digest has changed: path tracing takes up to two minutes.
"""

import argparse
import concurrent.futures
import fcntl
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import face_errors
import targets_page
from program_sizes import sizes

ROOT = pathlib.Path(__file__).resolve().parent.parent
MEASUREMENTS = ROOT / "firmware/measurements.json"
WORKERS = 2


class Failure(Exception):
    """A command ended as it should not."""


def run(*command, allowed=(0,)):
    done = subprocess.run([str(c) for c in command], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode not in allowed:
        raise Failure(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def target_presets():
    """{preset: (core, board)} of the presets for targets."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    return {p["name"]: (p["cacheVariables"]["FIXRAD_CORE"], p["cacheVariables"]["FIXRAD_BOARD"])
            for p in presets if "FIXRAD_BOARD" in p.get("cacheVariables", {})}


def scenes_of(board):
    return run("cmake", f"-DFIXRAD_BOARD={board}", "-P", "tests/targets/print_scenes.cmake").split()


def header_of(scene):
    """What the committed header says of the scene."""
    text = (ROOT / f"firmware/scenes/{scene}.h").read_text()
    number = {key: re.search(rf"\bk{key.title()} = (0x)?(\w+?)u", text)[2] for key in ("digest", "shots", "eyes")}
    counts = re.search(r"(\d+) faces, (\d+) elements, (\d+) patches, .* (\d) channel", text)
    return {"digest": number["digest"], "shots": int(number["shots"]), "eyes": int(number["eyes"]),
            "faces": int(counts[1]), "elements": int(counts[2]), "patches": int(counts[3]), "channels": int(counts[4]),
            "limits": re.search(r"Limits<([^>]*)>", text)[1]}


def commands_of(preset):
    """{name of a test: its command}."""
    tests = json.loads(run("ctest", "--preset", preset, "--show-only=json-v1"))["tests"]
    return {test["name"]: test["command"] for test in tests}


def emulate(command, counts):
    """Runs the program of a test's command with counters; returns (lines of its console, counts)."""
    prefix = command[:command.index("--helper") + 2]
    console = run(*prefix, "--counts", counts, command[-1])
    lines = [line.split() for line in console.splitlines()]
    return lines, json.loads(pathlib.Path(counts).read_text())


def value(lines, *keys):
    """The number or word after these words."""
    for line in lines:
        if tuple(line[:len(keys)]) == keys:
            return int(line[len(keys)]) if line[len(keys)].isdigit() else line[len(keys)]
    raise Failure(f"the console says nothing of {' '.join(keys)}")


def measure_scene(preset, scene, command):
    with tempfile.TemporaryDirectory() as folder:
        lines, counts = emulate(command, f"{folder}/counts.json")
    if value(lines, "result") != "equal":
        raise Failure(f"{preset}, {scene}: not the bits of the host")
    regions = {name: region["count"] for name, region in counts["regions"].items()}
    print(f"measured {preset}, {scene}", file=sys.stderr)
    return {**header_of(scene), **sizes(command[-1], scene), "digest": value(lines, "digest"),
            "shots": value(lines, "shots"), "eyes": value(lines, "eyes"), "stack": value(lines, "stack_used"),
            "load": regions["load"], "solve": regions["solve"], "vertices": regions["vertices"]}


def stages_of(command):
    """{stage: count} by the command of the test that requires every stage."""
    return json.loads(run(*command[:command.index("--require")], "--json"))["stages"]


def measure_bench(preset, scene, commands):
    command = commands[f"Bench.{scene}.CountsARightSolution"]
    lines, counts = emulate(command, command[command.index("--counts") + 1])
    result = {"unit": counts["unit"]}
    for solver in ("core", "peer"):
        result[solver] = {
            "solve": counts["regions"][f"{solver}_solve"]["count"],
            "stages": stages_of(commands[f"Bench.{scene}.EveryStageOf.{solver}_solve.IsCounted"]),
            "errors": {reference: value(lines, f"{solver}_error_ppm", reference, "mean")
                       for reference in ("same_shots", "fine")}}
    print(f"measured {preset}, {scene} beside the float peer", file=sys.stderr)
    return result


def run_tests(preset):
    """[passed, all], but for those that compare with the last measurements."""
    output = run("ctest", "--preset", preset, "-j", WORKERS, "-E", "^Measured", allowed=(0, 8))
    failed, total = map(int, re.search(r"(\d+) tests failed out of (\d+)", output).groups())
    return [total - failed, total]


def measure_static(commands):
    """What the checks that run nothing print: worst-case stacks, and the size of `rows` where it is measured."""
    pattern = r"worst-case stack: (\d+) bytes of (\d+)"
    core, program = (re.search(pattern, run(*commands[f"Static.TheStackOf{what}Fits"], allowed=(0, 1)))
                     for what in ("TheCore", "AProgram"))
    result = {"static_stack": {"core": int(core[1]), "program": int(program[1]), "budget": int(program[2])}}
    if "Static.CodeAndTablesForRowsFit" in commands:
        text = run(*commands["Static.CodeAndTablesForRowsFit"], allowed=(0, 1))
        result["rows_size"] = int(re.search(r"code and tables: (\d+) bytes", text)[1])
    return result


def measure_target(preset, board):
    print(f"building {preset}", file=sys.stderr)
    run("cmake", "--fresh", "--preset", preset)  # a cache keeps the flags of an older toolchain file
    run("cmake", "--build", "--preset", preset)
    tests, commands = run_tests(preset), commands_of(preset)
    print(f"{preset}: {tests[0]} of {tests[1]} tests passed", file=sys.stderr)
    scenes = scenes_of(board)
    benches = [s for s in scenes if f"Bench.{s}.CountsARightSolution" in commands]
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        solved = pool.map(lambda s: measure_scene(preset, s, commands[f"Solve.{s}.GivesTheBitsOfTheHost"]), scenes)
        benched = pool.map(lambda s: measure_bench(preset, s, commands), benches)
        return {"tests": tests, **measure_static(commands), "scenes": dict(zip(scenes, solved)), "bench": dict(zip(benches, benched))}


def export_options():
    """{scene_profile: (scene, profile, options)} of scripts/export_scenes.sh."""
    text = (ROOT / "scripts/export_scenes.sh").read_text()
    lines = re.search(r"^list='\n(.*?)^'", text, re.MULTILINE | re.DOTALL)[1].splitlines()
    entries = {}
    for scene, profile, *options in (line.split() for line in lines):
        name, _, source = scene.partition("=")
        entries[f"{name}_{profile}"] = (source or name, profile, options)
    return entries


def trace_truth(tool, scene, folder):
    """Path-traced faces of a scene."""
    file = pathlib.Path(folder) / f"{scene}.csv"
    run(tool, "truth", f"scenes/{scene}.obj", "--quiet", "--csv", file)
    print(f"traced {scene}", file=sys.stderr)
    return face_errors.read_faces(file)


def error_of(tool, name, truth, folder):
    """Error of the face radiosities against the path-traced truth, and the truth's standard error."""
    scene, profile, options = export_options()[name]
    faces, record = pathlib.Path(folder) / f"{name}.csv", pathlib.Path(folder) / f"{name}.json"
    run(tool, "bake", f"scenes/{scene}.obj", "--profile", profile, *options, "--quiet", "--faces-csv", faces, "-o", record)
    header = header_of(name)
    elements = json.loads(record.read_text())["elements"]
    if elements != header["elements"]:
        raise Failure(f"{name}: {tool} makes {elements} elements, the header has {header['elements']}")
    error = face_errors.error_of(face_errors.read_faces(faces), truth)
    return {"digest": header["digest"], "mean": error.mean, "worst": error.worst,
            "truth": face_errors.uncertainty_of(truth).mean}


def measure_errors(tool, known, names):
    new = [n for n in names if known.get(n, {}).get("digest") != header_of(n)["digest"]]
    with tempfile.TemporaryDirectory() as folder:
        scenes = sorted({export_options()[n][0] for n in new})
        truths = {scene: trace_truth(tool, scene, folder) for scene in scenes}
        found = {n: error_of(tool, n, truths[export_options()[n][0]], folder) for n in new}
    return {n: found.get(n) or known[n] for n in names}


def write(path, text):
    partial = path.with_name(path.name + ".partial")
    partial.write_text(text)
    partial.rename(path)


def read_measurements():
    return json.loads(MEASUREMENTS.read_text()) if MEASUREMENTS.exists() else {"targets": {}, "errors": {}}


def write_pages(measured):
    for path, text in targets_page.pages(ROOT, measured).items():
        write(path, text)


def lock():
    """Two runs at a time would build in the same folders."""
    (ROOT / "build").mkdir(exist_ok=True)
    file = (ROOT / "build/measure_targets.lock").open("w")
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        raise Failure("another run of this script is measuring") from error
    return file


def measure(options):
    presets, measured = target_presets(), read_measurements()
    for preset in options.targets or presets:
        measured["targets"][preset] = measure_target(preset, presets[preset][1])
        write(MEASUREMENTS, json.dumps(measured, indent=1) + "\n")
    names = sorted({s for _, board in presets.values() for s in scenes_of(board)})
    measured["errors"] = measure_errors(options.tool, measured["errors"], names)
    measured["targets"] = {p: measured["targets"][p] for p in presets if p in measured["targets"]}
    write(MEASUREMENTS, json.dumps(measured, indent=1) + "\n")
    missing = [p for p in presets if p not in measured["targets"]]
    if missing:
        raise Failure(f"not measured yet, so the pages are not written: {', '.join(missing)}")
    write_pages(measured)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pages", action="store_true")
    parser.add_argument("--tool", default=str(ROOT / "build/host/fixrad"))
    parser.add_argument("targets", nargs="*", metavar="PRESET")
    options = parser.parse_args()
    unknown = set(options.targets) - set(target_presets())
    if unknown:
        parser.error(f"no such target: {', '.join(sorted(unknown))}")
    try:
        if options.pages:
            write_pages(read_measurements())
        elif not shutil.which(options.tool):
            raise Failure(f"{options.tool} is not there; build the preset host first")
        else:
            with lock():
                measure(options)
    except (Failure, OSError, KeyError, ValueError) as error:
        sys.exit(f"measure_targets: {type(error).__name__}: {error}")


if __name__ == "__main__":
    main()
