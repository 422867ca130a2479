# SPDX-License-Identifier: MIT
"""OBJ and MTL text of a scene, in the manners of different modelling tools."""

from scene_check import newell


def metres(millimetres):
    return f"{millimetres / 1000:.3f}"


class Pool:
    """Numbers equal items once, from 1 on, as OBJ counts."""

    def __init__(self):
        self.numbers = {}

    def __call__(self, item):
        return self.numbers.setdefault(item, len(self.numbers) + 1)


def unit(vector):
    length = sum(c * c for c in vector) ** 0.5
    return tuple(c / length for c in vector)


def normal_text(vector):
    return " ".join(f"{c + 0.0:.4f}" for c in (round(c, 4) + 0.0 for c in unit(vector)))


def texture_text(corner, normal):
    """One metre of texture a metre of surface, projected along the normal's longest axis."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    return " ".join(metres(corner[k]) for k in range(3) if k != axis)


def smooth_normals(part):
    """(smoothing group, corner) -> sum of the normals of the group's faces round that corner."""
    sums = {}
    for face in part.faces:
        if face.smooth:
            normal = newell(face.corners)
            for corner in face.corners:
                old = sums.get((face.smooth, corner), (0, 0, 0))
                sums[face.smooth, corner] = tuple(a + b for a, b in zip(old, normal))
    return sums


def rich_obj(scene, header):
    """As a modelling tool exports: o, v, vt, vn, s, and corners v/vt/vn."""
    lines = list(header)
    positions, textures, normals = Pool(), Pool(), Pool()
    for part in scene.parts:
        seen = len(positions.numbers), len(textures.numbers), len(normals.numbers)
        sums, statements, material, group = smooth_normals(part), [], None, None
        for face in part.faces:
            if face.material != material:
                material = face.material
                statements.append(f"usemtl {material}")
            if face.smooth != group:
                group = face.smooth
                statements.append(f"s {group or 'off'}")
            flat, words = newell(face.corners), []
            for corner in face.corners:
                normal = sums[face.smooth, corner] if face.smooth else flat
                words.append(f"{positions(corner)}/{textures(texture_text(corner, flat))}/{normals(normal_text(normal))}")
            statements.append("f " + " ".join(words))
        lines.append(f"o {part.name}")
        lines += ["v " + " ".join(map(metres, p)) for p in list(positions.numbers)[seen[0]:]]
        lines += [f"vt {t}" for t in list(textures.numbers)[seen[1]:]]
        lines += [f"vn {n}" for n in list(normals.numbers)[seen[2]:]]
        lines += statements
    return lines


def plain_obj(scene, header, negative=False):
    """Positions and faces only; with `negative`, each group counts its corners back from the last vertex."""
    lines, shared = list(header), Pool()
    if not negative:
        for part in scene.parts:
            for face in part.faces:
                for corner in face.corners:
                    shared(corner)
        lines += ["v " + " ".join(map(metres, p)) for p in shared.numbers]
    for part in scene.parts:
        own, material = Pool(), None
        if negative:
            for face in part.faces:
                for corner in face.corners:
                    own(corner)
            lines += ["v " + " ".join(map(metres, p)) for p in own.numbers]
        lines.append(f"g {part.name}")
        for face in part.faces:
            if face.material != material:
                material = face.material
                lines.append(f"usemtl {material}")
            number = (lambda c: own(c) - len(own.numbers) - 1) if negative else shared
            lines.append("f " + " ".join(str(number(c)) for c in face.corners))
    return lines


def mtl_lines(scene):
    lines = ["# Kd = diffuse reflectance, Ke = emitted radiosity (exitance, W/m^2)"]
    for name, (reflectance, emission) in scene.materials.items():
        lines += [f"newmtl {name}",
                  "Kd " + " ".join(f"{c:g}" for c in reflectance),
                  "Ke " + " ".join(f"{c:g}" for c in emission)]
        if name in scene.shine:
            specular, exponent, model = scene.shine[name]
            lines += ["Ks " + " ".join(f"{c:g}" for c in specular), f"Ns {exponent:g}", f"illum {model}", ""]
        else:
            lines += ["illum 1", ""]
    return lines[:-1]


def files_of(scene, style="plain", by="make_scenes.py"):
    """{file name: bytes}; style is plain, rich, negative or crlf; `by` is the script that asks."""
    header = [f"# {scene.about}", f"# Written by scripts/{by}; metres, y up, counter-clockwise seen from the lit side.",
              f"mtllib {scene.name}.mtl"]
    lines = rich_obj(scene, header) if style == "rich" else plain_obj(scene, header, style == "negative")
    end = "\r\n" if style == "crlf" else "\n"
    return {f"{scene.name}.{suffix}": (end.join(text) + end).encode("ascii")
            for suffix, text in (("obj", lines), ("mtl", mtl_lines(scene)))}
