# SPDX-License-Identifier: MIT
"""The text of docs/accuracy.md from what measure_accuracy.py has found."""

# What face means must keep to: mean over all faces, worst face; None: no bar.
BARS = {"large": (0.005, 0.05), "small": (0.01, 0.15), "tiny": (0.025, None)}
PAIR_BAR = 0.001
BUDGET_LINES = ("arithmetic", "form factors", "mesh", "total")
PROFILES = ("large", "small", "tiny")

HEAD = """# Accuracy

Made by `scripts/measure_accuracy.py`; do not edit. Tool: `build/host/fixrad` of the same tree.

A figure is the difference between mean radiosities of faces and the path-traced truth, in per cent, over the faces that
do not emit (all, where all do): **mean** is weighted by area, **worst** is the worst face of those with at least a tenth
of the scene's mean radiosity. Each scene is baked on three meshes, with the number of elements that the profile takes by
itself and with a tenth less and more (other numbers where the same mesh would result), and three figures are given: a
single mesh may be lucky. A scene holds its bar if every mesh does.

    build/host/fixrad truth SCENE --csv FILE
    build/host/fixrad bake SCENE --profile PROFILE --engine ENGINE [--elements N] --faces-csv FILE
    build/host/fixrad form-factors SCENE --engine ENGINE --csv FILE
    build/host/fixrad compare SCENE --profile PROFILE --json FILE

The scenes are those of [scenes/](../scenes/README.md) and twenty [random rooms](../scripts/random_rooms.py), seeds 1 to
20, which no setting was chosen by. The truth has an error of its own, the last column of each table: its standard error,
in the mean and at the face where it is largest.
"""

ENGINES = """
## Engines

*Mean / worst* in per cent; sample scenes: mean of the meshes and worst of all; random rooms: one mesh of all but the
default engine. Entries in *italics* are beyond the profile's bar, — is not taken.
"""

CLOSED_FORMS = """
## Closed forms

Form factors between two faces with nothing between them, `fixrad form-factors` with its own settings; the expected value
is the double contour integral. Each entry is *result, error in per cent*; **bold** is beyond {bar} %.

{pairs}
Radiosity by `fixrad bake`, default engine, in W/m²:

{cases}"""

BUDGET = """
## Error budget

`fixrad compare`, profile small, *mean / worst* in per cent. *Arithmetic*: the integer core against the same shots in
double, element radiosity over the scene's mean. The others compare face means. *Form factors*: those shots in double
against accurate form factors on the same mesh. *Mesh*: what is left with accurate form factors on that mesh. *Total*: the
integer core against the truth. The lines are sizes of differences: they need not add up, and *total* may be below *mesh*
where two errors cancel.

{table}"""

BAKES = """
## Shots and memory

Profile large, default engine and settings, first mesh.

{table}"""


def table(header, rows, right=()):
    """`right`: columns to align right."""
    rule = ["---:" if name in right else "---" for name in header]
    return "".join("| " + " | ".join(line) + " |\n" for line in [header, rule, *rows])


def per_cent(value, digits):
    return f"{100 * value:.{digits}f}"


def missed(measured, profile):
    """Names of the bars that a mesh of the scene is beyond; a scene that does not fit holds none and misses none."""
    mean_bar, worst_bar = BARS[profile]
    beyond = []
    if any(r.error.mean > mean_bar for r in measured.runs):
        beyond.append("mean")
    if worst_bar is not None and any(r.error.worst > worst_bar for r in measured.runs):
        beyond.append("worst")
    return beyond


def dots(values):
    return " · ".join(values)


def scene_table(members, profile, uncertainty):
    rows = []
    for m in members:
        if not m.runs:
            rows.append([m.scene, m.refusal.split(":")[0], "", "", "", "", ""])
            continue
        beyond, noise = missed(m, profile), uncertainty[m.scene]
        worst = max(m.runs, key=lambda r: r.error.worst)
        rows.append([m.scene, dots(str(r.elements) for r in m.runs), dots(per_cent(r.error.mean, 2) for r in m.runs),
                     dots(per_cent(r.error.worst, 1) for r in m.runs), worst.error.face,
                     "no: " + ", ".join(beyond) if beyond else "yes",
                     f"{per_cent(noise.mean, 2)} / {per_cent(noise.worst, 1)}"])
    return table(["scene", "elements", "mean %", "worst %", "worst face", "holds", "truth ± %"], rows)


