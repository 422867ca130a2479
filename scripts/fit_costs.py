#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fit what each step of a solution costs on each target, and write host_sim/sweep/cost_table.cpp.

    scripts/fit_costs.py [--check] [--tool build/host/host_sim/cli/count_work]

Reads the exact counts of firmware/measurements.json and those of host_sim/sweep/calibration.json, solves all of these
again on the host to count their steps, and finds, target by target, the weights w >= 0 that minimise

    sum over measurements ((w . steps - count) / count)^2  +  sum over stages of the bench (the same, times 0.1)
    + sum over steps (0.03 (w / (s prior) - 1))^2

with s the factor that fits `prior` as a whole. The last sum decides between steps that no measurement tells apart, such
as those that always come in the same proportion. Run it after scripts/measure_targets.py; takes seconds. Runs of
calibration.json whose bits are no longer those of the tool are left out, with a line on stderr, until
scripts/measure_engines.py measures them again; the table says which engines remain, and the others get no cost.
--check writes nothing and fails if a measurement is more than LIMIT away from what the committed weights say.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

from measure_targets import export_options

ROOT = pathlib.Path(__file__).resolve().parent.parent
MEASUREMENTS = ROOT / "firmware/measurements.json"
CALIBRATION = ROOT / "host_sim/sweep/calibration.json"
TABLE = ROOT / "host_sim/sweep/cost_table.cpp"

# Steps as in host_sim/sweep/work.h, with the instructions that each takes on a Cortex-M3, by order of magnitude; only
# their proportions matter.
PRIOR = {"eye": 500, "vertex": 80, "face": 40, "view": 500, "band_vertex": 60, "band_face": 70, "row": 80,
         "interval": 110, "span_met": 15, "span": 180, "piece": 110, "pixel_test": 40, "pixel": 40, "share": 45,
         "face_share": 90, "element": 8, "unshot": 25}
# Steps that make up each stage of the bench; stages that are not here are spread over all of these.
STAGES = {"transform": ("vertex", "face", "view", "eye"), "raster": ("band_vertex", "band_face", "interval"),
          "insert": ("row", "span_met"), "split": ("span", "piece"), "search": ("unshot",),
          "distribute": ("share", "face_share", "element")}
LIMIT = 0.1
STAGE_WEIGHT = 0.1
PRIOR_WEIGHT = 0.03
POINTER_BYTES = {"atmega2560": 2}


def count_steps(tool, scene, profile, options):
    command = [tool, ROOT / f"scenes/{scene}.obj", "--profile", profile, *options]
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"fit_costs: {' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")
    return json.loads(done.stdout)


def measured_steps(tool, measured):
    """{scene_profile: steps} of all measured scenes, whose solution must still be the measured one."""
    digests = {name: scene["digest"] for target in measured["targets"].values()
               for name, scene in target["scenes"].items()}
    steps = {}
    for name in sorted(digests):
        counted = count_steps(tool, *export_options()[name])
        if counted["digest"] != digests[name]:
            sys.exit(f"fit_costs: {MEASUREMENTS.relative_to(ROOT)}: {name} was measured with digest {digests[name]}, "
                     f"this tool's is {counted['digest']}; run scripts/measure_targets.py first")
        steps[name] = counted["work"]
    return steps


def current_calibration(tool):
    """The runs of calibration.json that this tool still solves with the same bits, their steps counted anew."""
    runs, stale = {}, []
    known = json.loads(CALIBRATION.read_text())["runs"] if CALIBRATION.exists() else {}
    for name, run in known.items():
        command = [str(tool), str(ROOT / f"scenes/{run['scene']}.obj"), *run["options"]]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        counted = json.loads(done.stdout) if done.returncode == 0 else {"digest": "none"}
        if counted["digest"] == run["digest"]:
            runs[name] = {**run, "work": counted["work"]}
        else:
            stale.append(name)
    if stale:
        print(f"fit_costs: {CALIBRATION.relative_to(ROOT)}: not used, since the solver has changed: {', '.join(stale)}; "
              "scripts/measure_engines.py measures again", file=sys.stderr)
    return runs


def engine_of(options):
    return options[options.index("--engine") + 1] if "--engine" in options else "lunes"


def engines_of(target, record, calibration):
    """The engines that were measured on a target, the default first."""
    found = {engine_of(export_options()[name][2]) for name in record["scenes"]}
    found |= {engine_of(run["options"]) for run in calibration.values() if target in run["solve"]}
    return sorted(found, key=lambda engine: (engine != "lunes", engine))


def solve(rows, names):
    """Least squares with w >= 0 by coordinate descent; rows: [({step: coefficient}, value)]."""
    gram = {a: {b: 0.0 for b in names} for a in names}
    right = {a: 0.0 for a in names}
    for coefficients, value in rows:
        for a, x in coefficients.items():
            right[a] += x * value
            for b, y in coefficients.items():
                gram[a][b] += x * y
    weights = {a: 0.0 for a in names}
    for _ in range(20000):
        change = 0.0
        for a in names:
            if gram[a][a] > 0:
                slope = right[a] - sum(gram[a][b] * weights[b] for b in names)
                new = max(0.0, weights[a] + slope / gram[a][a])
                change = max(change, abs(new - weights[a]))
                weights[a] = new
        if change < 1e-12:
            break
    return weights


