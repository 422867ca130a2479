#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the sample scenes into scenes/ (all but cornell.obj, which is published data).

    python3 scripts/make_scenes.py            check every scene, then write the files that differ
    python3 scripts/make_scenes.py --check    check every scene; exit 1 if a file differs from what would be written

Deterministic; Python's standard library only.
"""

import os
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # leaves nothing behind in scripts/

from furnished_room import furnished_room
from scene_check import check
from scene_model import TWELVE, Face, Part, Scene, box, frustum, inset, placed, room, triangle_count
from scene_writer import files_of

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"
BLACK = (0, 0, 0)


def grey(reflectance, emission=0):
    return (reflectance,) * 3, (emission,) * 3


def side_of(part, axis, value):
    return next(i for i, f in enumerate(part.faces) if all(c[axis] == value for c in f.corners))


def closed_box():
    scene = Scene("closed_box", "Furnace: unit cube, every face emits 1 W/m^2, rho 0.5: B = 2 everywhere",
                  {"furnace": grey(0.5, 1)}, free_point=(500, 500, 500))
    scene.add(room("cube", (0, 0, 0), (1000, 1000, 1000), {"": "furnace"}))
    return scene


def unit_cube_one_emitter():
    scene = Scene("unit_cube_one_emitter", "Unit cube, rho 0.5, the ceiling emits 1 W/m^2",
                  {"wall": grey(0.5), "emitter": grey(0.5, 1)}, free_point=(500, 500, 500))
    scene.add(room("cube", (0, 0, 0), (1000, 1000, 1000), {"": "wall", "y+": "emitter"}))
    return scene


def small_lamp():
    """59 m^2 of room; the lamp has 0.1 % of that. The block grows out of the floor: the mesh is conforming."""
    scene = Scene("small_lamp", "Room with rho 0.8 and a lamp of 0.1 % of its area; a block casts a shadow",
                  {"wall": grey(0.8), "block": grey(0.5), "lamp": grey(0.1, 1000)}, free_point=(500, 1500, 500))
    shell = room("room", (0, 0, 0), (4000, 2500, 3000), {"": "wall"})
    inset(shell, side_of(shell, 1, 2500), [(1200, 2500, 1400), (1443, 2500, 1400), (1443, 2500, 1643), (1200, 2500, 1643)],
          "lamp")
    inset(shell, side_of(shell, 1, 0), [(1800, 0, 1000), (2700, 0, 1000), (2700, 0, 2000), (1800, 0, 2000)],
          "block", shift=(0, 900, 0))
    scene.add(shell)
    return scene


def shadow_room():
    """A lamp of 6 cm casts shadows with hard borders: turned boxes on the floor, a table top and a shelf."""
    scene = Scene("shadow_room", "A lamp of 6 cm, turned boxes, a table top and a shelf: shadows with hard borders",
                  {"wall": grey(0.5), "box": grey(0.5), "lamp": grey(0.1, 20000)}, free_point=(300, 1500, 300))
    shell = room("room", (0, 0, 0), (5000, 2500, 4000), {"": "wall"})
    inset(shell, side_of(shell, 1, 2500), [(2400, 2500, 1900), (2460, 2500, 1900), (2460, 2500, 1960), (2400, 2500, 1960)],
          "lamp")
    block = box("block", "box", (-300, 0, -300), (300, 900, 300), without="y-")
    pillar = box("pillar", "box", (-150, 0, -200), (150, 1600, 200), without="y-")
    top = box("table", "box", (-500, 700, -300), (500, 740, 300))
    scene.add(shell, placed(block, (1300, 1200), (3, 4, 5)), placed(pillar, (3700, 1300), (4, 3, 5)),
              placed(top, (1700, 3000), (4, -3, 5)), box("shelf", "box", (1900, 1300, 0), (3200, 1330, 350), without="z-"))
    return scene


def high_rho():
    scene = Scene("high_rho", "Closed room, rho 0.9, with a turned block on the floor",
                  {"wall": grey(0.9), "lamp": grey(0.9, 10)}, free_point=(500, 1500, 500))
    shell = room("room", (0, 0, 0), (3000, 2500, 3000), {"": "wall"})
    inset(shell, side_of(shell, 1, 2500), [(1000, 2500, 1000), (2000, 2500, 1000), (2000, 2500, 2000), (1000, 2500, 2000)],
          "lamp")
    inset(shell, side_of(shell, 1, 0), [(900, 0, 1300), (1700, 0, 900), (2100, 0, 1700), (1300, 0, 2100)],
          "wall", shift=(0, 1000, 0))
    scene.add(shell)
    return scene


def white_room():
    """47 m^2 of convex room, the lamp in the ceiling 0.1 % of that. Sum of received flux = emitted / (1 - rho)."""
    scene = Scene("white_room", "Convex room with rho 0.95 and a lamp of 0.1 % of its area",
                  {"wall": grey(0.95), "lamp": grey(0.95, 1000)}, free_point=(500, 1500, 500))
    shell = room("room", (0, 0, 0), (3200, 2500, 2800), {"": "wall"})
    inset(shell, side_of(shell, 1, 2500), [(1200, 2500, 1400), (1418, 2500, 1400), (1418, 2500, 1618), (1200, 2500, 1618)],
          "lamp")
    scene.add(shell)
    return scene


def portico():
    """A colonnade for the smallest chips: three columns between a floor, a wall and a roof; both ends are open."""
    scene = Scene("portico", "Three columns between a window and a wall, open at both ends: a colonnade of 16 faces", {
        "stone": grey(0.7), "column": grey(0.6), "window": grey(0.1, 20)}, free_point=(500, 1500, 2500), closed=False)
    sides = room("hall", (0, 0, 0), (6000, 3000, 3000), {"": "stone"})
    sides.faces = [sides.faces[side_of(sides, axis, value)] for axis, value in ((1, 0), (1, 3000), (2, 3000))]
    window = Face("window", [(500, 1000, 0), (5500, 1000, 0), (5500, 2500, 0), (500, 2500, 0)])
    scene.add(sides, Part("window", [window], room=True))
    for number in range(3):
        x = 800 + 2000 * number
        scene.add(box(f"column_{number}", "column", (x, 0, 1200), (x + 400, 3000, 1600), without="y- y+"))
    return scene


def colonnade():
    scene = Scene("colonnade", "Hall with two rows of six columns and a long window", {
        "stone": grey(0.7), "column": grey(0.6), "window": grey(0.1, 20)}, free_point=(6000, 2000, 3000))
    shell = room("hall", (0, 0, 0), (12000, 4000, 6000), {"": "stone"})
    inset(shell, side_of(shell, 2, 0), [(1000, 1500, 0), (11000, 1500, 0), (11000, 3000, 0), (1000, 3000, 0)], "window")
    scene.add(shell)
    for row, z in enumerate((1500, 4000)):
        for number in range(6):
            x = 750 + 2000 * number
            scene.add(box(f"column_{row}_{number}", "column", (x, 0, z), (x + 500, 4000, z + 500), without="y- y+"))
    return scene


def indirect_only():
    """A partition juts into the room; the lamp on its far side looks away, so the room proper is behind its plane."""
    scene = Scene("indirect_only", "The lamp is behind a partition: the room proper has reflected light only",
                  {"white": ((0.8, 0.78, 0.75), BLACK), "floor": ((0.45, 0.35, 0.25), BLACK),
                   "orange": ((0.8, 0.45, 0.15), BLACK), "lamp": (((0.1,) * 3), (100, 95, 85))},
                  free_point=(2500, 1200, 1500))
    plan = {"a": (0, 0), "b": (1200, 0), "c": (1200, 2200), "d": (1300, 2200), "e": (1300, 0), "f": (4000, 0),
            "g": (4000, 3000), "h": (0, 3000)}
    height, faces = 2500, []
    for quad in ("abch", "hcdg", "defg"):
        ring = [plan[c] for c in quad]
        faces.append(Face("floor", [(x, 0, z) for x, z in ring[::-1]]))
        faces.append(Face("white", [(x, height, z) for x, z in ring]))
    outline = "abcdefgh"
    for p, q in zip(outline, outline[1:] + outline[:1]):
        (px, pz), (qx, qz) = plan[p], plan[q]
        faces.append(Face("orange" if p + q == "ha" else "white",
                          [(px, height, pz), (px, 0, pz), (qx, 0, qz), (qx, height, qz)]))
    shell = Part("room", faces, room=True)
    inset(shell, side_of(shell, 0, 1200), [(1200, 900, 600), (1200, 900, 1400), (1200, 1700, 1400), (1200, 1700, 600)],
          "lamp")
    scene.add(shell)
    return scene


def gap():
    scene = Scene("gap", "Two boxes one centimetre apart on the floor of a closed room", {
        "wall": ((0.75, 0.73, 0.7), BLACK), "left": ((0.6, 0.2, 0.15), BLACK), "right": ((0.15, 0.25, 0.6), BLACK),
        "lamp": ((0.1, 0.1, 0.1), (30, 28, 24))}, free_point=(300, 1500, 300))
    shell = room("room", (0, 0, 0), (3000, 2400, 3000), {"": "wall"})
    inset(shell, side_of(shell, 1, 2400), [(1100, 2400, 1100), (1900, 2400, 1100), (1900, 2400, 1900), (1100, 2400, 1900)],
          "lamp")
    scene.add(shell, box("left_box", "left", (800, 0, 1000), (1495, 900, 1900), without="y-"),
              box("right_box", "right", (1505, 0, 1000), (2200, 1200, 1900), without="y-"))
    return scene


def mirror_room():
    """A mirror on the wall, a shiny ball and a lacquered box: what pictures show beside diffuse light."""
    scene = Scene("mirror_room", "Room with a mirror, a shiny ball and a lacquered box", {
        "wall": ((0.75, 0.72, 0.66), BLACK), "floor": ((0.35, 0.25, 0.18), BLACK), "blue": ((0.15, 0.3, 0.6), BLACK),
        "mirror": ((0.04, 0.04, 0.04), BLACK), "ball": ((0.6, 0.1, 0.08), BLACK), "lacquer": ((0.1, 0.35, 0.3), BLACK),
        "lamp": ((0.1, 0.1, 0.1), (40, 37, 32))}, free_point=(300, 1500, 300),
        shine={"mirror": ((0.85, 0.88, 0.88), 0, 3), "ball": ((0.12, 0.12, 0.12), 60, 2),
               "lacquer": ((0.06, 0.06, 0.06), 25, 2)})
    shell = room("room", (0, 0, 0), (4000, 2500, 3500), {"": "wall", "y-": "floor", "x+": "blue"})
    inset(shell, side_of(shell, 1, 2500), [(1700, 2500, 1500), (2300, 2500, 1500), (2300, 2500, 2100), (1700, 2500, 2100)],
          "lamp")
    inset(shell, side_of(shell, 2, 0), [(900, 500, 0), (3100, 500, 0), (3100, 2000, 0), (900, 2000, 0)], "mirror")
    ball = [(0, 17), (93, 35), (223, 46), (376, 50), (529, 46), (659, 35), (745, 19)]
    sphere = frustum("ball", "ball", TWELVE, (1400, 1500), ball, caps="y+", smooth=1)
    sphere.faces[-1].smooth = 1
    scene.add(shell, sphere, box("box", "lacquer", (2300, 0, 900), (2900, 700, 1500), without="y-"))
    return scene


def parallel_plates():
    scene = Scene("parallel_plates", "Two unit squares face to face, 1 m apart; the lower one emits. F = 0.199825",
                  {"emitter": grey(0.5, 1), "reflector": grey(0.5)}, free_point=(500, 500, 500), closed=False)
    low = Face("emitter", [(0, 0, 0), (0, 0, 1000), (1000, 0, 1000), (1000, 0, 0)])
    high = Face("reflector", [(0, 1000, 0), (1000, 1000, 0), (1000, 1000, 1000), (0, 1000, 1000)])
    scene.add(Part("lower", [low], room=True), Part("upper", [high], room=True))
    return scene


def cornell_grey():
    """The published geometry with one grey for each colour (its mean reflectance): needs a single channel."""
    means = {"white": 0.705, "red": 0.248, "green": 0.227, "light": 0}
    mtl = ["# cornell.mtl with the mean of the three channels: everything is grey"]
    for name, reflectance in means.items():
        mtl += [f"newmtl {name}", f"Kd {reflectance} {reflectance} {reflectance}",
                "Ke " + ("34.5575192 34.5575192 34.5575192" if name == "light" else "0 0 0"), "illum 1", ""]
    text = (SCENES / "cornell.obj").read_text(encoding="ascii")
    obj = re.sub("^mtllib .*$", "mtllib cornell_grey.mtl", text, flags=re.MULTILINE)
    obj = "# The Cornell box in grey.\n" + obj.split("\n", 1)[1]
    return {"cornell_grey.obj": obj.encode("ascii"), "cornell_grey.mtl": "\n".join(mtl[:-1] + [""]).encode("ascii")}


def write(path, content):
    """Complete or not at all."""
    partial = path.with_name(path.name + ".partial")
    partial.write_bytes(content)
    os.replace(partial, path)


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    styles = {"furnished_room": "rich", "gap": "negative", "indirect_only": "crlf", "mirror_room": "rich"}
    files = cornell_grey()
    for make in (closed_box, unit_cube_one_emitter, small_lamp, shadow_room, high_rho, white_room, portico, colonnade,
                 indirect_only, gap, mirror_room, parallel_plates, furnished_room):
        scene = make()
        check(scene)
        print(f"{scene.name}: {sum(len(p.faces) for p in scene.parts)} faces, {triangle_count(scene)} triangles, sound")
        files.update(files_of(scene, styles.get(scene.name, "plain")))
    stale = [name for name, content in files.items()
             if not (SCENES / name).is_file() or (SCENES / name).read_bytes() != content]
    if arguments:
        for name in stale:
            print(f"scenes/{name}: differs from what scripts/make_scenes.py writes; run it", file=sys.stderr)
        return 1 if stale else 0
    for name in stale:
        write(SCENES / name, files[name])
        print(f"wrote scenes/{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
