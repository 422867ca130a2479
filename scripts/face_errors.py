# SPDX-License-Identifier: MIT
"""Mean radiosities of faces against path-traced truth, as `fixrad compare` judges them."""

import csv
from dataclasses import dataclass


@dataclass
class FaceError:
    """Relative errors; `face` is the number and material of the worst."""

    mean: float
    worst: float
    face: str


def read_faces(path):
    """Rows of `bake --faces-csv` and `truth --csv`: {"face", "material", "area", "b": [3], "error": [3] or None}."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{"face": int(r["face"]), "material": r["material"], "area": float(r["area"]),
                 "emits": r.get("emits") == "1", "b": [float(r["B_" + c]) for c in "rgb"],
                 "error": [float(r["error_" + c]) for c in "rgb"] if "error_r" in r else None}
                for r in csv.DictReader(file)]


def judged(truth):
    """Faces that do not emit; all where all do, as in a furnace."""
    dark = [row for row in truth if not row["emits"]]
    return dark or truth


def compare_faces(deviations, truth):
    """deviations [face]: |a - b| summed over channels, in the order of `truth`."""
    faces = judged(truth)
    light = sum(t["area"] * sum(t["b"]) for t in faces)
    area = sum(t["area"] for t in faces)
    if light <= 0:
        return FaceError(0, 0, "none")
    mean = sum(t["area"] * deviations[t["face"]] for t in faces) / light
    bright = [t for t in faces if t["area"] > 0 and sum(t["b"]) >= 0.1 * light / area]
    worst = max(bright, key=lambda t: deviations[t["face"]] / sum(t["b"]))
    return FaceError(mean, deviations[worst["face"]] / sum(worst["b"]), f"{worst['face']}, {worst['material']}")


def error_of(baked, truth):
    """Error of a bake's faces."""
    if len(baked) != len(truth):
        raise ValueError(f"{len(baked)} faces were baked, the truth has {len(truth)}")
    return compare_faces([sum(abs(x - y) for x, y in zip(b["b"], t["b"])) for b, t in zip(baked, truth)], truth)


def uncertainty_of(truth):
    """The same of the truth's standard errors: what a FaceError can be by chance."""
    return compare_faces([sum(t["error"]) for t in truth], truth)
