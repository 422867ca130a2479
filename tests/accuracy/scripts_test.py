#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/accuracy.md is computed with: form factors by contour integrals, errors of face means, bars."""

import math
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

import accuracy_page  # noqa: E402
import measure_accuracy  # noqa: E402
from closed_forms import FLOOR, area, form_factor, pairs, rectangle, tilted  # noqa: E402
from face_errors import FaceError, error_of, uncertainty_of  # noqa: E402


def parallel(x, y):
    """Equal opposed rectangles, sides over distance x and y: Howell, Catalog of Configuration Factors, C-11."""
    p, q = 1 + x * x, 1 + y * y
    return 2 / (math.pi * x * y) * (math.log(math.sqrt(p * q / (p + q - 1))) + x * math.sqrt(q) * math.atan(x / math.sqrt(q))
                                    + y * math.sqrt(p) * math.atan(y / math.sqrt(p)) - x * math.atan(x) - y * math.atan(y))


def perpendicular(h, w):
    """Rectangles with a common edge, over whose length the source is w wide and the receiver h high: C-14."""
    a, b, c = 1 + w * w, 1 + h * h, 1 + h * h + w * w
    logarithm = math.log(a * b / c * (w * w * c / (a * (c - 1))) ** (w * w) * (h * h * c / (b * (c - 1))) ** (h * h))
    root = math.sqrt(h * h + w * w)
    return (w * math.atan(1 / w) + h * math.atan(1 / h) - root * math.atan(1 / root) + logarithm / 4) / (math.pi * w)


class FormFactor(unittest.TestCase):
    def test_of_opposed_rectangles_is_the_catalogue_s(self):
        for x, y, distance in ((1, 1, 1), (1, 1, 0.05), (3, 0.5, 2)):
            low, high = rectangle((0, 0, 0), (0, 0, y), (x, 0, 0)), rectangle((0, distance, 0), (x, 0, 0), (0, 0, y))
            self.assertAlmostEqual(form_factor(low, high), parallel(x / distance, y / distance), 10)

    def test_of_rectangles_with_a_common_edge_is_the_catalogue_s(self):
        for height, width in ((1, 1), (2, 1), (0.2, 3)):
            low, high = rectangle((0, 0, 0), (0, 0, 1), (width, 0, 0)), rectangle((0, 0, 0), (0, height, 0), (0, 0, 1))
            self.assertAlmostEqual(form_factor(low, high), perpendicular(height, width), 10)

    def test_from_a_face_of_a_wedge_to_the_others_sums_to_one(self):
        # Floor, leaning square, the rectangle that closes them and two isosceles triangles.
        angle = math.radians(60)
        apex = (math.cos(angle), math.sin(angle))
        lid = [(1, 0, 0), (1, 0, 1), (*apex, 1), (*apex, 0)]
        ends = [[(0, 0, z), (1, 0, z), (*apex, z)] for z in (0, 1)]
        self.assertAlmostEqual(sum(form_factor(FLOOR, other) for other in (tilted(60), lid, *ends)), 1, 10)

    def test_is_reciprocal(self):
        for name, source, receiver in pairs():
            there, back = area(source) * form_factor(source, receiver), area(receiver) * form_factor(receiver, source)
            self.assertAlmostEqual(there, back, 11, name)


def face(number, area_of, level, emits=False, error=0.0):
    return {"face": number, "material": "m", "area": area_of, "emits": emits, "b": [level] * 3, "error": [error] * 3}


class FaceErrors(unittest.TestCase):
    TRUTH = [face(0, 1, 100, emits=True), face(1, 3, 2, error=0.02), face(2, 1, 1), face(3, 1, 0.1)]

    def test_of_the_truth_itself_are_zero(self):
        self.assertEqual(error_of(self.TRUTH, self.TRUTH), FaceError(0, 0, "1, m"))

    def test_weigh_by_area_leave_lamps_out_and_name_the_worst_face_that_is_not_dark(self):
        # Area times B: 6, 1 and 0.1 W; a tenth of the mean radiosity is 0.142.
        baked = [face(0, 1, 50), face(1, 3, 2.1), face(2, 1, 0.8), face(3, 1, 0.3)]
        error = error_of(baked, self.TRUTH)
        self.assertAlmostEqual(error.mean, (3 * 0.1 + 0.2 + 0.2) / 7.1)
        self.assertAlmostEqual(error.worst, 0.2)
        self.assertEqual(error.face, "2, m")

    def test_count_all_faces_where_all_emit(self):
        truth = [face(0, 1, 2, emits=True), face(1, 1, 2, emits=True)]
        self.assertAlmostEqual(error_of([face(0, 1, 2), face(1, 1, 3)], truth).mean, 1 / 4)

    def test_uncertainty_is_that_of_the_standard_errors(self):
        noise = uncertainty_of(self.TRUTH)
        self.assertAlmostEqual(noise.mean, 3 * 0.02 / 7.1)
        self.assertAlmostEqual(noise.worst, 0.01)

    def test_refuse_a_truth_of_another_scene(self):
        with self.assertRaises(ValueError):
            error_of(self.TRUTH[1:], self.TRUTH)


def measured(*errors):
    return measure_accuracy.Measured("scene", [measure_accuracy.Run(100 + k, FaceError(*e, "0, m"), {}) for k, e in enumerate(errors)])


class Bars(unittest.TestCase):
    def test_hold_only_if_every_mesh_holds(self):
        good, mean, worst = (0.004, 0.04), (0.006, 0.04), (0.004, 0.06)
        self.assertEqual(accuracy_page.missed(measured(good, good, good), "large"), [])
        self.assertEqual(accuracy_page.missed(measured(good, mean, good), "large"), ["mean"])
        self.assertEqual(accuracy_page.missed(measured(good, mean, worst), "large"), ["mean", "worst"])

    def test_of_profile_tiny_ask_for_the_mean_alone(self):
        self.assertEqual(accuracy_page.missed(measured((0.025, 0.9)), "tiny"), [])
        self.assertEqual(accuracy_page.missed(measured((0.026, 0.0)), "tiny"), ["mean"])

    def test_count_scenes_in_the_summary(self):
        row = accuracy_page.count_row("scenes", "small", [measured((0.009, 0.1)), measured((0.02, 0.2))])
        self.assertIn("**1 of 2**", row)
        self.assertIn("2.00 % scene", row)


if __name__ == "__main__":
    unittest.main()
