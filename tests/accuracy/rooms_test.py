#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What scripts/random_rooms.py promises of a seed: the same bytes always, and a room as it describes."""

import hashlib
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

from random_rooms import SEEDS, random_room  # noqa: E402
from scene_writer import files_of  # noqa: E402

# First 16 digits of the SHA-256 of a seed's OBJ and MTL: accuracy is compared over time on these very rooms.
DIGESTS = {
    1: "4505accd454be7ac",
    2: "eeb87827f86ec9e5",
    3: "c12d710caec129a8",
    4: "1a7fd3a66b1c28e8",
    5: "0fd7e7a965481851",
    6: "aeeba615311af2fa",
    7: "5e1d6319366ea820",
    8: "bf3b50a66c9ab1b7",
    9: "3fd90bb6266ca63b",
    10: "dc875ff7c651bea7",
    11: "13cfa7d2e373a905",
    12: "34af4c871f68c2ec",
    13: "e244656bb624a04e",
    14: "2fcb16a447c4b035",
    15: "8a9c9c8e5caa2778",
    16: "1e49d16b6084d134",
    17: "bb5f7b2f19616016",
    18: "b032fb28ca96fb1f",
    19: "918d88bbe79cdf3d",
    20: "fbe775d236ab399e",
}


class RandomRooms(unittest.TestCase):
    def test_a_seed_always_gives_the_same_files(self):
        for seed in SEEDS:
            content = b"".join(text for _, text in sorted(files_of(random_room(seed), by="random_rooms.py").items()))
            self.assertEqual(hashlib.sha256(content).hexdigest()[:16], DIGESTS[seed], f"seed {seed}")

    def test_rooms_hold_three_to_eight_solids_and_one_to_three_lamps(self):
        for seed in SEEDS:
            scene = random_room(seed)
            lamps = [name for name, (_, emission) in scene.materials.items() if any(emission)]
            self.assertIn(len(scene.parts) - 1, range(3, 9), f"seed {seed}")
            self.assertIn(len(lamps), range(1, 4), f"seed {seed}")

    def test_reflectances_are_a_tenth_to_nine_tenths(self):
        for seed in SEEDS:
            for name, (reflectance, _) in random_room(seed).materials.items():
                self.assertTrue(all(0.1 <= c <= 0.9 for c in reflectance), f"seed {seed}, {name}: {reflectance}")

    def test_some_rooms_are_grey_and_some_are_coloured(self):
        grey = {all(len(set(c)) == 1 for m in random_room(seed).materials.values() for c in m) for seed in SEEDS}
        self.assertEqual(grey, {True, False})


if __name__ == "__main__":
    unittest.main()