def bar_text(profile):
    mean, worst = BARS[profile]
    return f"mean ≤ {100 * mean:g} %" + (f", worst ≤ {100 * worst:g} %" if worst is not None else "")


def largest(members, key, digits):
    run, scene = max(((r, m.scene) for m in members for r in m.runs), key=lambda pair: key(pair[0]))
    return f"{per_cent(key(run), digits)} % {scene}"


def average(values):
    return sum(values) / len(values)


def count_row(group, profile, members):
    counted = [m for m in members if m.runs]
    beyond = [missed(m, profile) for m in counted]
    total = len(counted)
    fits = f"{total} of {len(members)}"
    has_worst = BARS[profile][1] is not None
    return [profile, bar_text(profile), group, fits, f"**{sum(not b for b in beyond)} of {total}**",
            f"{sum('mean' not in b for b in beyond)}", f"{sum('worst' not in b for b in beyond)}" if has_worst else "",
            f"{per_cent(average([r.error.mean for m in counted for r in m.runs]), 2)} %",
            largest(counted, lambda r: r.error.mean, 2), largest(counted, lambda r: r.error.worst, 1)]


def summary(found):
    default = found["engines"][0]
    rows = [count_row(group, profile, found["results"][group, default, profile])
            for profile in PROFILES for group in found["groups"] if (group, default, profile) in found["results"]]
    text = f"\n## Summary\n\nDefault engine, `{default}`:\n\n"
    text += table(["profile", "bar", "scenes", "fit", "hold", "mean holds", "worst holds", "average mean", "largest mean",
                          "largest worst face"], rows)
    pairs = found["pairs"]
    text += "\nForm factors of closed-form pairs within " + f"{100 * PAIR_BAR:g} %: "
    text += ", ".join(f"`{e}` {sum(is_within(row, e) for row in pairs)} of {len(pairs)}" for e in found["engines"]) + ".\n"
    text += "\nAll engines, average of the mean errors of the scenes that each takes, first mesh; in brackets, the scenes that "
    return text + "hold their bar:\n\n" + engine_summary(found)


def engine_summary(found):
    columns = [(g, p) for g in found["groups"][:2] for p in PROFILES[:2]]
    rows = []
    for engine in found["engines"]:
        cells = []
        for group, profile in columns:
            if (group, engine, profile) not in found["results"]:
                cells.append("not measured")
                continue
            members = [m for m in found["results"][group, engine, profile] if m.runs]
            mean = average([m.runs[0].error.mean for m in members]) if members else 0
            holding = sum(not missed(m, profile) for m in members)
            cells.append(f"{per_cent(mean, 2)} % ({holding} of {len(members)})" if members else "none")
        rows.append([f"`{engine}`", *cells])
    return table(["engine", *(f"{group}, {profile}" for group, profile in columns)], rows)


def is_within(row, engine):
    _, expected, results = row
    return not isinstance(results[engine], str) and abs(results[engine] / expected - 1) <= PAIR_BAR


def pair_table(found):
    rows = []
    for row in found["pairs"]:
        name, expected, results = row
        cells = []
        for engine in found["engines"]:
            if isinstance(results[engine], str):
                cells.append("refused")
                continue
            text = f"{results[engine]:.6f}, {100 * (results[engine] / expected - 1):+.3f}"
            cells.append(text if is_within(row, engine) else f"**{text}**")
        rows.append([name, f"{expected:.6f}", *cells])
    return table(["pair", "expected", *(f"`{e}`" for e in found["engines"])], rows) + pair_refusals(found)


def case_table(found):
    rows = [[case.name, case.formula, f"{case.expected:.6f}",
             *(f"{values[p]:.6f}, {100 * (values[p] / case.expected - 1):+.3f}" for p in PROFILES)]
            for case, values in found["cases"]]
    return table(["scene", "known", "expected", *(f"{p}: result, error %" for p in PROFILES)], rows)


