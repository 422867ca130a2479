# SPDX-License-Identifier: MIT
"""The text of docs/meshing.md and its plots from what measure_meshing.py has found."""

import math

from accuracy_page import per_cent, table

DISPLAYS = {"flat": "flat elements", "mean": "mean round each vertex", "corners": "gather at each corner",
            "gather": "gather at each vertex",
            "at the point": "gather at the point"}
POINT_BAR = 0.05
# (better kind, worse kind): what the better one promises.
RATIO_BARS = {("adaptive", "uniform"): 1.8, ("discontinuity", "adaptive"): 1.5}
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")  # told apart by the colour-blind too (Okabe & Ito)
DASHES = {"gather": "", "corners": ' stroke-dasharray="6 4"'}
SHORT = {"gather": "vertices", "corners": "corners"}
COMPARED = ("corners", "gather", "at the point")  # by what a better mesh is judged

HEAD = """# Meshes, and what one looks at

Made by `scripts/measure_meshing.py`; do not edit. Tool: `build/host/fixrad` of the same tree, profile large.

    build/host/fixrad compare SCENE --elements N --points 1000 --points-only [--points-paths 32768]

Irradiance at 1,000 points of surfaces that reflect and do not emit, spread evenly by area, against path-traced truth.
Points in or under something are left out: nobody sees them. The **error** is the sum of |difference| over the sum of
irradiance, all points and channels. Irradiance is told in five ways, all from the same solution:

- *flat elements*: radiosity of the element, less its emission, over its reflectance;
- *mean round each vertex*: interpolated between vertex colours that are the mean of the elements that meet there;
- *gather at each corner*: between vertex colours that were gathered from all elements by the core's own hemisphere, at
  the corners of the elements and nowhere else (`--display-edge 1`): here the mesh itself is what one looks at;
- *gather at each vertex*: the same on triangles that are cut where the gathered light bends: what `fixrad bake` writes;
- *gather at the point*: the same hemisphere at each of the 1,000 points. Interpolation can hardly be better.
"""

TABLE = """
## {elements} elements, every sample scene

Error in per cent; for the displayed one its median and 95th percentile over points too. The bar is {bar} % from vertex
colours alone; **bold** is beyond it. *Face means* is the error of [accuracy.md](accuracy.md) on this mesh, mean / worst;
*truth ±* the standard error of the truth at points. A scene has at least as many elements as faces.

{table}"""

CURVE = """
## {name}: error against elements

![Error at points against elements](images/meshing_{name}.svg)

{table}"""

STAGES = """
## One scene at three stages

The Cornell box as the lecture's slides show it: few elements, many, and about as many where the light needs them.
"""

RATIOS = """
## What a better mesh saves

*Elements for the same error*: how many the plainer mesh needs, between two of its measured points, over those of the
better one at about {elements}; *error at equal number*: of the plainer mesh over the better one's.

{table}"""


def label(count):
    return f"{count:g}"


def point_table(found):
    rows = []
    for name in found["scenes"]:
        for kind in found["kinds"]:
            run = found["table"][name, kind]
            if isinstance(run, str):
                rows.append([name, kind, run.split(":")[0], *[""] * 8])
                continue
            shown = run.points["gather"]
            mean = per_cent(shown["mean"], 2)
            rows.append([name, kind, str(run.elements), str(run.vertices),
                         per_cent(run.points["flat"]["mean"], 1), per_cent(run.points["mean"]["mean"], 1),
                         f"**{mean}**" if shown["mean"] > POINT_BAR else mean,
                         f"{per_cent(shown['median'], 1)} / {per_cent(shown['percentile95'], 1)}",
                         per_cent(run.points["at the point"]["mean"], 2),
                         f"{per_cent(run.faces.mean, 2)} / {per_cent(run.faces.worst, 1)}",
                         per_cent(run.uncertainty, 2)])
    header = ["scene", "mesh", "elements", "vertices", "flat %", "mean %", "gather %", "median / 95 %", "at point %",
              "face means %", "truth ± %"]
    return table(header, rows, header[2:])


def curve_table(kinds):
    rows = [[kind, str(r.elements), *[per_cent(r.points[d]["mean"], 2) for d in DISPLAYS],
             f"{per_cent(r.faces.mean, 2)} / {per_cent(r.faces.worst, 1)}"]
            for kind, runs in kinds.items() for r in runs]
    header = ["mesh", "elements", *[name + " %" for name in DISPLAYS.values()], "face means %"]
    return table(header, rows, header[1:])


