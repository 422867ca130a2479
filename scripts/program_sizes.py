# SPDX-License-Identifier: MIT
"""Sizes of what the linker has put into a program for a target, from its symbol table."""

import re
import struct

FUNCTION, OBJECT = 2, 1
CORE = re.compile(r"_ZNK?6fixrad(?!6report|4text|5board|7compare|4peer|10small_test)")


def symbols(path):
    """{(kind, address): (name, size)} of the functions and objects of the ELF file at `path`, aliases once."""
    with open(path, "rb") as file:
        data = file.read()
    table, = struct.unpack_from("<I", data, 32)
    entry_size, count = struct.unpack_from("<HH", data, 46)
    sections = [struct.unpack_from("<10I", data, table + i * entry_size) for i in range(count)]
    found = {}
    for section in (s for s in sections if s[1] == 2):
        names = sections[section[6]][4]
        for at in range(section[4], section[4] + section[5], 16):
            name, value, size, info = struct.unpack_from("<IIIB", data, at)
            if size and info & 15 in (FUNCTION, OBJECT):
                end = data.index(b"\0", names + name)
                found[info & 15, value] = data[names + name:end].decode(), size
    return found


def sizes(path, scene):
    """Bytes of a solve program: the core's functions, its tables, the tables of the scene, the solver in RAM."""
    result = {"code": 0, "core_tables": 0, "scene_tables": 0, "ram": 0}
    of_scene = re.compile(rf"_ZN{len(scene)}{scene}(?!8expected)")
    for (kind, _), (name, size) in symbols(path).items():
        if kind == FUNCTION:
            result["code"] += size if CORE.match(name) else 0
        elif CORE.match(name):
            result["core_tables"] += size
        elif of_scene.match(name):
            result["scene_tables"] += size
        elif name == "_ZN12_GLOBAL__N_16solverE":
            result["ram"] += size
    if not all(result.values()):
        raise ValueError(f"{path}: nothing of one kind: {result}")
    return result
