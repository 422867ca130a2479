// SPDX-License-Identifier: MIT
#include "host_sim/report/write_picture.h"

#include "host_sim/report/table_text.h"

namespace fixrad::host {
namespace {

std::string picture_record(const Vertex& v) {
  return braced({literal(v.x), literal(v.y), literal(v.z)});
}
std::string picture_record(const SidePoint& p) {
  return braced({literal(p.from), literal(p.to), literal(p.part)});
}
std::string picture_record(std::int16_t value) {
  return literal(value);
}
std::string picture_record(const PictureTriangle& t) {
  return braced({braced_array(t.corner), literal(t.material), literal(t.mirror)});
}
std::string picture_record(const PictureMaterial& m) {
  return braced({braced_array(m.specular), literal(m.exponent)});
}
std::string picture_record(const PictureMirror& m) {
  return braced({braced_array(m.normal), literal(m.offset), literal(m.material)});
}
std::string picture_record(const PictureLamp& l) {
  return braced(
      {braced_array(l.at), braced_array(l.normal), unsigned_literal(l.area),
       braced({unsigned_literal(l.light[0]), unsigned_literal(l.light[1]), unsigned_literal(l.light[2])})});
}

// The table, or none where there is nothing to put into it; what is to point at it.
template <class T>
std::string append_records(std::string& text, const std::string& type, const std::string& name,
                           const std::vector<T>& records) {
  if (records.empty()) {
    return "nullptr";
  }
  std::vector<std::string> lines;
  lines.reserve(records.size());
  for (const T& record : records) {
    lines.push_back(picture_record(record));
  }
  append_table(text, type + " " + name + "[]", lines);
  return name;
}

void append_camera(std::string& text, const PictureCamera& camera) {
  std::vector<std::pair<const char*, std::string>> members;
  static constexpr const char* kEye[] = {"eye[0]", "eye[1]", "eye[2]"};
  static constexpr const char* kAxes[3][3] = {{"right[0]", "right[1]", "right[2]"},
                                              {"up[0]", "up[1]", "up[2]"},
                                              {"forward[0]", "forward[1]", "forward[2]"}};
  for (int k = 0; k < 3; ++k) {
    members.emplace_back(kEye[k], literal(camera.eye[k]));
    members.emplace_back(kAxes[0][k], literal(camera.right[k]));
    members.emplace_back(kAxes[1][k], literal(camera.up[k]));
    members.emplace_back(kAxes[2][k], literal(camera.forward[k]));
  }
  members.emplace_back("focal", unsigned_literal(camera.focal));
  members.emplace_back("width", literal(camera.width));
  members.emplace_back("height", literal(camera.height));
  append_function(text, "PictureCamera", "picture_camera", members);
}

}  // namespace

void append_picture(std::string& text, const PictureTable& table) {
  text += "\n// The picture: " + literal(static_cast<std::int64_t>(table.triangles.size())) + " triangles, " +
          literal(table.camera.width) + " x " + literal(table.camera.height) + " pixels.\n";
  const PictureScene scene = table.view();
  std::vector<std::pair<const char*, std::string>> members = {
      {"vertices", append_records(text, "fixrad::Vertex", "kPictureVertices", table.vertices)},
      {"side_points", append_records(text, "fixrad::SidePoint", "kSidePoints", table.side_points)},
      {"normals", append_records(text, "int16_t", "kPictureNormals", table.normals)},
      {"triangles", append_records(text, "fixrad::PictureTriangle", "kTriangles", table.triangles)},
      {"materials", append_records(text, "fixrad::PictureMaterial", "kPictureMaterials", table.materials)},
      {"mirrors", append_records(text, "fixrad::PictureMirror", "kMirrors", table.mirrors)},
      {"lamps", append_records(text, "fixrad::PictureLamp", "kLamps", table.lamps)},
      {"vertex_count", literal(scene.vertex_count)},
      {"side_point_count", literal(scene.side_point_count)},
      {"triangle_count", literal(scene.triangle_count)},
      {"material_count", literal(scene.material_count)},
      {"mirror_count", literal(scene.mirror_count)},
      {"lamp_count", literal(scene.lamp_count)},
      {"highlights", scene.highlights != nullptr ? "fixrad::add_highlights" : "nullptr"},
      {"channels", literal(scene.channels)},
      {"background", literal(scene.background)}};
  append_function(text, "PictureScene", "picture", members);
  append_camera(text, table.camera);
  append_function(
      text, "Exposure", "picture_exposure",
      {{"factor", unsigned_literal(table.exposure.factor)}, {"shift", literal(table.exposure.shift)}});
}

}  // namespace fixrad::host
