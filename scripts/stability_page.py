# SPDX-License-Identifier: MIT
"""The text of docs/stability.md from what measure_stability.py has found."""

from accuracy_page import table

ARITHMETICS = ("fixed", "double", "float")

HEAD = """# Stability

Made by `scripts/measure_stability.py`; do not edit.

Scenes that are hard for an arithmetic, each held to what theory knows of its light: a closed form, a symmetry, a
conservation law. *Fixed* is the core, *double* its [twin](../host_sim/reference/twin.h), which fires the same shots in
double precision, *float* the [peer](../firmware/float_peer/solver.h), the same method in single precision. A test holds
the core to every bound; the others are shown beside it.

    build/host/tests/stability/measure_stability [CASE...]     the catalogue as JSON
    build/host/tests/stability/stability_test                  its bounds, and three thousand random scenes
    build/host/tests/stability/check_scenes --count 100000     more of them

The second of them also under AddressSanitizer and UndefinedBehaviorSanitizer, which end it at the first overflow of a signed
number, shift too far or access beyond an array:

    cmake --preset host-sanitize && cmake --build --preset host-sanitize --target stability_test
    build/host-sanitize/tests/stability/stability_test

"""

TABLE = """## Hard cases

*Of what*: of all that theory says about a case, that in which the core uses up most of its bound. The bound is that of
|value − expected|. *Ledger* is emitted − absorbed − unshot − escaped − back over emitted, the largest seen on the way
(fixed) or in the end; the core's is an integer and is 0. *Escaped* is the core's. *Saturated* radiosities, and rises of the
unshot flux without overshooting: {saturated} and {rises} in all cases.

{table}
The core keeps {held} of {count} cases; the twin in double {double}, the float peer {float} of the {asked} that it takes (it
has no more than 32 lunes).

"""

FINDINGS = """## What the cases show

- **Float creates light where it is to bounce a thousand times.** A share that arrives is added to a sum that is a million
  times larger, and is rounded there by more than the 1 − ρ of it that is to be absorbed. Where it is rounded up light
  grows instead of fading: the peer does not come to its end, and when it is given up its ledger is off by 61 % of what was
  emitted at ρ = 0.999 and by 32 times that at 65535/65536. The core's sums are integers: nothing is rounded but the part
  that is reflected, and that on totals.
- **Integers have a last unit.** Flux keeps a headroom of 1 / (1 − ρ), so all that is emitted is 2^30 (1 − ρ) units. An
  element absorbs received − floor(ρ received): its first unit at once, half a unit too early in the mean. N elements
  are thereby N / 2 of 2^30 (1 − ρ) units too dark: nothing at ρ = 0.9, 0.1 % of 2000 elements at 0.999, 0.02 % of six at
  65535/65536. It shows in `LampsOfAMillionToOne`, where a room owns 531 units: 1.963, 1.977 in double, for 2. Rounding
  the reflected total to the nearest unit instead of down would take that back (1.973, the ledger still exact), but
  would give every solution other bits; it is not done.
- **Radiosity has a unit too.** It is 2^-27 of the brightest lamp's, so beside a lamp of a millionth of the room a wall has
  200 units, and is rounded down by half of one: 0.2 % in the mean. Its flux knows better
  (`LampOfAMillionthOfTheRoom`). Rounding to the nearest unit would take the mean error back, for other bits.
- **A face of one grid unit is seen through directions of 14 bits.** A strip one unit wide receives 10 % more than
  it should; double and float see it as it is.
- **Rotations keep every bit in fixed point only.** Sums of three integers do not depend on their order; sums in double
  and float do, so the same room turned gives another solution there. (A sign makes a difference where a product lies
  exactly halfway between two numbers, which is rounded up whatever its sign: in one random scene of a few hundred. The
  three cyclic rotations change no sign.)

"""

BOUND = """## Monotone and convergent

Without overshooting the sum of unshot flux never grows: a shot takes a units from its source, and of the a units that
arrive somewhere no more than a are reflected, since floor(ρ (r + 1)) − floor(ρ r) is 0 or 1. A test asks after every
shot.

The ledger gives an **error bound** for free. From any moment on, element j absorbs more than (1 − ρ_j) Δ_j − 1 units,
Δ_j being what it still receives, and all of them together no more than what is unshot, U. So

    Σ Δ_j  <  (U + N) / (1 − ρ_max)

for N elements; the N is rounding. Nothing was said about form factors: it holds for rows that are sampled anew for every
shot, and is the distance to where *this* solver goes, not to the solution with exact form factors. `fixrad compare`
prints it for each channel beside the distance, which it finds by shooting on until a thousandth of that is unshot.

- It bounds a **sum of flux** (the 1-norm), hence also the flux of each single element. It is no bound of the largest error of
  a radiosity: all that is missing may be missing on one small element. The maximum norm would need Σ_i A_i F_ij ≤ A_j, and
  sampled rows keep that reciprocity in the mean only.
- **With overshooting** unshot flux has either sign. For fixed form factors and exact arithmetic the bound holds with U = Σ
  |unshot|, as Δ = Σ (ρ F)^n u. With sampled rows a loan and its repayment leave by different rows, and their difference is
  not in the ledger: there it is measured, at every shot of five scenes, and not proven.
- In a closed room of one reflectance it is what happens, to the units of rounding.

    build/host/tests/stability/measure_stability --bounds

*Largest*: distance over bound, the largest of all channels and moments (before each shot, and where the solution stops at
0.1 % unshot); *at the end*: where it stops. 250 elements, 32 lunes.

{table}
"""

