# SPDX-License-Identifier: MIT
"""docs/targets.md and the table of targets in README.md, from firmware/measurements.json."""

import re

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

HEAD = """# Targets

Made by `scripts/measure_targets.py`; do not edit. A test compares this page with the committed scenes, and each
target's tests count its Cornell box again and allow two per cent.

Every program has run in the target's emulator, compiled with -O2, and has given the digest of the host, bit for bit.

**Instructions are not cycles.** QEMU counts executed instructions: real chips wait for flash and take several cycles
for loads, taken branches, products and divisions. Only the ATmega2560's column counts cycles, from simavr. *Seconds*
divides the count by the clock in this table, so it is a time for the ATmega2560 only, and elsewhere what it would take at
one instruction a cycle.

"""

COLUMNS = """
*Code*: the core's functions in the program, without the compiler's division and product routines. *Tables*: the core's
+ the scene's with its displayed mesh. *RAM*: the solver, all the memory it uses. *Stack*: high-water mark of the painted
stack of the whole program. *Solve*: from the first shot to convergence; loading and the vertices come on top, below.
*Error*: mean over faces that do not emit, weighted by area, of the radiosity's difference from path-traced truth.
*Float / fixed*: what the same algorithm in `float` takes, divided by *solve*.
"""

STAGES = """
## Where it goes

The Cornell box, solving only, with the core and with its float peer. *Transform*: scene to eye, clipping. *Raster*:
faces to intervals of a row. *Insert*: intervals by depth. *Split*: intervals to elements, delta form factors. *Rows*:
the loop over them. *Distribute*: flux to elements and patches. *Search*: the brightest patch. Products, divisions,
shifts and floats are the compiler's routines, whoever calls them; on the ATmega2560 what is inlined counts for the
function around it.
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
        passed, total = measured["targets"][preset]["tests"]
        rows.append([f"`{preset}`", core, chip, f"{clock} MHz", compiler, emulator, unit_of(preset), f"{passed} of {total}"])
    return table(["preset", "core", "chip of the clock", "clock", "compiler", "emulator", "counted", "tests passed"], rows, 7)


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


def stage_table(measured, solver):
    columns = [(preset, name, bench[solver]) for preset, target in measured["targets"].items()
               for name, bench in target["bench"].items()]
    names = []
    for _, _, record in columns:
        names += [stage for stage in record["stages"] if stage not in names]
    rows = [[stage] + [f"{short(r['stages'][stage])} ({100 * r['stages'][stage] / r['solve']:.0f} %)"
                       if stage in r["stages"] else "" for _, _, r in columns] for stage in names]
    rows.append(["**all**"] + [f"**{short(r['solve'])}**" for _, _, r in columns])
    header = [""] + [f"{preset} {name.rsplit('_', 1)[1]}" for preset, name, _ in columns]
    return table(header, rows)


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
    text = HEAD + chip_table(measured) + COLUMNS
    for preset, target in measured["targets"].items():
        core, chip, clock, _, _ = CHIPS[preset]
        text += f"\n## {core}: `cmake --workflow --preset {preset}`\n\nSeconds at {clock} MHz ({chip}).\n\n"
        text += scene_table(preset, target, measured["errors"])
    text += "\n## Loading and vertices\n\nThe Cornell box; the count of *vertices* is for every vertex of the displayed mesh.\n\n"
    text += phases_table(measured)
    text += """
## Fixed point and float

The same algorithm in `float` (`firmware/float_peer`), in the same program and run: software floating point everywhere but
on Cortex-M4F and M7, which have hardware for it. Errors are mean differences of the elements' radiosities, over the
scene's mean: from the same shots in double, and from double with a much finer hemicube on the same mesh.

"""
    text += peer_table(measured) + STAGES
    text += "\n### The core\n\n" + stage_table(measured, "core") + "\n### The float peer\n\n" + stage_table(measured, "peer")
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
