# SPDX-License-Identifier: MIT
"""The symbol table of a 32-bit little-endian ELF file: what every target here has."""

import struct

SYMTAB = 2


class ElfError(Exception):
    """The file is not what the reader can read; the text names it."""


def symbols(path):
    """Yields (name, value, size) of every named symbol of the file at `path`."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:6] != b"\x7fELF\x01\x01":
        raise ElfError(f"{path}: not a 32-bit little-endian ELF file")
    table_offset, = struct.unpack_from("<I", data, 32)
    entry_size, count = struct.unpack_from("<HH", data, 46)
    sections = [struct.unpack_from("<10I", data, table_offset + i * entry_size) for i in range(count)]
    for section in sections:
        if section[1] != SYMTAB:
            continue
        offset, size, link = section[4], section[5], section[6]
        names = sections[link][4]
        for at in range(offset, offset + size, 16):
            name, value, length = struct.unpack_from("<III", data, at)
            if name:
                end = data.index(b"\0", names + name)
                yield data[names + name:end].decode(), value, length


def regions(path, is_thumb):
    """[(name, address)] of the functions that FIXRAD_REGION has made; Thumb addresses without their mode bit."""
    prefix = "fixrad_region_"
    found = {(name[len(prefix):], value & ~1 if is_thumb else value)
             for name, value, _ in symbols(path) if name.startswith(prefix)}
    return sorted(found, key=lambda region: region[1])
