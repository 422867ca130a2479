// SPDX-License-Identifier: MIT
// The public functions in any order that their contracts allow, over a scene that load() has taken:
// everything stays defined, and the ledger exact after each call.
#include "lib/picture/draw.h"
#include "lib/picture/highlight.h"
#include "lib/picture/tone.h"
#include "tests/fuzz/byte_scene.h"

namespace fixrad::fuzz {
namespace {

constexpr int kMostCalls = 12;
constexpr std::uint16_t kRoom = kElements;
constexpr std::uint16_t kMatrixElements = 12;
constexpr std::uint16_t kPictureSide = 12;

// A solver with everything that its functions want beside it, as a firmware would hold it.
class Session {
 public:
  explicit Session(FuzzedDataProvider& in) : in_(in) {}

  void run() {
    if (!load()) {
      return;
    }
    for (int i = 0; i < kMostCalls && in_.remaining_bytes() > 0; ++i) {
      call();
      require_ledger(solver_.state());
    }
  }

 private:
  // A scene that is refused changes nothing: the one before goes on.
  bool load() {
    const Settings settings = any_settings(in_, in_.ConsumeIntegralInRange(0, 31) == 0);
    ByteScene next = sound_scene(in_);
    if (solver_.load(next.view(), settings) != Status::ok) {
      return false;
    }
    scene_ = std::move(next);
    is_refinable_ = false;
    return true;
  }

  void call() {
    switch (in_.ConsumeIntegralInRange(0, 12)) {
      case 0:
        (void)load();
        break;
      case 1:
        read_vertices();
        break;
      case 2:
        gather_at_vertex();
        break;
      case 3:
        read_out();
        break;
      case 4:
        refine();
        break;
      case 5:
        solve_by_gathering();
        break;
      case 6:
        draw();
        break;
      case 7:
        refuse_bad_scene();
        break;
      case 8:
        (void)solver_.step(in_.ConsumeIntegral<std::uint8_t>());
        break;
      default:
        (void)solver_.step();
        break;
    }
  }

  void refuse_bad_scene() {
    Scene bad = solver_.state().scene;
    bad.channels = 2;
    if (solver_.load(bad) == Status::ok) {
      __builtin_trap();
    }
  }

  std::uint16_t any_element() {
    return static_cast<std::uint16_t>(in_.ConsumeIntegral<std::uint8_t>() %
                                      solver_.state().scene.element_count);
  }

  int any_channel() { return in_.ConsumeIntegral<std::uint8_t>() % solver_.state().scene.channels; }

  const DeltaTable& table() const { return solver_.state().settings.tables[0]; }

  void read_vertices() {
    const std::uint16_t elements[2] = {any_element(), any_element()};
    const MeshVertex vertices[2] = {{0, in_.ConsumeBool() ? 1u : kNoVertex, 2}, {1, kNoVertex, 1}};
    const VertexMap map = {vertices, elements, 2};
    (void)solver_.vertex_radiosity(map, 0, any_channel(), in_.ConsumeBool());
    (void)digest(solver_.state(), map);
  }

  void gather_at_vertex() {
    const std::uint16_t e = any_element();
    const Element& element = solver_.state().scene.elements[e];
    const GatherPoint points[2] = {
        {{element.eye[0], element.eye[1], element.eye[2]}, e},
        {{in_.ConsumeIntegral<std::uint16_t>(), in_.ConsumeIntegral<std::uint16_t>(),
          in_.ConsumeIntegral<std::uint16_t>()},
         e}};
    Radiosity ambient[kMaxChannels] = {};
    for (Radiosity& a : ambient) {
      a = Radiosity::from_raw(in_.ConsumeIntegral<std::uint32_t>());
    }
    VertexLight light;
    (void)gather_vertex(solver_.state(), table(), in_.ConsumeBool() ? correct_direct_light : nullptr, points,
                        2, in_.ConsumeIntegralInRange<std::uint8_t>(1, 2), ambient, light);
  }

  void read_out() {
    const State& state = solver_.state();
    const int channel = any_channel();
    const Radiosity ambient = ambient_radiosity(state, channel);
    (void)element_radiosity(state, any_element(), channel, ambient);
    (void)exitent_flux(state, any_element(), channel);
    (void)unshot_fraction(state);
  }

  RefinedScene tables() {
    return {elements_, patch_elements_, sights_, errors_, patches_, roots_,
            cuts_,     kRoom,           kRoom,   kRoom,   kRoom};
  }

  void refine() {
    State& state = solver_.state();
    if (state.sweep.kind == SourceKind::face) {
      return;
    }
    RefinedScene refined = tables();
    if (!is_refinable_) {
      is_refinable_ = make_refinable(state.scene, refined) == Status::ok &&
                      start_refining(state, refined, table()) == Status::ok;
    }
    for (int i = 0; is_refinable_ && i < 2; ++i) {
      (void)split_worst(state, refined, table());
      require_ledger(state);
    }
  }

  // Books the result in place of what was shot: only a solver that has not shot yet may do so.
  void solve_by_gathering() {
    State& state = solver_.state();
    const std::uint16_t n = state.scene.element_count;
    if (n > kMatrixElements || state.shots > 0 || is_refinable_) {
      return;
    }
    FormFactorMatrix matrix = {share_, back_, exitent_};
    for (std::uint16_t e = 0; e < n; ++e) {
      if (sample_matrix_row(state, matrix, e) != Status::ok) {
        return;
      }
    }
    for (int i = 0; i < 3 && !gather_sweep(state, matrix); ++i) {
    }
    book_gathering(state, matrix);
  }

