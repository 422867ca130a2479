# SPDX-License-Identifier: MIT
"""docs/targets.md and the table of targets in README.md, from firmware/measurements.json."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "firmware/emulators"))
from stages import ORDER  # noqa: E402

# preset: (core, chip whose clock is taken, MHz, compiler, emulator). Clocks: the chip's data sheet, highest nominal.
CHIPS = {
    "cortex-m0": ("Cortex-M0", "nRF51822", 16, "arm-none-eabi-gcc", "QEMU microbit"),
    "cortex-m3": ("Cortex-M3", "STM32F103", 72, "arm-none-eabi-gcc", "QEMU mps2-an385"),
    "cortex-m4f": ("Cortex-M4F", "STM32F407", 168, "arm-none-eabi-gcc", "QEMU mps2-an386"),
    "cortex-m7": ("Cortex-M7", "STM32F746", 216, "arm-none-eabi-gcc", "QEMU mps2-an500"),
    "rv32imc": ("RV32IMC", "GD32VF103", 108, "riscv64-unknown-elf-gcc", "QEMU virt"),
    "atmega2560": ("AVR, 8-bit", "ATmega2560", 16, "avr-gcc", "simavr"),
    "esp8266": ("Xtensa lx106", "ESP8266", 80, "xtensa-lx106-elf-gcc", "QEMU sim"),
}

ROWS_WANTED = 8192  # bytes of code and tables for `rows` at R = 16

HEAD = """# Targets

Made by `scripts/measure_targets.py`; do not edit. A test compares this page with the committed scenes, and each
target's tests count its Cornell box again and allow two per cent.

Every program has run in the target's emulator, compiled with -O3, and has given the digest of the host, bit for bit.

**Instructions are not cycles.** QEMU counts executed instructions: real chips wait for flash and take several cycles
for loads, taken branches, products and divisions. Only the ATmega2560's column counts cycles, from simavr. *Seconds*
divides the count by the clock in this table, so it is a time for the ATmega2560 only, and elsewhere what it would take at
one instruction a cycle.

"""

STACK = """
*Worst-case stack*: bytes of the deepest chain of calls, of the core / of a program that solves, and its budget; from the
compiler's report on frames and calls or from machine code, without running.
"""

COLUMNS = """
*Code*: the core's functions in the program, without the compiler's division and product routines. *Tables*: the core's
+ the scene's with its displayed mesh. *RAM*: the solver, all the memory it uses. *Stack*: high-water mark of the painted
stack of the whole program. *Solve*: from the first shot to convergence; loading and the vertices come on top, below.
*Error*: mean over faces that do not emit, weighted by area, of the radiosity's difference from path-traced truth,
whose standard error is at most {truth}.
*Float / fixed*: what the same algorithm in `float` takes, divided by *solve*.
"""

STAGES = """
## Where it goes

The Cornell box, solving only, with the core and with its float peer. *Transform*: scene to eye, clipping. *Raster*:
faces to intervals of a row. *Insert*: intervals by depth. *Split*: intervals to elements, delta form factors. *Rows*:
the loop over them. *Distribute*: flux to elements, and to the accounts of faces once these shoot. *Search*: unshot flux
of elements, patches or faces, from which a pass chooses who shoots, and the accounts of what they send. Products,
divisions, shifts and floats are the compiler's routines, whoever calls them. Stages below half a per cent on every
target are *the rest*.
"""


def number(value):
    return f"{value:,}"


def short(value):
    """Three digits: 98.9 M."""
    for size, suffix in ((1_000_000_000, " G"), (1_000_000, " M"), (1_000, " k")):
        if value >= size:
            scaled = value / size
            return f"{scaled:.{max(0, 3 - len(str(int(scaled))))}f}{suffix}"
    return str(value)


def table(header, rows, left=1):
    lines = [header, ["---"] * left + ["---:"] * (len(header) - left), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def unit_of(preset):
    return "cycles" if preset == "atmega2560" else "instructions"


def seconds(preset, count):
    return f"{count / (CHIPS[preset][2] * 1e6):.2f}"


def ratio(target, scene):
    bench = target["bench"].get(scene)
    return f"{bench['peer']['solve'] / bench['core']['solve']:.2f} ×" if bench else ""


def chip_table(measured):
    rows = []
    for preset, (core, chip, clock, compiler, emulator) in CHIPS.items():
        target = measured["targets"][preset]
        passed, total = target["tests"]
        stack = target["static_stack"]
        rows.append([f"`{preset}`", core, f"{chip}, {clock} MHz", compiler, emulator, unit_of(preset), f"{passed} of {total}",
                     f"{number(stack['core'])} / {number(stack['program'])} of {number(stack['budget'])}"])
    return table(["preset", "core", "chip of the clock", "compiler", "emulator", "counted", "tests passed",
                  "worst-case stack"], rows, 6)


def size_lines(measured):
    """The size of `rows` shooting, where a target's tests measure it."""
    return "".join(f"\nCode and tables for shooting with `rows` at R = 16, compiled with -Os for {CHIPS[preset][0]},\nwith "
                   f"loading and the checks of the scene: {number(target['rows_size'])} bytes; {number(ROWS_WANTED)}\n"
                   "were wanted ([design.md](design.md#where-do-the-bytes-of-code-go)).\n"
                   for preset, target in measured["targets"].items() if "rows_size" in target)


