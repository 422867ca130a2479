#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write closed random rooms, so that accuracy is measured on scenes that nobody has tuned for.

    scripts/random_rooms.py FOLDER               seeds 1 to 20, as room_01.obj and room_01.mtl ...
    scripts/random_rooms.py FOLDER --seeds 3,7   these seeds

A room of random proportions has one to three lamps of random size in its ceiling and walls, and three to eight solids:
boxes, prisms and tilted panels, on the floor or in the air. Reflectances are 0.1 to 0.9, grey or coloured. A seed gives
the same bytes with every version of Python. Each room passes the checks of the sample scenes before it is written.
"""

import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

from scene_check import check
from scene_model import EIGHT, Scene, box, extrusion, frustum, inset, placed, room
from scene_writer import files_of

SEEDS = tuple(range(1, 21))
WALL_DISTANCE = 60  # mm that solids keep from walls and lamps
DISTANCE = 20       # mm between the bounding boxes of solids
# Cosine, sine and divisor of turns whose coordinates stay integers where lengths are multiples of the divisor.
TURNS = ((4, 3, 5), (3, 4, 5), (12, 5, 13), (15, 8, 17), (24, 7, 25), (20, 21, 29))


class Dice:
    """SplitMix64 (Steele, Lea and Flood 2014): the standard library promises no sequence across versions."""

    def __init__(self, seed):
        self.state = seed

    def bits(self):
        mask = (1 << 64) - 1
        self.state = (self.state + 0x9E3779B97F4A7C15) & mask
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return z ^ (z >> 31)

    def between(self, low, high):
        """An integer in [low, high]."""
        return low + (self.bits() >> 11) * (high - low + 1) // (1 << 53)

    def chance(self, per_cent):
        return self.between(1, 100) <= per_cent

    def pick(self, items):
        return items[self.between(0, len(items) - 1)]


def reflectance(dice, coloured):
    """Three values 0.10 to 0.90; colours come in hundredths, so that the text says them exactly."""
    level = dice.between(10, 90)
    if not coloured:
        return (level / 100,) * 3
    return tuple(dice.between(10, 90) / 100 for _ in range(3))


def lamp_colour(dice, coloured):
    level = dice.between(5, 60)
    if not coloured:
        return (level,) * 3
    return tuple(level * dice.between(40, 100) / 100 for _ in range(3))


def add_lamps(dice, shell, sides):
    """Rectangles set flush into the ceiling and walls, 15 to 60 % of a side long; faces are taken by their plane."""
    wanted, chosen = dice.between(1, 3), ["y+"] if dice.chance(75) else []
    walls = ["x-", "x+", "z-", "z+"]
    while len(chosen) < wanted:
        chosen.append(walls.pop(dice.between(0, len(walls) - 1)))
    for number, side in enumerate(chosen):
        axis, value = sides[side]
        index = next(i for i, f in enumerate(shell.faces) if all(c[axis] == value for c in f.corners))
        corners = shell.faces[index].corners
        low = [min(c[k] for c in corners) for k in range(3)]
        high = [max(c[k] for c in corners) for k in range(3)]
        for k in range(3):
            if k != axis:
                length = high[k] - low[k]
                size = length * dice.between(15, 60) // 100
                low[k] += dice.between(100, length - size - 100)
                high[k] = low[k] + size
        inset(shell, index, [tuple(high[k] if c[k] > min(p[k] for p in corners) else low[k] for k in range(3))
                             for c in corners], f"lamp_{number}")
    return len(chosen)


def solid(dice, name, extent):
    """A part at the origin's side, standing on y = 0, and whether it lacks its sole. extent: room sizes in mm."""
    stands = dice.chance(65)
    open_side = "y-" if stands else ""
    width, depth = (dice.between(extent[k] * 6 // 100, extent[k] * 22 // 100) for k in (0, 2))
    height = dice.between(extent[1] * 10 // 100, extent[1] * 55 // 100)
    kind = dice.between(1, 100)
    if kind <= 30:
        return box(name, name, (0, 0, 0), (width, height, depth), without=open_side), stands
    if kind <= 55:
        turn = dice.pick(TURNS)
        unit = turn[2]
        part = box(name, name, (0, 0, 0), (width // unit * unit, height, depth // unit * unit), without=open_side)
        return placed(part, (0, 0), turn), stands
    if kind <= 70:  # a roof-like prism: its section is a triangle
        profile = [(0, 0), (height, dice.between(0, depth)), (0, depth)]
        part = extrusion(name, name, profile, 0, width, without_edges=(2,) if stands else ())
        return part, stands
    if kind <= 80:
        scale = max(1, min(width, depth) // 16)
        caps = "y+" if stands else "y- y+"
        return frustum(name, name, EIGHT, (0, 0), [(0, scale), (height, max(1, scale * dice.between(50, 120) // 100))],
                       caps=caps), stands
    return tilted_panel(dice, name, width, max(height, depth)), False


def tilted_panel(dice, name, width, length):
    """A plate turned about a horizontal axis, 2 to 8 cm thick."""
    c, s, d = dice.pick(TURNS)
    along, thick = length // d, max(1, dice.between(20, 80) // d)
    profile = [(0, 0), (along * c, along * s), (along * c + thick * -s, along * s + thick * c), (thick * -s, thick * c)]
    profile = [(y, -z) for y, z in profile][::-1]
    return extrusion(name, name, profile, 0, width)


def bounds(part):
    corners = [c for f in part.faces for c in f.corners]
    return [[pick(c[k] for c in corners) for k in range(3)] for pick in (min, max)]


def moved(part, shift):
    for face in part.faces:
        face.corners = [tuple(a + b for a, b in zip(c, shift)) for c in face.corners]
    return part


def add_solids(dice, scene, extent):
    """Places solids at random; one that finds no room in forty tries is made anew."""
    taken, wanted = [], dice.between(3, 8)
    while len(taken) < wanted:
        part, stands = solid(dice, f"solid_{len(taken)}", extent)
        low, high = bounds(part)
        size = [b - a for a, b in zip(low, high)]
        if any(size[k] > extent[k] - 2 * WALL_DISTANCE for k in range(3)):
            continue
        for _ in range(40):
            at = [dice.between(WALL_DISTANCE, extent[k] - WALL_DISTANCE - size[k]) for k in range(3)]
            if stands:
                at[1] = 0
            if all(any(at[k] + size[k] + DISTANCE <= a[k] or b[k] + DISTANCE <= at[k] for k in range(3)) for a, b in taken):
                taken.append((at, [a + s for a, s in zip(at, size)]))
                scene.add(moved(part, tuple(a - b for a, b in zip(at, low))))
                break
    while True:
        point = tuple(dice.between(1, extent[k] - 1) for k in range(3))
        if not any(all(a[k] - 1 <= point[k] <= b[k] + 1 for k in range(3)) for a, b in taken):
            return point


def random_room(seed):
    """The Scene of a seed, in millimetres."""
    dice = Dice(seed)
    extent = (dice.between(2000, 7000), dice.between(2000, 4000), dice.between(2000, 7000))
    in_colour = dice.chance(60)  # a grey room takes one channel
    scene = Scene(f"room_{seed:02}", f"Random room, seed {seed}", {})
    shell = room("room", (0, 0, 0), extent, {"": "wall", "y-": "floor"})
    sides = {"x-": (0, 0), "x+": (0, extent[0]), "y+": (1, extent[1]), "z-": (2, 0), "z+": (2, extent[2])}
    lamps = add_lamps(dice, shell, sides)
    scene.add(shell)
    scene.free_point = add_solids(dice, scene, extent)
    for name in ["wall", "floor"] + [part.name for part in scene.parts[1:]]:
        scene.materials[name] = (reflectance(dice, in_colour and dice.chance(60)), (0, 0, 0))
    for number in range(lamps):
        scene.materials[f"lamp_{number}"] = (reflectance(dice, False), lamp_colour(dice, in_colour and dice.chance(50)))
    return scene


def write_rooms(folder, seeds=SEEDS):
    """Writes the rooms into an existing folder; returns the paths of their OBJ files."""
    paths = []
    for seed in seeds:
        scene = random_room(seed)
        check(scene)
        for name, content in files_of(scene, by="random_rooms.py").items():
            (folder / name).write_bytes(content)
        paths.append(folder / f"{scene.name}.obj")
    return paths


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seeds", type=lambda text: [int(s) for s in text.split(",")], default=SEEDS)
    arguments = parser.parse_args()
    try:
        arguments.folder.mkdir(parents=True, exist_ok=True)
        write_rooms(arguments.folder, arguments.seeds)
    except OSError as error:
        sys.exit(f"random_rooms: {error}")


if __name__ == "__main__":
    main()
