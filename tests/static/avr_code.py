# SPDX-License-Identifier: MIT
"""Frames and calls of AVR objects, read off their machine code: avr-gcc 5.4 has no report on calls, and its report on
frames leaves out arguments that are pushed.

Every path through a function is walked once for each instruction, with the depth of the stack and the frame pointer Y.
"""

import re
import subprocess

from call_graph import INDIRECT_CALL, Function, Refused, demangled, one_constructor

RETURN_ADDRESS = 3
SKIPS = ("cpse", "sbrc", "sbrs", "sbic", "sbis")
READS_ITS_FIRST = ("st", "std", "sts", "push", "out", "cp", "cpc", "cpi", "tst", "cpse", "sbrc", "sbrs")
INSTRUCTION = re.compile(r"\s+([0-9a-f]+):\t[0-9a-f ]+\t(\S+)(?:\t([^;]*))?")
RELOCATION = re.compile(r"\s+[0-9a-f]+: (R_AVR_\S+)\s+(\S+)")


class Code:
    """The instructions of one section: at[address] = [mnemonic, operands, relocation or None]."""

    def __init__(self):
        self.at, self.names = {}, {}


def sections_of(obj):
    text = subprocess.run(["avr-objdump", "-dr", obj], capture_output=True, text=True, check=True).stdout
    sections, code, last = {}, None, None
    for line in one_constructor(text).splitlines():
        if match := re.match(r"Disassembly of section (\S+):", line):
            code = sections.setdefault(match.group(1), Code())
        elif match := re.match(r"([0-9a-f]+) <(\S+)>:", line):
            code.names[int(match.group(1), 16)] = match.group(2)
        elif match := INSTRUCTION.match(line):
            operands = [operand.strip() for operand in (match.group(3) or "").split(",")]
            last = code.at[int(match.group(1), 16)] = [match.group(2), operands, None]
        elif (match := RELOCATION.match(line)) and match.group(1) in ("R_AVR_CALL", "R_AVR_13_PCREL", "R_AVR_7_PCREL"):
            last[2] = match.group(2)
    return sections


def target_of(relocation, sections):
    """(section or None, address or name) of what a relocation refers to."""
    name, _, offset = relocation.partition("+")
    address = int(offset or "0", 16)
    if name in sections:
        return name, address
    for section, code in sections.items():
        for start, symbol in code.names.items():
            if symbol == name:
                return section, start + address
    return None, name


class Walk:
    """One function: its deepest stack and what it calls."""

    def __init__(self, sections, section, start, function, title_of):
        self.sections, self.section, self.code = sections, section, sections[section]
        self.function, self.title_of = function, title_of
        self.next = dict(zip(sorted(self.code.at), sorted(self.code.at)[1:]))
        self.seen, self.todo, self.deepest = set(), [(start, RETURN_ADDRESS, None)], RETURN_ADDRESS

    def run(self):
        while self.todo:
            address, depth, y = self.todo.pop()
            if address in self.seen:
                continue
            self.seen.add(address)
            if address not in self.code.at:
                raise Refused(f"{demangled(self.function.title)}: its code ends without a return")
            self.step(address, depth, y)
        self.function.frame = max(self.function.frame or 0, self.deepest)

    def go(self, address, depth, y):
        self.deepest = max(self.deepest, depth)
        self.todo.append((address, depth, y))

    def step(self, address, depth, y):
        name, operands, relocation = self.code.at[address]
        after = self.next.get(address, -1)
        if name in ("ret", "reti"):
            return
        if name in ("icall", "eicall", "ijmp", "eijmp"):
            self.function.calls.add(INDIRECT_CALL)
        elif relocation and name in ("call", "rcall", "jmp", "rjmp") or name.startswith("br"):
            depth = self.transfer(name, relocation, after, depth, y)
        elif name in SKIPS:
            self.go(self.next.get(after, -1), depth, y)
        depth, y = self.effect(address, name, operands, depth, y)
        if name not in ("jmp", "rjmp", "ijmp", "eijmp"):
            self.go(after, depth, y)

    def transfer(self, name, relocation, after, depth, y):
        """A branch, a jump or a call; returns the depth after it."""
        section, where = target_of(relocation, self.sections)
        if name == "rcall" and (section, where) == (self.section, after):
            return depth + RETURN_ADDRESS  # room on the stack, in one instruction
        inside = section == self.section and where not in self.code.names
        if inside and name not in ("call", "rcall"):
            self.go(where, depth, y)
        else:
            self.function.calls.add(self.title_of(section, where))
        return depth

    def effect(self, address, name, operands, depth, y):
        first = operands[0]
        if name == "push":
            return depth + 1, y
        if name == "pop":
            return depth - 1, None if first in ("r28", "r29") else y
        if name == "in" and operands[1] == "0x3d":
            return depth, depth if first == "r28" else y
        if name == "out" and first == "0x3d":
            if operands[1] != "r28" or y is None:
                raise Refused(f"{demangled(self.function.title)}: the size of its frame is not known")
            return y, y
        if first not in ("r28", "r29") or name in READS_ITS_FIRST or (name, first) == ("in", "r29"):
            return depth, y
        return depth, self.moved(address, name, operands, y)

    def moved(self, address, name, operands, y):
        """Y after an instruction that writes to it."""
        if y is None:
            return None
        if name in ("sbiw", "adiw"):
            return y + int(operands[1], 16) * (1 if name == "sbiw" else -1)
        if name in ("sbci", "sbc") and operands[0] == "r29":
            return y  # the high byte of the subtraction before it
        after, high, _ = self.code.at[self.next[address]]
        if name == "subi" and operands[0] == "r28" and (after == "sbci" or (after, high[1]) == ("sbc", "r1")):
            value = int(operands[1], 16) + 256 * (int(high[1], 16) if after == "sbci" else 0)
            return y + (value - 65536 if value >= 32768 else value)
        return None


def read_avr(obj, functions):
    """Adds the functions of the object to {title: Function}; local names are told apart by object."""
    sections = sections_of(obj)

    def title_of(section, where):
        name = where if section is None else sections[section].names[where]
        is_local = section is not None and ("_GLOBAL__N_" in name or not name.startswith("_Z"))
        return f"{obj}:{name}" if is_local and name != "main" and not name.startswith("__") else name

    for section, code in sections.items():
        for start in code.names:
            # Start-up code in .init0 ... .init9 falls from one section into the next, on an empty stack.
            if start in code.at and not section.startswith(".init"):
                title = title_of(section, start)
                Walk(sections, section, start, functions.setdefault(title, Function(title)), title_of).run()