def scene_table(preset, target, errors):
    rows = []
    for name, s in target["scenes"].items():
        error = errors[name]
        rows.append([name, str(s["elements"]), number(s["code"]), f"{number(s['core_tables'])} + {number(s['scene_tables'])}",
                     number(s["ram"]), number(s["stack"]), number(s["shots"]), short(s["solve"] // s["shots"]),
                     number(s["solve"]), seconds(preset, s["solve"]), f"`{s['digest']}`", f"{100 * error['mean']:.2f} %",
                     ratio(target, name)])
    unit = unit_of(preset)
    return table(["scene", "elements", "code", "tables", "RAM", "stack", "shots", f"{unit} a shot", f"{unit}, solve",
                  "seconds", "digest", "error", "float / fixed"], rows)


def phases_table(measured):
    rows = []
    for preset, target in measured["targets"].items():
        for name, s in target["scenes"].items():
            if name.startswith("cornell_") and "grey" not in name:
                rows.append([f"`{preset}`", name, unit_of(preset)] + [number(s[p]) for p in ("load", "solve", "vertices")])
    return table(["preset", "scene", "counted", "load", "solve", "all vertices and the digest"], rows, 3)


def stage_table(columns):
    """columns: (title, {"solve": count, "stages": {stage: count}})."""
    share = {(t, stage): count / r["solve"] for t, r in columns for stage, count in r["stages"].items()}
    shown = [stage for stage in ORDER if any(share.get((t, stage), 0) >= 0.005 for t, _ in columns)]
    rows = [[stage] + [f"{short(r['stages'][stage])} ({100 * share[t, stage]:.0f} %)" if share.get((t, stage), 0) >= 0.005
                       else "" for t, r in columns] for stage in shown]
    rest = [r["solve"] - sum(r["stages"][s] for s in shown if share.get((t, s), 0) >= 0.005) for t, r in columns]
    rows.append(["the rest"] + [short(count) for count in rest])
    rows.append(["**all**"] + [f"**{short(r['solve'])}**" for _, r in columns])
    return table([""] + [title for title, _ in columns], rows)


def stage_tables(measured, solver):
    """A table of each target's smallest Cornell box, and one of the others."""
    first, others = [], []
    for preset, target in measured["targets"].items():
        for i, (name, bench) in enumerate(target["bench"].items()):
            (others if i else first).append((f"{preset} {name.rsplit('_', 1)[1]}", bench[solver]))
    return stage_table(first) + ("\n" + stage_table(others) if others else "")


def peer_table(measured):
    rows = []
    for preset, target in measured["targets"].items():
        for name, bench in target["bench"].items():
            core, peer = bench["core"], bench["peer"]
            rows.append([f"`{preset}`", name, bench["unit"], number(core["solve"]), number(peer["solve"]),
                         f"{peer['solve'] / core['solve']:.2f} ×"]
                        + [f"{solver['errors'][reference] / 10_000:.4f} %" for reference in ("same_shots", "fine")
                           for solver in (core, peer)])
    return table(["preset", "scene", "counted", "fixed", "float", "float / fixed", "fixed, same shots",
                  "float, same shots", "fixed, fine", "float, fine"], rows, 3)


def targets_page(measured):
    truth = max(error["truth"] for error in measured["errors"].values())
    text = HEAD + chip_table(measured) + STACK + size_lines(measured) + COLUMNS.format(truth=f"{100 * truth:.2f} %")
    for preset, target in measured["targets"].items():
        core, chip, clock, _, _ = CHIPS[preset]
        text += f"\n## {core}: `cmake --workflow --preset {preset}`\n\nSeconds at {clock} MHz ({chip}).\n\n"
        text += scene_table(preset, target, measured["errors"])
    text += "\n## Loading and vertices\n\nThe Cornell box; the count of *vertices* is for every vertex of the displayed mesh.\n\n"
    text += phases_table(measured)
    text += """
## Fixed point and float

The same algorithm in `float` (`firmware/float_peer`), in the same program and run: software floating point everywhere but
on Cortex-M4F and M7, which have hardware for it. The ESP8266 has the routines for `float` in its ROM; here the board's own
take their place (`firmware/boards/esp8266-sim`). Errors are mean differences of the elements' radiosities, over the
scene's mean: from the same shots in double, and from double with a much finer hemicube on the same mesh.

"""
    text += peer_table(measured) + STAGES
    text += "\n### The core\n\n" + stage_tables(measured, "core") + "\n### The float peer\n\n" + stage_tables(measured, "peer")
    return text


def readme_table(measured):
    """A row a target: the Cornell box of the first profile that it holds."""
    rows = []
    for preset, (core, chip, clock, _, emulator) in CHIPS.items():
        target = measured["targets"][preset]
        passed, total = target["tests"]
        name, s = next((n, s) for n, s in target["scenes"].items() if re.fullmatch(r"cornell_[a-z]+", n))
        rows.append([f"`{preset}`", core, "✓" if passed == total else "", emulator, name, str(s["elements"]), number(s["ram"]),
                     number(s["stack"]), f"{short(s['solve'])} {'cycles' if unit_of(preset) == 'cycles' else ''}".strip(),
                     f"{seconds(preset, s['solve'])} at {clock} MHz", f"{100 * measured['errors'][name]['mean']:.2f} %",
                     ratio(target, name)])
    return table(["preset", "core", "bits of the host", "ran in", "scene", "elements", "RAM", "stack", "instructions",
                  "seconds", "error", "float / fixed"], rows, 5)


def pages(root, measured):
    """{path: text} of everything that is made of the measurements."""
    readme = root / "README.md"
    text, count = re.subn(r"(<!-- targets:begin -->\n).*?(<!-- targets:end -->)",
                          lambda m: m[1] + "\n" + readme_table(measured) + "\n" + m[2], readme.read_text(), flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"{readme}: {count} passages between <!-- targets:begin --> and <!-- targets:end -->, 1 is needed")
    return {root / "docs/targets.md": targets_page(measured), readme: text}
