# SPDX-License-Identifier: MIT
"""The furnished room: 5 x 4 x 2.6 m, some 870 triangles, in the parts that an artist would model."""

import itertools

from scene_model import EIGHT, TWELVE, Scene, box, extrusion, frustum, inset, placed, room

BLACK = (0, 0, 0)
MATERIALS = {
    "plaster": ((0.8, 0.77, 0.7), BLACK),
    "ceiling_paint": ((0.85, 0.85, 0.83), BLACK),
    "oak_floor": ((0.5, 0.33, 0.19), BLACK),
    "window_reveal": ((0.75, 0.75, 0.75), BLACK),
    "daylight": ((0.1, 0.1, 0.1), (24, 30, 38)),
    "door_paint": ((0.7, 0.68, 0.6), BLACK),
    "lamp_housing": ((0.6, 0.6, 0.6), BLACK),
    "lamp_light": ((0.5, 0.5, 0.5), (46, 38, 26)),
    "beech": ((0.65, 0.48, 0.3), BLACK),
    "chair_red": ((0.55, 0.14, 0.12), BLACK),
    "walnut": ((0.32, 0.2, 0.13), BLACK),
    "sofa_blue": ((0.16, 0.25, 0.5), BLACK),
    "cushion_yellow": ((0.75, 0.58, 0.14), BLACK),
    "rug_wool": ((0.55, 0.5, 0.42), BLACK),
    "cupboard_white": ((0.78, 0.78, 0.75), BLACK),
    "terracotta": ((0.55, 0.27, 0.17), BLACK),
    "soil": ((0.13, 0.11, 0.1), BLACK),
    "leaves": ((0.16, 0.42, 0.13), BLACK),
    "steel": ((0.45, 0.45, 0.47), BLACK),
    "paper_globe": ((0.7, 0.66, 0.58), (14, 11, 7)),
    "book_red": ((0.6, 0.15, 0.12), BLACK),
    "book_green": ((0.15, 0.4, 0.22), BLACK),
    "book_cream": ((0.75, 0.7, 0.55), BLACK),
}


def shell():
    part = room("Room", (0, 0, 0), (5000, 2600, 4000), {"": "plaster", "y-": "oak_floor", "y+": "ceiling_paint"})
    north = next(i for i, f in enumerate(part.faces) if all(z == 0 for _, _, z in f.corners))
    opening = [(1500, 900, 0), (3500, 900, 0), (3500, 2100, 0), (1500, 2100, 0)]
    inset(part, north, opening, "daylight", shift=(0, 0, -180), side_material="window_reveal")
    return part


def table():
    yield box("Table_top", "beech", (1200, 720, 1000), (2800, 750, 1800))
    for number, (x, z) in enumerate([(1260, 1060), (2680, 1060), (2680, 1680), (1260, 1680)]):
        yield box(f"Table_leg.{number:03}", "beech", (x, 0, z), (x + 60, 720, z + 60), without="y- y+")


def chair(number, origin, turn):
    """Seat 0.4 x 0.4 m, its back towards local +z; all measures are multiples of 5 mm, so 3-4-5 turns are exact."""
    def put(part):
        part.name = f"Chair.{number:03}_{part.name}"
        return placed(part, origin, turn)

    yield put(box("seat", "chair_red", (-200, 430, -200), (200, 460, 200)))
    for name, x, z in (("front_left", -200, -200), ("front_right", 165, -200), ("back_left", -200, 165),
                       ("back_right", 165, 165)):
        yield put(box(f"leg_{name}", "beech", (x, 0, z), (x + 35, 430, z + 35), without="y- y+"))
    for name, x in (("left", -180), ("right", 145)):
        yield put(box(f"post_{name}", "beech", (x, 460, 165), (x + 35, 760, 190), without="y- y+"))
    yield put(box("rest", "chair_red", (-200, 760, 160), (200, 900, 195)))