def ratio_table(found):
    rows = []
    for scene, display, better, worse, elements, same, error in found["ratios"]:
        rows.append([scene, DISPLAYS[display], f"{better} against {worse}", str(elements),
                     f"{same / elements:.2f} ×" if same else "—", f"{error:.2f} ×",
                     f"≥ {RATIO_BARS[better, worse]} × " + ("fewer elements" if worse == "uniform" else "lower error")])
    header = ["scene", "irradiance from", "meshes", "elements", "elements for the same error", "error at equal number",
              "bar"]
    return table(header, rows, ("elements", "elements for the same error", "error at equal number"))


def stage_text(stages):
    text = STAGES
    for number, kind, files in stages:
        text += f"\nAbout {number:,} elements, {kind}:\n\n" + " ".join(
            f"![About {number:,} elements]({file})" for file in files) + "\n"
    return text


def page(found):
    text = HEAD + TABLE.format(elements=250, bar=label(100 * POINT_BAR), table=point_table(found))
    for name, kinds in found["curves"].items():
        text += CURVE.format(name=name, table=curve_table(kinds))
    if found["ratios"]:
        text += RATIOS.format(elements=250, table=ratio_table(found))
    return text + stage_text(found["stages"])


class Axes:
    """Log-log axes of an SVG."""

    width, height, left, right, top, bottom = 720, 440, 70, 210, 20, 50

    def __init__(self, xs, ys):
        self.x0, self.x1 = math.log(min(xs)), math.log(max(xs))
        self.y0, self.y1 = math.log(min(ys) / 1.15), math.log(max(ys) * 1.15)

    def x(self, value):
        return self.left + (math.log(value) - self.x0) / (self.x1 - self.x0) * (self.width - self.left - self.right)

    def y(self, value):
        return self.top + (self.y1 - math.log(value)) / (self.y1 - self.y0) * (self.height - self.top - self.bottom)

    def frame(self, xs):
        low, high = math.exp(self.y0), math.exp(self.y1)
        right, floor = self.width - self.right, self.height - self.bottom
        text = ""
        for tick in (t * 10.0 ** d for d in range(-4, 3) for t in (1, 2, 5)):
            if low <= tick <= high:
                text += (f'<line x1="{self.left}" x2="{right}" y1="{self.y(tick):.1f}" y2="{self.y(tick):.1f}" '
                         f'stroke="#ddd"/><text x="{self.left - 8}" y="{self.y(tick) + 4:.1f}" '
                         f'text-anchor="end">{100 * tick:g} %</text>\n')
        for tick in xs:
            text += (f'<line x1="{self.x(tick):.1f}" x2="{self.x(tick):.1f}" y1="{self.top}" y2="{floor}" stroke="#ddd"/>'
                     f'<text x="{self.x(tick):.1f}" y="{floor + 18}" text-anchor="middle">{tick}</text>\n')
        return text + (f'<text x="{(self.left + right) / 2}" y="{self.height - 10}" text-anchor="middle">elements</text>\n'
                       f'<rect x="{self.left}" y="{self.top}" width="{right - self.left}" '
                       f'height="{floor - self.top}" fill="none" stroke="#888"/>\n')


def plot(name, kinds):
    """Error at points against elements, a line for each kind of mesh and two displays, as SVG."""
    shown = [(kind, display, runs) for kind, runs in kinds.items() if runs for display in DASHES]
    axes = Axes([r.elements for _, _, runs in shown for r in runs],
                [r.points[display]["mean"] for _, display, runs in shown for r in runs] + [POINT_BAR])
    ticks = sorted({r.elements for r in next(iter(kinds.values()))})
    text = axes.frame(ticks)
    for line, (kind, display, runs) in enumerate(shown):
        colour = COLOURS[list(kinds).index(kind) % len(COLOURS)]
        spots = [(axes.x(r.elements), axes.y(r.points[display]["mean"])) for r in runs]
        text += (f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in spots)}" fill="none" stroke="{colour}" '
                 f'stroke-width="2"{DASHES[display]}/>\n')
        text += "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in spots) + "\n"
        at, down = axes.width - axes.right + 14, axes.top + 16 + 22 * line
        text += (f'<line x1="{at}" x2="{at + 28}" y1="{down}" y2="{down}" stroke="{colour}" stroke-width="2"'
                 f'{DASHES[display]}/><text x="{at + 34}" y="{down + 4}">{kind}, {SHORT[display]}</text>\n')
    bar = axes.y(POINT_BAR)
    text += (f'<line x1="{axes.left}" x2="{axes.width - axes.right}" y1="{bar:.1f}" y2="{bar:.1f}" stroke="#444" '
             f'stroke-dasharray="2 3"/><text x="{axes.left + 6}" y="{bar - 5:.1f}">bar: 5 %</text>\n')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {axes.width} {axes.height}" font-family="sans-serif" '
            f'font-size="12"><title>{name}: error of irradiance at points against elements</title>\n'
            f'<rect width="{axes.width}" height="{axes.height}" fill="white"/>\n{text}</svg>\n')
