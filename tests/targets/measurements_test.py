#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""firmware/measurements.json and the pages made of it belong to the committed scenes; what does not is found."""

import copy
import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import measure_targets  # noqa: E402
import targets_page  # noqa: E402
from check_count import differences  # noqa: E402

TAKEN_FROM_HEADERS = ("digest", "shots", "eyes", "elements", "limits")


def stale(measured, presets, scenes_of, header_of):
    """Lines that say what is not as committed."""
    lines = [f"{p}: not measured" for p in presets if p not in measured["targets"]]
    for preset, target in measured["targets"].items():
        wanted = scenes_of(presets[preset][1])
        if list(target["scenes"]) != wanted:
            lines.append(f"{preset}: measured {', '.join(target['scenes'])} instead of {', '.join(wanted)}")
        for name in set(wanted) & set(target["scenes"]):
            header = header_of(name)
            lines += [f"{preset}, {name}: {key} {target['scenes'][name][key]} was measured, {header[key]} is committed"
                      for key in TAKEN_FROM_HEADERS if target["scenes"][name][key] != header[key]]
            if measured["errors"].get(name, {}).get("digest") != header["digest"]:
                lines.append(f"{name}: the error is not of this digest")
    return lines


class Measurements(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.measured = json.loads((ROOT / "firmware/measurements.json").read_text())
        cls.presets = measure_targets.target_presets()
        boards = {board: measure_targets.scenes_of(board) for _, board in cls.presets.values()}
        cls.scenes_of = boards.get
        cls.header_of = staticmethod(measure_targets.header_of)

    def problems(self, measured):
        return stale(measured, self.presets, type(self).scenes_of, self.header_of)

    def changed(self):
        measured = copy.deepcopy(self.measured)
        return measured, measured["targets"]["cortex-m0"]["scenes"]

    def test_agree_with_the_committed_scenes(self):
        self.assertEqual(self.problems(self.measured), [], "run scripts/measure_targets.py")

    def test_pages_are_what_the_measurements_make(self):
        for path, text in targets_page.pages(ROOT, self.measured).items():
            self.assertTrue(path.read_text() == text, f"{path}: run scripts/measure_targets.py --pages")

    def test_every_target_passed_its_tests(self):
        for preset, target in self.measured["targets"].items():
            self.assertEqual(target["tests"][0], target["tests"][1], preset)

    def test_no_program_used_more_stack_than_the_worst_case(self):
        for preset, target in self.measured["targets"].items():
            for name, scene in target["scenes"].items():
                self.assertLessEqual(scene["stack"], target["static_stack"]["program"], f"{preset}, {name}")

    def test_another_digest_is_found(self):
        measured, scenes = self.changed()
        scenes["cornell_small"]["digest"] = "0" * 16
        self.assertEqual(len(self.problems(measured)), len(self.problems(self.measured)) + 1)

    def test_a_missing_scene_is_found(self):
        measured, scenes = self.changed()
        del scenes["cornell_small"]
        self.assertIn("cortex-m0: measured", "\n".join(self.problems(measured)))

    def test_a_missing_target_is_found(self):
        measured, _ = self.changed()
        del measured["targets"]["cortex-m0"]
        self.assertIn("cortex-m0: not measured", self.problems(measured))

    def test_two_per_cent_more_instructions_pass_and_three_do_not(self):
        known = self.measured["targets"]["cortex-m0"]["bench"]["cornell_small"]["core"]["solve"]
        self.assertEqual(differences(self.measured, "cortex-m0", "cornell_small", int(known * 1.0199), {}), [])
        for factor in (1.03, 0.97):
            self.assertEqual(len(differences(self.measured, "cortex-m0", "cornell_small", int(known * factor), {})), 1)

    def test_one_byte_of_ram_is_found(self):
        scene = self.measured["targets"]["cortex-m0"]["scenes"]["cornell_small"]
        count = self.measured["targets"]["cortex-m0"]["bench"]["cornell_small"]["core"]["solve"]
        for extra, found in ((0, 0), (1, 1)):
            rams = {"cornell_small": scene["ram"] + extra}
            self.assertEqual(len(differences(self.measured, "cortex-m0", "cornell_small", count, rams)), found)


if __name__ == "__main__":
    unittest.main()
