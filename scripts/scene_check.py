# SPDX-License-Identifier: MIT
"""What must hold of every sample scene, tested in exact integers where that is possible.

Each function raises AssertionError with the name of the scene and the part at fault.
"""

import math
import random
from collections import Counter

WALK_SEGMENTS = 1500  # about a second of pure Python for the largest scene


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def newell(corners):
    """Twice the area vector of a polygon, exact for integer corners."""
    total = (0, 0, 0)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        total = tuple(t + c for t, c in zip(total, cross(sub(a, corners[0]), sub(b, corners[0]))))
    return total


def is_inside(point, corners, normal):
    """Whether a point of the polygon's plane lies in it (border included); even-odd rule, so concave is fine."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    u, v = [k for k in range(3) if k != axis]
    inside = False
    for a, b in zip(corners, corners[1:] + corners[:1]):
        turn = (b[u] - a[u]) * (point[v] - a[v]) - (b[v] - a[v]) * (point[u] - a[u])
        if turn == 0 and dot(sub(point, a), sub(point, b)) <= 0:
            return True
        if (a[v] > point[v]) != (b[v] > point[v]) and (turn > 0) == (b[v] > a[v]):
            inside = not inside
    return inside


def check_faces(scene):
    used = set()
    for part in scene.parts:
        for face in part.faces:
            where = f"{scene.name}/{part.name}: {face.corners}"
            normal = newell(face.corners)
            assert any(normal), f"{where}: no area"
            assert len(set(face.corners)) == len(face.corners), f"{where}: repeated corner"
            assert all(dot(normal, sub(p, face.corners[0])) == 0 for p in face.corners), f"{where}: not planar"
            used.add(face.material)
    assert used == set(scene.materials), f"{scene.name}: materials {used ^ set(scene.materials)}"


def open_edges(part):
    """Directed edges that have no opposite within the part. A second use of the same directed edge is a fault."""
    edges = Counter((a, b) for f in part.faces for a, b in zip(f.corners, f.corners[1:] + f.corners[:1]))
    assert max(edges.values()) == 1, f"{part.name}: two faces run the same way along an edge"
    return [edge for edge in edges if (edge[1], edge[0]) not in edges]


def check_closed(scene):
    """Rooms have no open edge; an open edge of a solid lies in a face of another part (it stands on something)."""
    for part in scene.parts:
        for a, b in open_edges(part):
            assert not (part.room and scene.closed), f"{scene.name}/{part.name}: open edge {a} {b}"
            middle = tuple((p + q) / 2 for p, q in zip(a, b))
            others = [f for other in scene.parts if other is not part for f in other.faces]
            assert part.room or any(
                all(dot(newell(f.corners), sub(p, f.corners[0])) == 0 for p in (a, b))
                and all(is_inside(p, f.corners, newell(f.corners)) for p in (a, middle, b)) for f in others
            ), f"{scene.name}/{part.name}: edge {a} {b} touches nothing"


def check_orientation(scene):
    """Signed volume: positive for solids, negative for rooms. An axis counts if the open sides do not matter to it."""
    for part in scene.parts:
        if part.room and not scene.closed:
            continue
        signs = set()
        for axis in range(3):
            area, volume = 0, 0
            for face in part.faces:
                base = face.corners[0]
                for a, b in zip(face.corners[1:], face.corners[2:]):
                    share = cross(sub(a, base), sub(b, base))[axis]
                    area += share
                    volume += share * (base[axis] + a[axis] + b[axis])
            if area == 0 and volume != 0:
                signs.add(volume > 0)
        assert signs == {not part.room}, f"{scene.name}/{part.name}: orientation {signs}"


def are_apart(first, second):
    """Whether a plane of one part, or of an axis, has all corners of the other one on its outer side."""
    ones = [c for f in first.faces for c in f.corners]
    others = [c for f in second.faces for c in f.corners]
    for axis in range(3):
        if max(c[axis] for c in ones) <= min(c[axis] for c in others):
            return True
        if max(c[axis] for c in others) <= min(c[axis] for c in ones):
            return True
    return any(all(dot(newell(f.corners), sub(c, f.corners[0])) >= 0 for c in corners)
               for part, corners in ((first, others), (second, ones)) for f in part.faces)


def check_apart(scene):
    solids = [part for part in scene.parts if not part.room]
    for i, first in enumerate(solids):
        for second in solids[:i]:
            assert are_apart(first, second), f"{scene.name}: {first.name} and {second.name} overlap"


def nearest_hit(origin, direction, triangles):
    """(distance, index, whether it is a front face) of the nearest triangle, or None."""
    best = None
    for index, (a, e1, e2, _) in enumerate(triangles):
        p = cross(direction, e2)
        determinant = dot(e1, p)
        if abs(determinant) < 1e-9:
            continue
        s = sub(origin, a)
        u = dot(s, p) / determinant
        if u < 0 or u > 1:
            continue
        q = cross(s, e1)
        v = dot(direction, q) / determinant
        distance = dot(e2, q) / determinant
        if v < 0 or u + v > 1 or distance < 1e-6 or (best and distance >= best[0]):
            continue
        best = (distance, index, determinant > 0)
    return best


def random_direction(dice):
    while True:
        d = tuple(dice.uniform(-1, 1) for _ in range(3))
        if 0.01 < dot(d, d) <= 1:
            return d


def ears(corners):
    """Triangles of a simple polygon by ear clipping."""
    normal, left = newell(corners), list(corners)
    while len(left) > 3:
        for i, b in enumerate(left):
            a, c = left[i - 1], left[(i + 1) % len(left)]
            rest = [p for p in left if p not in (a, b, c)]
            if dot(cross(sub(b, a), sub(c, b)), normal) > 0 and not any(is_inside(p, [a, b, c], normal) for p in rest):
                yield a, b, c
                left.pop(i)
                break
    yield tuple(left)


def check_walk(scene):
    """A walk of light from a point in the air meets front faces only, and in a closed scene never ends."""
    triangles = [(a, sub(b, a), sub(c, a), newell([a, b, c]))
                 for part in scene.parts for face in part.faces for a, b, c in ears(face.corners)]
    dice = random.Random(scene.name)
    origin = tuple(map(float, scene.free_point))
    normal = None
    for _ in range(WALK_SEGMENTS):
        direction = random_direction(dice)
        if normal and dot(direction, normal) < 0:
            direction = tuple(-c for c in direction)
        hit = nearest_hit(origin, direction, triangles)
        if hit is None:
            assert not scene.closed, f"{scene.name}: light escapes from {origin} along {direction}"
            origin, normal = tuple(map(float, scene.free_point)), None
            continue
        distance, index, front = hit
        assert front, f"{scene.name}: a back face is seen from {origin} along {direction}"
        length = math.sqrt(dot(triangles[index][3], triangles[index][3]))
        normal = tuple(c / length for c in triangles[index][3])
        origin = tuple(o + distance * d + 1e-4 * n for o, d, n in zip(origin, direction, normal))


def check(scene):
    for test in (check_faces, check_closed, check_orientation, check_apart, check_walk):
        test(scene)
    for name, (reflectance, emission) in scene.materials.items():
        assert all(0 <= c < 1 for c in reflectance) and all(c >= 0 for c in emission), f"{scene.name}: {name}"
