// SPDX-License-Identifier: MIT
// Polygons of any shape through the meshing: they are refused with one line, or the core takes the tables
// that come of them.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdio>
#include <string>

#include "host_sim/meshing/device_scene.h"
#include "lib/scene/load.h"

namespace {

using fixrad::host::Model;

constexpr int kMostVertices = 16, kMostFaces = 6;

// Coarse coordinates often, so that corners fall together and faces lie in one plane.
double coordinate(FuzzedDataProvider& in) {
  const int bits = in.ConsumeIntegral<std::uint8_t>();
  if (bits < 224) {
    return bits % 8;
  }
  return bits < 252 ? in.ConsumeIntegral<std::int32_t>() / 1024.0
                    : in.ConsumeFloatingPointInRange(-1e30, 1e30);
}

Model any_model(FuzzedDataProvider& in) {
  Model model;
  model.path = "s.obj";
  for (int i = in.ConsumeIntegralInRange(3, kMostVertices); i > 0; --i) {
    const double x = coordinate(in), y = coordinate(in), z = coordinate(in);
    model.positions.emplace_back(x, y, z);
  }
  for (int i = in.ConsumeIntegralInRange(1, 2); i > 0; --i) {
    const double reflectance = in.ConsumeIntegral<std::uint8_t>() / 256.0;
    const double emission = in.ConsumeFloatingPointInRange(1e-30, 1e30);
    model.materials.push_back({"m", glm::dvec3(reflectance, 0.5, 0.5), glm::dvec3(emission, 0.0, 1.0)});
  }
  for (int i = in.ConsumeIntegralInRange(1, kMostFaces); i > 0; --i) {
    fixrad::host::Face face;
    const std::size_t corners = in.ConsumeIntegralInRange<std::size_t>(3, 10);
    std::uint32_t corner = in.ConsumeIntegral<std::uint8_t>();
    for (std::size_t k = 0; k < corners && k < model.positions.size(); ++k) {
      corner += 1 + in.ConsumeIntegralInRange<std::uint32_t>(0, 1);  // no corner twice, most often
      face.corners.push_back(corner % static_cast<std::uint32_t>(model.positions.size()));
    }
    face.material =
        in.ConsumeIntegralInRange<std::uint32_t>(0, static_cast<std::uint32_t>(model.materials.size() - 1));
    face.line = i;
    model.faces.push_back(face);
  }
  model.file_faces = model.faces.size();
  return model;
}

fixrad::host::Meshing any_meshing(FuzzedDataProvider& in, const fixrad::host::PreparedScene& scene) {
  fixrad::host::Meshing meshing;
  for (const fixrad::host::FaceFrame& frame : scene.frames) {
    const int nu = in.ConsumeIntegralInRange(1, 3), nv = in.ConsumeIntegralInRange(1, 2);
    meshing.faces.push_back(cut_face(frame, nu, nv));
    meshing.element_count += static_cast<std::uint32_t>(meshing.faces.back().elements.size());
  }
  return meshing;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider in(data, size);
  const Model model = any_model(in);
  try {
    const fixrad::host::PreparedScene scene = prepare(model);
    const fixrad::host::DeviceScene device = make_device_scene(scene, any_meshing(in, scene));
    const fixrad::Status status = fixrad::check_scene(device.view(), {65535, 65535, 65535, 3});
    // Of a lamp smaller than the unit of areas, rounding may make more light than there is headroom for.
    if (status != fixrad::Status::ok && status != fixrad::Status::flux_overflow) {
      std::fprintf(stderr, "check_scene() says %d\n", static_cast<int>(status));
      __builtin_trap();
    }
  } catch (const fixrad::host::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      __builtin_trap();
    }
  }
  return 0;
}
