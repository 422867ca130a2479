# SPDX-License-Identifier: MIT
"""Scenes whose radiosity or form factors are known exactly, for measure_accuracy.py.

A form factor between polygons is a double contour integral (Sparrow 1963; Cohen and Wallace 1993, equation 4.17), here
in closed form along one contour and by quadrature to twelve digits along the other.
"""

import math
from dataclasses import dataclass

STEPS, REACH = 80, 3.2  # of the tanh-sinh rule: nodes a side, and where its weights end


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def edges(polygon):
    return zip(polygon, polygon[1:] + polygon[:1])


def area(polygon):
    total = [0.0, 0.0, 0.0]
    for a, b in edges([sub(p, polygon[0]) for p in polygon]):
        total = [t + c for t, c in zip(total, (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                               a[0] * b[1] - a[1] * b[0]))]
    return math.hypot(*total) / 2


def log_distance_along(point, begin, end):
    """The integral of ln |point - x| for x on the edge, by length."""
    length = math.dist(begin, end)
    along = dot(sub(point, begin), sub(end, begin)) / length
    height = math.sqrt(max(0.0, dot(sub(point, begin), sub(point, begin)) - along * along))
    if height < 1e-12 * length:
        height = 0.0

    def primitive(t):
        squared = height * height + t * t
        if squared == 0:
            return 0.0
        return t * math.log(squared) / 2 - t + (height * math.atan2(t, height) if height > 0 else 0.0)

    return primitive(length - along) - primitive(-along)


def tanh_sinh():
    """(position in (0, 1), weight): exact enough for ends where the integrand has a logarithm (Takahasi, Mori 1974)."""
    step = REACH / STEPS
    for k in range(-STEPS, STEPS + 1):
        u = math.pi / 2 * math.sinh(k * step)
        yield 0.5 * (1 + math.tanh(u)), step * math.pi / 4 * math.cosh(k * step) / math.cosh(u) ** 2


def form_factor(source, receiver):
    """F from `source` to `receiver`, averaged over the source: convex polygons that see all of each other."""
    total = 0.0
    for a, b in edges(source):
        for c, d in edges(receiver):
            cosine = dot(sub(b, a), sub(d, c)) / math.dist(c, d)  # times the length of the source's edge
            if abs(cosine) < 1e-15:
                continue
            for t, weight in tanh_sinh():
                point = tuple(p + t * (q - p) for p, q in zip(a, b))
                total += weight * cosine * log_distance_along(point, c, d)
    return abs(total) / (2 * math.pi * area(source))


# Faces: (material, corners), counter-clockwise seen from the lit side; materials: name -> (Kd, Ke).
def obj_text(stem, faces):
    lines = ["# Written by scripts/measure_accuracy.py", f"mtllib {stem}.mtl"]
    for _, corners in faces:
        lines += ["v " + " ".join(f"{c:.9f}" for c in corner) for corner in corners]
    count = 0
    for material, corners in faces:
        lines.append(f"usemtl {material}")
        lines.append("f " + " ".join(str(count + k) for k in range(1, len(corners) + 1)))
        count += len(corners)
    return "\n".join(lines) + "\n"


def mtl_text(materials):
    return "".join(f"newmtl {name}\nKd {kd} {kd} {kd}\nKe {ke} {ke} {ke}\n" for name, (kd, ke) in materials.items())


def write_scene(folder, stem, faces, materials):
    """Writes STEM.obj and STEM.mtl; returns the path of the OBJ."""
    (folder / f"{stem}.mtl").write_text(mtl_text(materials), encoding="ascii")
    path = folder / f"{stem}.obj"
    path.write_text(obj_text(stem, faces), encoding="ascii")
    return path


def rectangle(origin, u, v):
    """Corners counter-clockwise seen from u x v."""
    steps = ((0, 0), (1, 0), (1, 1), (0, 1))
    return [tuple(o + i * a + j * b for o, a, b in zip(origin, u, v)) for i, j in steps]


def tilted(degrees, distance=0.0):
    """A unit square that leans over the floor square 0 <= x, z <= 1, from its edge x = 0 or `distance` beyond."""
    angle = math.radians(degrees)
    return rectangle((-distance, 0, 0), (0, 0, 1), (math.cos(angle), math.sin(angle), 0))[::-1]


FLOOR = rectangle((0, 0, 0), (0, 0, 1), (1, 0, 0))