def stage_rows(bench, steps):
    """A row for each stage; what is not in STAGES, such as calls to division, is shared out in proportion."""
    rows = []
    for scene, record in bench.items():
        stages = {stage: record["core"]["stages"].get(stage, 0) for stage in STAGES}
        factor = record["core"]["solve"] / sum(stages.values())
        for stage, parts in STAGES.items():
            count = stages[stage] * factor
            if count == 0:
                continue
            rows.append(({p: STAGE_WEIGHT * steps[scene][p] / count for p in parts}, STAGE_WEIGHT))
    return rows


def fit_target(runs, bench, steps):
    """(weights, largest relative residual); runs: [(steps, count)]."""
    prior_sum = [sum(PRIOR[n] * work[n] for n in PRIOR) / count for work, count in runs]
    scale = sum(prior_sum) / sum(p * p for p in prior_sum)
    prior = {n: scale * PRIOR[n] for n in PRIOR}
    rows = [({n: work[n] * prior[n] / count for n in PRIOR}, 1.0) for work, count in runs]
    rows += [({n: x * prior[n] for n, x in coefficients.items()}, value)
             for coefficients, value in stage_rows(bench, steps)]
    rows += [({n: PRIOR_WEIGHT}, PRIOR_WEIGHT) for n in PRIOR]
    factors = solve(rows, list(PRIOR))
    weights = {n: factors[n] * prior[n] for n in PRIOR}
    residual = max(abs(said(weights, work) / count - 1) for work, count in runs)
    return weights, residual


def step_names():
    """The names of host_sim/sweep/work.cpp, in their order."""
    text = (ROOT / "host_sim/sweep/work.cpp").read_text()
    return re.findall(r'"(\w+)"', re.search(r"kWorkNames = \{(.*?)\};", text, re.DOTALL)[1])


def runs_of(target, record, steps, calibration):
    runs = {name: (steps[name], scene["solve"]) for name, scene in record["scenes"].items()}
    runs.update({name: (run["work"], run["solve"][target]) for name, run in calibration.items()
                 if target in run["solve"]})
    return runs


def said(weights, work):
    return sum(weights[n] * work[n] for n in PRIOR)


def committed_weights():
    """{target: weights} of the table as it is."""
    rows = re.findall(r'\{"([\w-]+)", "\w+",\s*\{([^}]*)\}', TABLE.read_text())
    return {target: dict(zip(step_names(), map(float, numbers.split(",")))) for target, numbers in rows}


def check(measured, steps, calibration):
    weights = committed_weights()
    faults, runs_checked = [], 0
    for target, record in measured["targets"].items():
        for name, (work, count) in runs_of(target, record, steps, calibration).items():
            deviation = said(weights[target], work) / count - 1
            runs_checked += 1
            if abs(deviation) > LIMIT:
                faults.append(f"{TABLE.relative_to(ROOT)}: {target}, {name}: {100 * deviation:+.1f} % off what was "
                              "measured; run scripts/fit_costs.py")
    if faults or not runs_checked:
        sys.exit("\n".join(faults) or "fit_costs: nothing was measured")
    print(f"{runs_checked} measurements are reproduced within {100 * LIMIT:.0f} %")


def table(measured, steps, calibration):
    lines = ["// SPDX-License-Identifier: MIT",
             "// Made by scripts/fit_costs.py from firmware/measurements.json and calibration.json; do not edit.",
             "// clang-format off",
             '#include "host_sim/sweep/cost_model.h"', "", "namespace fixrad::host {", "",
             "const std::vector<CostModel>& cost_models() {", "  static const std::vector<CostModel> models = {"]
    for target, record in measured["targets"].items():
        runs = runs_of(target, record, steps, calibration)
        weights, residual = fit_target(list(runs.values()), record["bench"], steps)
        unit = next(iter(record["bench"].values()))["unit"]
        numbers = ", ".join(f"{weights[n]:.4g}" for n in step_names())
        engines = ", ".join(f'"{engine}"' for engine in engines_of(target, record, calibration))
        lines += [f'      {{"{target}", "{unit}",', f"       {{{numbers}}},",
                  f"       {residual:.4f}, {len(runs)}, {POINTER_BYTES.get(target, 4)}, {{{engines}}}}},"]
        print(f"{target:11} {len(runs):3} measurements, largest deviation {100 * residual:.1f} %", file=sys.stderr)
        for name, (work, count) in runs.items():
            print(f"    {name:24} {100 * (said(weights, work) / count - 1):+6.1f} %", file=sys.stderr)
    lines += ["  };", "  return models;", "}", "", "}  // namespace fixrad::host", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", default=ROOT / "build/host/host_sim/cli/count_work")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if set(step_names()) != set(PRIOR):
        sys.exit(f"fit_costs: host_sim/sweep/work.cpp names other steps than PRIOR: {set(step_names()) ^ set(PRIOR)}")
    measured = json.loads(MEASUREMENTS.read_text())
    calibration = current_calibration(options.tool)
    steps = measured_steps(options.tool, measured)
    if options.check:
        check(measured, steps, calibration)
        return
    text = table(measured, steps, calibration)
    partial = TABLE.with_name(TABLE.name + ".partial")
    partial.write_text(text)
    partial.rename(TABLE)


if __name__ == "__main__":
    main()
