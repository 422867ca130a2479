#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure the error budget of the sample scenes and write it where readers look: docs/accuracy.md as a whole, and
the passages of README.md that stand between <!-- generated: NAME --> and <!-- end generated -->. Bakes the pictures
in docs/images/ too.

    scripts/measure_accuracy.py                       everything, with build/host/fixrad; some minutes
    scripts/measure_accuracy.py --tool PATH           another build of the tool
    scripts/measure_accuracy.py --profiles tiny,large other profiles for the table of all scenes
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINES = ("arithmetic", "form factors", "mesh", "total")
SHOWN = "scenes/cornell.obj"  # the scene of the README's tables
SHOWN_PROFILES = ("tiny", "small", "medium", "large")
PICTURES = ("cornell", "furnished_room")
DOES_NOT_FIT = "does not fit"

HEAD = """# Accuracy

Made by `scripts/measure_accuracy.py`; do not edit. Tool: `build/host/fixrad` of the same tree.

Commands, for each scene and profile:

    build/host/fixrad compare SCENE --profile PROFILE --json FILE
    build/host/fixrad bake SCENE -o FILE.json

## Error budget

Each entry is *mean / worst* in per cent. *Arithmetic*: the integer core against the same shots in double, element
radiosity, over the scene's mean radiosity. The others compare mean radiosities of faces that do not emit: *mean*
weighted by area, *worst* of the faces that have at least a tenth of the mean radiosity. *Form factors*: those shots in
double against accurate form factors on the same mesh. *Mesh*: accurate form factors on that mesh against the truth.
*Total*: the integer core against the truth. The lines are sizes of differences, so they need not add up, and *total*
may be below *mesh* where two errors cancel. The truth is path traced; its standard error, at most, is the last column:
a figure below it says only that the error is not larger than that.
"""

BAKE_HEAD = """
## Baking time

`build/host/fixrad bake SCENE` with default settings (profile large), one after another. The seconds are those of the
solver alone, on the machine that ran the script; all other columns are the same everywhere.
"""


class Failure(Exception):
    """A command ended as it should not."""


def run(tool, *arguments):
    """Output of the tool; DOES_NOT_FIT if that is what it says; Failure for any other error."""
    done = subprocess.run([tool, *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode == 1 and DOES_NOT_FIT in done.stderr:
        return DOES_NOT_FIT
    if done.returncode != 0:
        raise Failure(f"{tool} {' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def compare(tool, scene, profile):
    """The JSON record of `compare`, or None where the scene does not fit the profile."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "budget.json"
        output = run(tool, "compare", scene, "--profile", profile, "--quiet", "--json", str(file))
        print(f"compared {scene}, {profile}", file=sys.stderr)
        return None if output == DOES_NOT_FIT else json.loads(file.read_text())


def bake(tool, scene):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bake.json"
        run(tool, "bake", scene, "--quiet", "-o", str(file))
        return json.loads(file.read_text())


def error_of(record, name):
    return next(e for e in record["errors"] if e["name"] == name)


def budget_cells(record):
    cells = [str(record["elements"]), str(record["resolution"])]
    for name in LINES:
        error = error_of(record, name)
        cells.append(f"{100 * error['mean']:.3f} / {100 * error['worst']:.2f}")
    return cells + [f"{100 * record['truth_standard_error']:.3f}"]


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def budget_table(first_column, records):
    """records: pairs of a row's name cells and its record or None."""
    header = [*first_column, "elements", "R", *(f"{name} %" for name in LINES), "truth ± %"]
    misfit = ["does not fit"] + [""] * (len(LINES) + 2)
    return table(header, [[*names, *(budget_cells(r) if r else misfit)] for names, r in records])


def bake_table(records):
    header = ["scene", "faces", "channels", "closed", "elements", "shots", "eyes", "RAM bytes", "flash bytes",
              "seconds"]
    rows = []
    for scene, r in records:
        rows.append([scene, str(r["faces"]), str(r["channels"]), "yes" if r["closed"] else "no", str(r["elements"]),
                     str(r["shots"]), str(r["eyes"]), str(r["ram_bytes"]), str(r["rom_bytes"]), f"{r['seconds']:.2f}"])
    return table(header, rows)


def memory_table(tool):
    """The table of `fixrad info`, which follows the only empty line of its output."""
    return "```\n" + run(tool, "info", SHOWN, "--quiet").split("\n\n", 1)[1].rstrip("\n") + "\n```\n"


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


def measure(tool, profiles):
    scenes = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "scenes").glob("*.obj"))
    wanted = [(s, p) for s in scenes for p in profiles]
    wanted += [(SHOWN, p) for p in SHOWN_PROFILES if (SHOWN, p) not in wanted]
    # Two at a time: some parts of a comparison use one core only. Its times are not written down.
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        compared = dict(zip(wanted, pool.map(lambda w: compare(tool, *w), wanted)))
    for name in PICTURES:
        run(tool, "bake", f"scenes/{name}.obj", "--quiet", "-o", f"docs/images/{name}.png")
    bakes = [(pathlib.Path(s).stem, bake(tool, s)) for s in scenes]
    page = HEAD
    for profile in profiles:
        rows = [([pathlib.Path(s).stem], compared[s, profile]) for s in scenes]
        page += f"\n### Profile {profile}\n\n" + budget_table(["scene"], rows)
    write(ROOT / "docs/accuracy.md", page + BAKE_HEAD + "\n" + bake_table(bakes))
    shown = [([p], compared[SHOWN, p]) for p in SHOWN_PROFILES]
    replace_generated(ROOT / "README.md", {"memory": memory_table(tool), "accuracy": budget_table(["profile"], shown)})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", default=str(ROOT / "build/host/fixrad"))
    parser.add_argument("--profiles", default="small,large", help="of the table of all scenes")
    arguments = parser.parse_args()
    try:
        measure(str(pathlib.Path(arguments.tool).resolve()), arguments.profiles.split(","))
    except (Failure, OSError) as error:
        sys.exit(f"measure_accuracy: {error}")


if __name__ == "__main__":
    main()