  PictureCamera any_camera() {
    const std::int16_t one = kUnit;
    PictureCamera camera = {{0, 0, 0}, {one, 0, 0}, {0, one, 0}, {0, 0, one}, 0, 0, 0};
    for (std::int32_t& a : camera.eye) {
      a = in_.ConsumeIntegralInRange<std::int32_t>(-16384, 32767);
    }
    if (in_.ConsumeBool()) {  // from the other side
      camera.right[0] = camera.forward[2] = static_cast<std::int16_t>(-one);
    }
    camera.focal = in_.ConsumeIntegralInRange<std::uint32_t>(1, 1u << 14);
    camera.width = in_.ConsumeIntegralInRange<std::uint16_t>(1, kPictureSide);
    camera.height = in_.ConsumeIntegralInRange<std::uint16_t>(1, kPictureSide);
    return camera;
  }

  void draw() {
    const Scene& scene = solver_.state().scene;
    PictureTriangle triangles[2 * kFaces];
    PictureScene picture = {};
    for (std::uint16_t f = 0; f < scene.face_count; ++f) {
      const Face& face = scene.faces[f];
      for (std::uint8_t k = 1; k + 1 < face.corner_count && picture.triangle_count < 2 * kFaces; ++k) {
        const std::uint16_t* corner = scene.corners + face.first_corner;
        const bool is_mirror = f == 0 && in_.ConsumeBool();
        triangles[picture.triangle_count++] = {{corner[0], corner[k], corner[k + 1]},
                                               static_cast<std::uint8_t>(f % 2),
                                               is_mirror ? std::uint8_t{0} : kNoMirror};
      }
    }
    const PictureMaterial materials[2] = {{{60000, 50000, 40000}, 0}, {{30000, 1, 65535}, 90}};
    const Face& first = scene.faces[0];
    const Vertex& corner = scene.vertices[scene.corners[first.first_corner]];
    const PictureMirror mirror = {
        {first.normal[0], first.normal[1], first.normal[2]},
        first.normal[0] * corner.x + first.normal[1] * corner.y + first.normal[2] * corner.z,
        0};
    const Element& lamp = scene.elements[0];
    const PictureLamp lamps[1] = {{{lamp.eye[0], lamp.eye[1], lamp.eye[2]},
                                   {first.normal[0], first.normal[1], first.normal[2]},
                                   lamp.area,
                                   {in_.ConsumeIntegral<std::uint32_t>(), 1, 65535}}};
    std::int16_t normals[kVertices * 3];
    for (int i = 0; i < 3 * kVertices; ++i) {
      normals[i] = first.normal[i % 3];
    }
    picture.vertices = scene.vertices;
    picture.normals = normals;
    picture.triangles = triangles;
    picture.materials = materials;
    picture.mirrors = &mirror;
    picture.lamps = lamps;
    picture.vertex_count = scene.vertex_count;
    picture.material_count = 2;
    picture.mirror_count = picture.lamp_count = 1;
    picture.highlights = in_.ConsumeBool() ? add_highlights : nullptr;
    picture.channels = scene.channels;
    const auto read = [](void* context, std::uint16_t vertex, std::uint16_t* light) {
      const State& state = static_cast<Session*>(context)->solver_.state();
      for (int c = 0; c < state.scene.channels; ++c) {
        const auto e = static_cast<std::uint16_t>(vertex % state.scene.element_count);
        light[c] = expose({3000000000u, 40}, element_radiosity(state, e, c, Radiosity::from_raw(0)));
      }
    };
    const auto take = [](void*, std::uint16_t, const std::uint8_t*) {};
    std::uint16_t depth[2 * kPictureSide], light[2 * kPictureSide * 3];
    const PictureStatus status =
        draw_picture(picture, any_camera(), {this, read}, {depth, light, 2}, {nullptr, take});
    if (status != PictureStatus::ok) {
      __builtin_trap();
    }
  }

  FuzzedDataProvider& in_;
  ByteScene scene_;
  bool is_refinable_ = false;
  static Solver<FuzzLimits> solver_;
  static Element elements_[kRoom];
  static std::uint16_t patch_elements_[kRoom], roots_[kRoom];
  static Sight sights_[kRoom];
  static std::uint32_t errors_[kRoom];
  static Patch patches_[kRoom];
  static Cut cuts_[kRoom];
  static std::uint16_t share_[kMatrixElements * kMatrixElements], back_[kMatrixElements];
  static std::int32_t exitent_[kMatrixElements * kMaxChannels];
};

Solver<FuzzLimits> Session::solver_;
Element Session::elements_[kRoom];
std::uint16_t Session::patch_elements_[kRoom], Session::roots_[kRoom];
Sight Session::sights_[kRoom];
std::uint32_t Session::errors_[kRoom];
Patch Session::patches_[kRoom];
Cut Session::cuts_[kRoom];
std::uint16_t Session::share_[kMatrixElements * kMatrixElements], Session::back_[kMatrixElements];
std::int32_t Session::exitent_[kMatrixElements * kMaxChannels];

}  // namespace
}  // namespace fixrad::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  FuzzedDataProvider in(data, size);
  fixrad::fuzz::Session(in).run();
  return 0;
}