def pairs():
    """(name, source, receiver) of pairs without anything between them."""
    def ceiling(height, x=0.0, z=0.0, width=1.0, depth=1.0):
        return rectangle((x, height, z), (width, 0, 0), (0, 0, depth))

    yield "parallel unit squares, 1 apart", FLOOR, ceiling(1)
    yield "parallel unit squares, 0.25 apart", FLOOR, ceiling(0.25)
    yield "parallel, offset by 1 and 0.5, 1 apart", FLOOR, ceiling(1, 1, 0.5)
    yield "parallel, 1 × 1 and 2 × 0.5, 1 apart", FLOOR, ceiling(1, -0.5, 0.25, 2, 0.5)
    yield "perpendicular, common edge", FLOOR, tilted(90)
    yield "perpendicular, common edge, 1 × 1 and 1 × 2", FLOOR, rectangle((0, 0, 0), (0, 2, 0), (0, 0, 1))
    yield "perpendicular, 0.5 from the edge", FLOOR, tilted(90, 0.5)
    yield "tilted by 60°, common edge", FLOOR, tilted(60)
    yield "tilted by 120°, common edge", FLOOR, tilted(120)
    yield "tilted by 135°, 0.5 from the edge", FLOOR, tilted(135, 0.5)


@dataclass
class RadiosityCase:
    """A scene of which one radiosity is known; `value` takes the rows of `bake --faces-csv` (face, area, B)."""

    name: str
    formula: str
    expected: float
    value: object
    faces: list
    materials: dict
    options: tuple = ()


def box(x, y, z, materials):
    """A box seen from inside; materials of ceiling, floor and the four walls."""
    ceiling, floor, wall = materials
    return [(ceiling, rectangle((0, y, 0), (x, 0, 0), (0, 0, z))), (floor, rectangle((0, 0, 0), (0, 0, z), (x, 0, 0))),
            (wall, rectangle((0, 0, 0), (0, y, 0), (0, 0, z))), (wall, rectangle((x, 0, 0), (0, 0, z), (0, y, 0))),
            (wall, rectangle((0, 0, 0), (x, 0, 0), (0, y, 0))), (wall, rectangle((0, 0, z), (0, y, 0), (x, 0, 0)))]


def area_mean(rows):
    return sum(row["area"] * row["b"][0] for row in rows) / sum(row["area"] for row in rows)


def farthest_from(expected):
    return lambda rows: max((row["b"][0] for row in rows), key=lambda b: abs(b - expected))


def six_element_cube(rho):
    """Floor's B of a cube whose ceiling emits 1, every face one element: ceiling c, floor f, walls w are unknown."""
    opposite = form_factor(FLOOR, rectangle((0, 1, 0), (1, 0, 0), (0, 0, 1)))
    beside = (1 - opposite) / 4
    c, f, w = 1.0, 0.0, 0.0
    for _ in range(200):  # contracts by rho a step
        c, f, w = (1 + rho * (opposite * f + 4 * beside * w), rho * (opposite * c + 4 * beside * w),
                   rho * (beside * (c + f) + (opposite + 2 * beside) * w))
    return f


def radiosity_cases():
    furnace = {"furnace": (0.5, 1)}
    white = {"furnace": (0.9, 1)}
    plates = {"emitter": (0, 1), "reflector": (0.5, 0)}
    cube = {"lamp": (0.5, 1), "wall": (0.5, 0)}
    inside = ("furnace",) * 3
    yield RadiosityCase("furnace: cube, ρ = 0.5", "B = E/(1 − ρ) on each face", 2, farthest_from(2),
                        box(1, 1, 1, inside), furnace)
    yield RadiosityCase("furnace: box 4 × 2 × 1, ρ = 0.9", "B = E/(1 − ρ) on each face", 10, farthest_from(10),
                        box(4, 2, 1, inside), white)
    for name, corners in (("parallel unit squares, 1 apart", rectangle((0, 1, 0), (1, 0, 0), (0, 0, 1))),
                          ("perpendicular unit squares, common edge", tilted(90))):
        yield RadiosityCase(f"black lamp and reflector: {name}", "B = ρ E F", 0.5 * form_factor(corners, FLOOR),
                            lambda rows: rows[1]["b"][0], [("emitter", FLOOR), ("reflector", corners)], plates)
    yield RadiosityCase("cube, its ceiling emits, ρ = 0.5", "mean of all B = mean of all E/(1 − ρ)", 1 / 3, area_mean,
                        box(1, 1, 1, ("lamp", "wall", "wall")), cube)
    yield RadiosityCase("box 4 × 2 × 1, its ceiling emits, ρ = 0.9", "mean of all B = mean of all E/(1 − ρ)",
                        4 / 28 / 0.1, area_mean, box(4, 2, 1, ("lamp", "wall", "wall")),
                        {"lamp": (0.9, 1), "wall": (0.9, 0)})
    yield RadiosityCase("cube of six elements, its ceiling emits: floor", "6 × 6 system", six_element_cube(0.5),
                        lambda rows: rows[1]["b"][0], box(1, 1, 1, ("lamp", "wall", "wall")), cube, ("--elements", "6"))