def engine_table(found, group, profile):
    """Scenes down, engines across."""
    engines = [e for e in found["engines"] if (group, e, profile) in found["results"]]
    rows = []
    for members in zip(*(found["results"][group, e, profile] for e in engines)):
        cells = []
        for m in members:
            if not m.runs:
                cells.append("—")
                continue
            mean = average([r.error.mean for r in m.runs])
            text = f"{per_cent(mean, 2)} / {per_cent(max(r.error.worst for r in m.runs), 1)}"
            cells.append(text if not missed(m, profile) else f"*{text}*")
        rows.append([members[0].scene, *cells])
    left_out = [f"`{e}`" for e in found["engines"] if e not in engines]
    note = f"\n{', '.join(left_out)}: not measured, minutes a scene.\n" if left_out else ""
    return table(["scene", *(f"`{e}`" for e in engines)], rows) + note


def refusals(found):
    """Which scenes are missing, once for each engine, profile and reason; a reason's figures are left out."""
    scenes = {}
    for (_, engine, profile), members in found["results"].items():
        for m in members:
            if not m.runs:
                scenes.setdefault((engine, profile, m.refusal.split(":")[0]), []).append(m.scene)
    return "".join(f"- `{engine}`, profile {profile}: {reason}: {', '.join(names)}\n"
                   for (engine, profile, reason), names in scenes.items())


def pair_refusals(found):
    """What the tool said of the pairs that it refused."""
    said = sorted({f"{name}: {result}" for name, _, results in found["pairs"] for result in results.values()
                   if isinstance(result, str)})
    return "".join(f"\nRefused: {line}.\n" for line in said)


def budget_table(first_column, records):
    """records: {name: record of `compare` or None}."""
    rows = []
    for name, record in records.items():
        if record is None:
            rows.append([name, "does not fit"] + [""] * (len(BUDGET_LINES) + 2))
            continue
        errors = {e["name"]: e for e in record["errors"]}
        rows.append([name, str(record["elements"]), str(record["resolution"]),
                     *(f"{per_cent(errors[k]['mean'], 3)} / {per_cent(errors[k]['worst'], 2)}" for k in BUDGET_LINES),
                     per_cent(record["truth_standard_error"], 3)])
    return table([first_column, "elements", "R", *(f"{line} %" for line in BUDGET_LINES), "truth ± %"], rows)


def bake_table(members):
    rows = []
    for m in members:
        for r in (run.record for run in m.runs[:1]):
            rows.append([m.scene, str(r["faces"]), str(r["channels"]), "yes" if r["closed"] else "no", str(r["elements"]),
                         str(r["shots"]), str(r["eyes"]), str(r["ram_bytes"]), str(r["rom_bytes"])])
    header = ["scene", "faces", "channels", "closed", "elements", "shots", "eyes", "RAM bytes", "flash bytes"]
    return table(header, rows, right=header[1:3] + header[4:])


def page(found):
    samples, rooms, turned = found["groups"]
    default, results = found["engines"][0], found["results"]
    text = HEAD + summary(found)
    text += CLOSED_FORMS.format(bar=f"{100 * PAIR_BAR:g}", pairs=pair_table(found), cases=case_table(found))
    for group, title in ((samples, "Sample scenes"), (rooms, "Random rooms"), (turned, "Cornell turned")):
        text += f"\n## {title}\n"
        if group == turned:
            text += "\nAbout the vertical axis; the device's grid and its rows then meet the same scene at other angles.\n"
        for profile in PROFILES:
            if (group, default, profile) in results:
                text += f"\n### {title}, profile {profile}: {bar_text(profile)}\n\n"
                text += scene_table(results[group, default, profile], profile, found["uncertainty"])
    text += ENGINES
    for group, title in ((samples, "Sample scenes"), (rooms, "Random rooms")):
        for profile in PROFILES[:2]:
            text += f"\n### {title}, all engines, profile {profile}\n\n" + engine_table(found, group, profile)
    if refusals(found):
        text += "\n### Not taken\n\n" + refusals(found)
    text += BUDGET.format(table=budget_table("scene", found["budget"]))
    return text + BAKES.format(table=bake_table(results[samples, default, "large"]))
