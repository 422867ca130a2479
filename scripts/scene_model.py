# SPDX-License-Identifier: MIT
"""Solids, rooms and the OBJ/MTL writer of make_scenes.py.

Coordinates are integers in millimetres, so that shared corners are equal and planarity can be tested exactly.
Faces are counter-clockwise seen from the lit side; y is up.
"""

from dataclasses import dataclass, field

# A nearly regular 12-gon and octagon with integer corners: scaled by integers, frusta keep exactly planar sides.
TWELVE = [(8, 0), (7, 4), (4, 7), (0, 8), (-4, 7), (-7, 4), (-8, 0), (-7, -4), (-4, -7), (0, -8), (4, -7), (7, -4)]
EIGHT = [(7, 3), (3, 7), (-3, 7), (-7, 3), (-7, -3), (-3, -7), (3, -7), (7, -3)]

# Corners of a box's six sides; 0 takes the lower bound of an axis, 1 the upper one. Outward.
BOX_SIDES = {
    "x-": [(0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)],
    "x+": [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
    "y-": [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
    "y+": [(0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)],
    "z-": [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
    "z+": [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
}


@dataclass
class Face:
    material: str
    corners: list  # of (x, y, z) in mm
    smooth: int = 0  # OBJ smoothing group


@dataclass
class Part:
    """One connected piece. `room` parts enclose the air, all others are solids in it."""

    name: str
    faces: list
    room: bool = False


@dataclass
class Scene:
    name: str
    about: str
    materials: dict  # name -> (Kd, Ke)
    parts: list = field(default_factory=list)
    free_point: tuple = None  # a point in the air, where the check's walk of light begins
    closed: bool = True  # no light escapes
    shine: dict = field(default_factory=dict)  # name -> (Ks, Ns, illum): what pictures show beside diffuse light

    def add(self, *parts):
        self.parts.extend(parts)


def add(point, vector):
    return tuple(p + v for p, v in zip(point, vector))


def quad_of_box(side, low, high):
    return [tuple((low, high)[pick][axis] for axis, pick in enumerate(corner)) for corner in BOX_SIDES[side]]


def box(name, material, low, high, without="", materials=None):
    """A solid box; `without` names sides left out because they touch something, as in "y- z+"."""
    chosen = materials or {}
    return Part(name, [Face(chosen.get(side, material), quad_of_box(side, low, high))
                       for side in BOX_SIDES if side not in without.split()])


def room(name, low, high, materials):
    """A box seen from inside; `materials` maps a side of the box, or "" for the others, to a material."""
    return Part(name, [Face(materials.get(side, materials[""]), quad_of_box(side, low, high)[::-1])
                       for side in BOX_SIDES], room=True)


def frustum(name, material, directions, centre, rings, caps="y- y+", smooth=0, cap_material=None):
    """A solid of rotation over an n-gon; rings = [(height, scale)...] upwards, all in mm."""
    def ring(height, scale):
        return [(centre[0] + scale * x, height, centre[1] + scale * z) for x, z in directions]

    faces = []
    for (y0, k0), (y1, k1) in zip(rings, rings[1:]):
        low, high = ring(y0, k0), ring(y1, k1)
        for i in range(len(directions)):
            j = (i + 1) % len(directions)
            faces.append(Face(material, [low[j], low[i], high[i], high[j]], smooth))
    if "y-" in caps:
        faces.append(Face(cap_material or material, ring(*rings[0])))
    if "y+" in caps:
        faces.append(Face(cap_material or material, ring(*rings[-1])[::-1]))
    return Part(name, faces)


def extrusion(name, material, profile, x0, x1, without_edges=()):
    """A profile of (y, z) corners, counter-clockwise seen from +x, swept from x0 to x1."""
    near = [(x0, y, z) for y, z in profile]
    far = [(x1, y, z) for y, z in profile]
    faces = [Face(material, far), Face(material, near[::-1])]
    for i in range(len(profile)):
        j = (i + 1) % len(profile)
        if i not in without_edges:
            faces.append(Face(material, [near[i], near[j], far[j], far[i]]))
    return Part(name, faces)


def collar(face, inner):
    """Quadrilaterals between the outline of a face and a hole in it that has as many corners in the same order."""
    outer = face.corners
    following = list(range(1, len(outer))) + [0]
    return [Face(face.material, [outer[i], outer[j], inner[j], inner[i]]) for i, j in enumerate(following)]


def inset(part, index, inner, material, shift=(0, 0, 0), side_material=None):
    """Set a panel into face `index`: flush, or moved by `shift` with sides (a recess, or a block on the floor)."""
    face = part.faces.pop(index)
    if match_turn(face.corners, inner) != list(inner):
        inner = match_turn(face.corners, inner)
    part.faces += collar(face, inner)
    moved = [add(corner, shift) for corner in inner]
    if any(shift):
        for i, a in enumerate(inner):
            j = (i + 1) % len(inner)
            part.faces.append(Face(side_material or material, [a, inner[j], moved[j], moved[i]]))
    part.faces.append(Face(material, moved))


def match_turn(outer, inner):
    """The corners of inner in the turning sense of outer, beginning with the one nearest to outer[0]."""
    def distance(corner):
        return sum((a - b) ** 2 for a, b in zip(corner, outer[0]))

    def normal(polygon):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = polygon[:3]
        u, v = (bx - ax, by - ay, bz - az), (cx - bx, cy - by, cz - bz)
        return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])

    same = sum(a * b for a, b in zip(normal(outer), normal(inner))) > 0
    inner = list(inner) if same else list(inner)[::-1]
    first = min(range(len(inner)), key=lambda i: distance(inner[i]))
    return inner[first:] + inner[:first]


def placed(part, origin, turn=(1, 0, 1)):
    """The part turned about y by the angle with cosine c/d and sine s/d, then moved to origin (x, z).

    turn = (c, s, d) is a Pythagorean triple; every coordinate must come out as an integer.
    """
    c, s, d = turn

    def move(corner):
        x, y, z = corner
        u, v = c * x + s * z, c * z - s * x
        assert u % d == 0 and v % d == 0, f"{part.name}: ({x}, {z}) leaves the millimetre grid"
        return (origin[0] + u // d, y, origin[1] + v // d)

    return Part(part.name, [Face(f.material, [move(p) for p in f.corners], f.smooth) for f in part.faces], part.room)


def triangle_count(scene):
    return sum(len(face.corners) - 2 for part in scene.parts for face in part.faces)
