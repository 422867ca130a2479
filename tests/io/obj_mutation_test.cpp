// SPDX-License-Identifier: MIT
// Whatever bytes come in, the reader answers with a sound Model or an InputError. Run it under the
// sanitizers, too.
#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "host_sim/io/text_file.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kVariants = 4000;

/// Fragments that a blind flip of bytes rarely hits.
const char* const kFragments[] = {
    "nan",  "inf",       "1e999",   "-0",      "1e-999",  "-1",  "0",       "99999999999999999999",
    "\\\n", "\\\r\n",    "\n",      "\r",      "#",       "/",   "//",      " ",
    "f ",   "\nf 1 2\n", "\nv 1\n", "usemtl ", "newmtl ", "Kd ", "mtllib ", "\xEF\xBB\xBF"};

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  std::string mutate(std::string text) {
    for (std::size_t count = 1 + below(4); count > 0; --count) {
      apply_one(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void apply_one(std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t length = below(40);
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, kFragments[below(std::size(kFragments))]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 4:
        text.resize(at + 1);
        break;
      default:
        text.replace(at, 1, kFragments[below(std::size(kFragments))]);
        break;
    }
  }

  std::mt19937 random_;
};

void expect_sound(const Model& model) {
  EXPECT_FALSE(model.faces.empty());
  EXPECT_EQ(model.file_faces, model.faces.size());
  for (const glm::dvec3& position : model.positions) {
    EXPECT_TRUE(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z));
  }
  for (const Face& face : model.faces) {
    EXPECT_GE(face.corners.size(), 3U);
    EXPECT_LT(face.material, model.materials.size());
    for (const std::uint32_t corner : face.corners) {
      EXPECT_LT(corner, model.positions.size());
    }
  }
  for (const Material& material : model.materials) {
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_TRUE(material.reflectance[channel] >= 0.0 && material.reflectance[channel] < 1.0);
      EXPECT_TRUE(material.emission[channel] >= 0.0 && std::isfinite(material.emission[channel]));
    }
  }
}

/// Reads a variant; true if it was accepted.
bool read_variant(const std::string& obj, const std::string& mtl) {
  try {
    expect_sound(read(obj, {{"cornell.mtl", mtl}}));
    return true;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(": error: "), Not(HasSubstr("\n"))));
    return false;
  }
}

TEST(ObjMutation, EveryVariantOfTheCornellBoxIsReadOrRefused) {
  const std::string obj = read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.obj");
  const std::string mtl = read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.mtl");
  int accepted = 0;
  for (std::uint32_t seed = 0; seed < kVariants; ++seed) {
    SCOPED_TRACE(seed);
    Mutator mutator(seed);
    const bool mutate_mtl = seed % 4 == 0;
    accepted += mutate_mtl ? read_variant(obj, mutator.mutate(mtl)) : read_variant(mutator.mutate(obj), mtl);
  }
  // Both answers must really occur, or the variants test nothing.
  EXPECT_GT(accepted, kVariants / 20);
  EXPECT_LT(accepted, kVariants * 19 / 20);
}

TEST(ObjMutation, EveryTruncationOfTheCornellBoxIsReadOrRefused) {
  const std::string obj = read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.obj");
  const std::string mtl = read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.mtl");
  for (std::size_t size = 0; size < obj.size(); ++size) {
    SCOPED_TRACE(size);
    // Without the first face in the material of the lamp nothing emits light.
    const bool has_lamp = obj.substr(0, size).find("f 5 6 7") != std::string::npos;
    const bool accepted = read_variant(obj.substr(0, size), mtl);
    EXPECT_TRUE(has_lamp || !accepted);
  }
}

}  // namespace
}  // namespace fixrad::host