SCENES = """## Random scenes

Rooms, whole or without some walls, with up to four boxes, octahedra, quadrilaterals and triangles, turned, standing,
floating, running through each other; grey or coloured, one lamp or several; lunes, hemicube rows or pixels, with and without
overshooting. A scene depends on its seed alone. One that fails is made simpler as long as it fails, and printed as OBJ.

{table}
The command of a row is `check_scenes --property NAME --count SCENES`.
"""


def number(value):
    if value == 0 or 0.01 <= abs(value) < 1e7:
        return f"{value:.6g}"
    return f"{value:.2e}"


def used(finding):
    return abs(finding["value"] - finding["expected"]) / max(finding["bound"], 1e-12)


def holds(verdict):
    return verdict.get("ended", True) and all(f["holds"] for f in verdict["findings"])


def worst_index(case):
    findings = case["fixed"]["findings"]
    return max(range(len(findings)), key=lambda i: used(findings[i]))


def who_is_worse(case):
    """Who breaks a bound, or else whose error in the shown number is largest."""
    known = [name for name in ARITHMETICS if name in case]
    broken = [f"**{name}**" for name in known if not holds(case[name])]
    if broken:
        return ", ".join(broken)
    at = worst_index(case)
    shares = {name: used(case[name]["findings"][at]) for name in known if at < len(case[name]["findings"])}
    return max(shares, key=shares.get) if max(shares.values()) > 0 else "nobody"


def cell(case, name, at):
    if name not in case:
        return "—"
    finding = matching(case, name, at)
    text = number(finding["value"])
    return text if case[name].get("ended", True) else f"{text}, no end"


def matching(case, name, at):
    """The same law's finding: its worst face may be another one."""
    return case[name]["findings"][min(at, len(case[name]["findings"]) - 1)]


def case_table(cases):
    rows = []
    for case in cases:
        at = worst_index(case)
        finding = case["fixed"]["findings"][at]
        ledgers = [number(case["fixed"]["imbalance"])] + [number(case[n]["imbalance"]) for n in ARITHMETICS[1:] if n in case]
        rows.append([f"[{case['name']}](#{case['name'].lower()})", finding["what"], number(finding["expected"]),
                     *(cell(case, name, at) for name in ARITHMETICS), number(finding["bound"]), f"{case['shots']:,}",
                     " / ".join(ledgers), number(case["fixed"]["escaped"]), who_is_worse(case)])
    return table(["case", "of what", "expected", *ARITHMETICS, "bound", "shots", "ledger: fixed / double / float", "escaped",
                  "worse"], rows, ("shots",))


def sentence(case):
    """What came of a case, in words."""
    text = [f"{len(case['fixed']['findings'])} numbers are held to it; "
            + ("the core keeps them all" if holds(case["fixed"]) else "**the core does not keep them**")]
    for name in ARITHMETICS[1:]:
        if name not in case:
            continue
        broken = sum(not f["holds"] for f in case[name]["findings"])
        if not case[name].get("ended", True):
            text.append(f"{name} does not come to its end in four times as many shots"
                        + (f", with {100 * case[name]['imbalance']:.0f} % of the emitted light too much or too little"
                           if case[name]["imbalance"] > 0.005 else ""))
        if broken:
            text.append(f"{name} is beyond the bound of {broken}")
    return "; ".join(text) + "."


def case_text(case):
    return f"### {case['name']}\n\n{case['hard']} {case['theory']} {sentence(case)}\n\n" \
           f"    build/host/tests/stability/measure_stability {case['name']}\n\n"


def scene_table(rows):
    cells = [[name, theory, f"{count:,}", f"{closed:,}", "all" if is_good else "**not all**"]
             for name, theory, count, closed, is_good in rows]
    return table(["property", "theory", "scenes", "closed rooms", "keep to it"], cells, ("scenes", "closed rooms"))


def bound_table(bounds):
    rows = [[b["scene"], "yes" if b["overshoots"] else "no", f"{b['moments']:,}", f"{b['worst']:.6f}", f"{b['last']:.6f}"]
            for b in bounds]
    return table(["scene", "overshooting", "moments", "largest", "at the end"], rows, ("moments", "largest", "at the end"))


def page(cases, bounds, scenes):
    asked = [c for c in cases if "float" in c]
    return (HEAD + TABLE.format(table=case_table(cases), held=sum(holds(c["fixed"]) for c in cases), count=len(cases),
                                double=sum(holds(c["double"]) for c in cases), float=sum(holds(c["float"]) for c in asked),
                                asked=len(asked), saturated=sum(c["saturated"] for c in cases),
                                rises=sum(c["rises"] for c in cases if not c["overshoots"]))
            + FINDINGS + BOUND.format(table=bound_table(bounds)) + SCENES.format(table=scene_table(scenes))
            + "\n## Case by case\n\n" + "".join(case_text(c) for c in cases)).rstrip() + "\n"