def shelf():
    """Open shelf at the east wall, its back panel 2 cm from the wall, its boards between two sides."""
    x0, x1, z0, z1 = 4680, 4960, 600, 1500
    yield box("Shelf_side.000", "walnut", (x0, 0, z0), (x1, 1800, z0 + 25), without="y-")
    yield box("Shelf_side.001", "walnut", (x0, 0, z1 - 25), (x1, 1800, z1), without="y-")
    yield box("Shelf_back", "walnut", (x1, 0, z0), (x1 + 20, 1800, z1), without="y-")
    for number, y in enumerate((80, 500, 920, 1340, 1770)):
        yield box(f"Shelf_board.{number:03}", "walnut", (x0, y, z0 + 25), (x1, y + 25, z1 - 25), without="x+ z- z+")
    volumes = [(525, [(660, 45, 300), (725, 35, 260), (780, 60, 320), (860, 40, 280), (1200, 50, 310)]),
               (945, [(640, 70, 240), (730, 40, 330), (1290, 55, 290), (1370, 45, 250)]),
               (1365, [(800, 50, 300), (880, 60, 270), (960, 40, 310)])]
    bindings = itertools.cycle(["book_red", "book_green", "book_cream", "book_green"])
    for y, books in volumes:
        for z, thickness, height in books:
            yield box(f"Book_{y}_{z}", next(bindings), (4730, y, z), (4930, y + height, z + thickness), without="y-")


def sofa():
    """Seat and back as one solid: its two ends are concave hexagons. Against the south wall, facing north."""
    profile = [(0, 3050), (420, 3050), (420, 3600), (850, 3600), (850, 3900), (0, 3900)]
    yield extrusion("Sofa", "sofa_blue", profile, 1400, 3400, without_edges=(5,))
    for number, x in enumerate((1450, 2110, 2770)):
        yield box(f"Cushion.{number:03}", "cushion_yellow", (x, 420, 3120), (x + 580, 540, 3560), without="y-")


def cupboard():
    yield box("Cupboard", "cupboard_white", (40, 0, 600), (500, 1900, 1800), without="y-")
    for number, z in enumerate((610, 1210)):
        yield box(f"Cupboard_door.{number:03}", "cupboard_white", (500, 100, z), (520, 1880, z + 580), without="x-")
        yield box(f"Cupboard_handle.{number:03}", "steel", (520, 950, 1150 if number == 0 else 1230),
                  (545, 1090, 1170 if number == 0 else 1250), without="x-")


def plant():
    centre = (600, 3400)
    yield frustum("Plant_pot", "terracotta", TWELVE, centre, [(0, 16), (300, 24), (340, 24)], caps="y+", smooth=1,
                  cap_material="soil")
    yield frustum("Plant_trunk", "walnut", EIGHT, centre, [(340, 5), (700, 4)], caps="", smooth=2)
    yield frustum("Plant_crown", "leaves", EIGHT, centre, [(700, 16), (850, 40), (1150, 44), (1400, 18)], smooth=3)


def floor_lamp():
    centre = (4400, 3350)
    yield frustum("Lamp_foot", "steel", EIGHT, centre, [(0, 20), (25, 20)], caps="y+")
    yield frustum("Lamp_pole", "steel", EIGHT, centre, [(25, 2), (1250, 2)], caps="", smooth=4)
    yield frustum("Lamp_globe", "paper_globe", EIGHT, centre,
                  [(1250, 8), (1300, 18), (1400, 25), (1520, 25), (1620, 18), (1670, 8)], smooth=5)


def door():
    yield box("Door_leaf", "door_paint", (3700, 10, 3950), (4700, 2050, 3990))
    yield box("Door_handle", "steel", (3780, 1000, 3915), (3900, 1025, 3950), without="z+")


def ceiling_lamp():
    yield box("Ceiling_lamp", "lamp_housing", (1700, 2150, 1100), (2300, 2250, 1700), materials={"y-": "lamp_light"})


def furnished_room():
    scene = Scene("furnished_room", "Furnished room, 5 x 4 x 2.6 m: window, ceiling lamp, paper globe", MATERIALS,
                  free_point=(3200, 1300, 2400))
    scene.add(shell(), *ceiling_lamp(), *door(), *table(),
              *chair(0, (1650, 2100), (1, 0, 1)), *chair(1, (2350, 2100), (4, 3, 5)), *chair(2, (3200, 1400), (0, 1, 1)),
              *shelf(), *sofa(), box("Rug", "rug_wool", (1500, 0, 2500), (3300, 10, 2950), without="y-"),
              *cupboard(), *plant(), *floor_lamp())
    return scene
