// SPDX-License-Identifier: MIT
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/report/encode.h"
#include "host_sim/report/mesh_check.h"
#include "host_sim/report/text.h"
#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {
namespace {

using Floats = std::vector<float>;  ///< three a vertex

void append(Floats& floats, const glm::dvec3& v) {
  floats.insert(floats.end(), {finite_float(v.x), finite_float(v.y), finite_float(v.z)});
}

/// A quarter turn about x: the scene's +z becomes glTF's +Y, its +y becomes -Z.
glm::dvec3 to_gltf(const glm::dvec3& v, bool z_up) {
  return z_up ? glm::dvec3(v.x, v.z, -v.y) : v;
}

/// Appends raw little-endian data to the only buffer and makes view and accessor for it; returns the
/// accessor.
template <typename Number>
int add_accessor(tinygltf::Model& gltf, const std::vector<Number>& data, int component_type, int type,
                 int target) {
  std::vector<unsigned char>& bytes = gltf.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = data.size() * sizeof(Number);
  view.target = target;
  bytes.resize(view.byteOffset + view.byteLength);
  std::memcpy(bytes.data() + view.byteOffset, data.data(), view.byteLength);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(gltf.bufferViews.size());
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = data.size() / static_cast<std::size_t>(
                                     tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
  gltf.bufferViews.push_back(std::move(view));
  gltf.accessors.push_back(std::move(accessor));
  return static_cast<int>(gltf.accessors.size()) - 1;
}

int add_vectors(tinygltf::Model& gltf, const Floats& floats) {
  return add_accessor(gltf, floats, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                      TINYGLTF_TARGET_ARRAY_BUFFER);
}

/// glTF demands the bounds of POSITION, taken from the floats as they are stored.
void set_bounds(tinygltf::Accessor& accessor, const Floats& floats) {
  accessor.minValues.assign(floats.begin(), floats.begin() + 3);
  accessor.maxValues = accessor.minValues;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    const double value = floats[i];
    accessor.minValues[i % 3] = std::min(accessor.minValues[i % 3], value);
    accessor.maxValues[i % 3] = std::max(accessor.maxValues[i % 3], value);
  }
}

tinygltf::Primitive make_primitive(tinygltf::Model& gltf, const BakedMesh& mesh, bool z_up, double scale) {
  Floats positions;
  Floats normals;
  Floats colours;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append(positions, to_gltf(mesh.positions[i], z_up));
    append(normals, glm::normalize(to_gltf(mesh.normals[i], z_up)));
    append(colours, tone(mesh.radiosity[i] * scale));
  }
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  const int position = add_vectors(gltf, positions);
  set_bounds(gltf.accessors[static_cast<std::size_t>(position)], positions);
  primitive.attributes["POSITION"] = position;
  primitive.attributes["NORMAL"] = add_vectors(gltf, normals);
  primitive.attributes["COLOR_0"] = add_vectors(gltf, colours);
  primitive.indices = add_accessor(gltf, indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                                   TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return primitive;
}

/// Unlit: the colours are light already. What a viewer without the extension falls back on is a matt surface.
tinygltf::Material unlit_material() {
  tinygltf::Material material;
  material.name = "baked";
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 1.0;
  material.extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object());
  return material;
}

tinygltf::Model make_model(const BakedMesh& mesh, const Display& display) {
  const double scale = exposure_scale(mesh, display);
  tinygltf::Model gltf;
  gltf.asset.version = "2.0";
  gltf.asset.generator = "fixrad";
  gltf.asset.extras = tinygltf::Value(tinygltf::Value::Object{
      {"COLOR_0", tinygltf::Value(std::string("tone(radiosity in W/m^2 * exposure), linear"))},
      {"exposure", tinygltf::Value(scale)},
      {"exposure_ev", tinygltf::Value(display.exposure_ev)}});
  gltf.extensionsUsed = {"KHR_materials_unlit"};
  gltf.materials.push_back(unlit_material());
  gltf.buffers.emplace_back();
  tinygltf::Mesh object;
  object.name = mesh.name;
  object.primitives.push_back(make_primitive(gltf, mesh, display.z_up, scale));
  gltf.meshes.push_back(std::move(object));
  tinygltf::Node node;
  node.mesh = 0;
  gltf.nodes.push_back(std::move(node));
  gltf.scenes.emplace_back();
  gltf.scenes[0].nodes = {0};
  gltf.defaultScene = 0;
  return gltf;
}

}  // namespace

std::string encode_glb(const BakedMesh& mesh, const Display& display) {
  check_mesh(mesh);
  const tinygltf::Model gltf = make_model(mesh, display);
  std::ostringstream stream;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&gltf, stream, false, true)) {
    throw std::runtime_error("the glTF library cannot serialise the mesh");
  }
  return stream.str();
}

void write_glb(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display) {
  write_text(target, encode_glb(mesh, display));
}

}  // namespace fixrad::host
