// SPDX-License-Identifier: MIT
#include "tests/stability/properties.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <type_traits>

#include "host_sim/reference/counter_random.h"
#include "host_sim/simulate/convergence.h"
#include "tests/lib/solution.h"
#include "tests/stability/bench.h"
#include "tests/stability/symmetries.h"

namespace fixrad::host {
namespace {

// Where faces run through each other or lie in one plane, their order decides ties of depth: parts of 2^20.
constexpr std::uint32_t kOrderOfFaces = 1u << 10;

// Of the sum of exchange areas.
constexpr double kReciprocity = 0.06;

std::string refusal(const Bench& bench) {
  return std::string("the core refuses the scene: ") + describe(bench.status());
}

std::string unsolved(const Bench& bench) {
  return std::string("no end: ") + describe(bench.status());
}

// The ledger's books, channel by channel.
class Books {
 public:
  explicit Books(const State& state) : state_(state) {}

  std::string audit() {
    for (std::uint8_t c = 0; c < state_.scene.channels; ++c) {
      const Ledger sum = ledger(state_, c);
      if (sum.imbalance() != 0) {
        return at(c, "the ledger is " + std::to_string(sum.imbalance()) + " units off");
      }
      const std::uint64_t unshot = sum_unshot(state_, c).magnitude;
      if (!state_.settings.overshoot && unshot > unshot_[c]) {
        return at(c, "unshot flux grew to " + std::to_string(unshot));
      }
      unshot_[c] = unshot;
    }
    return {};
  }

 private:
  std::string at(int c, const std::string& what) const {
    return "shot " + std::to_string(state_.shots) + " channel " + std::to_string(c) + ": " + what;
  }

  const State& state_;
  std::uint64_t unshot_[kMaxChannels] = {~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}};
};

std::string leak(const State& state) {
  if (!state.is_closed) {
    return "the room is not closed on the grid";
  }
  for (int c = 0; c < state.scene.channels; ++c) {
    if (state.escaped[c] != 0 || state.back[c] != 0) {
      return "channel " + std::to_string(c) + ": escaped " + std::to_string(state.escaped[c]) + ", back " +
             std::to_string(state.back[c]);
    }
  }
  return {};
}

std::string keep_books(const RandomScene& scene) {
  Bench bench(model_of(scene), scene, settings_of(scene));
  if (bench.status() != Status::ok) {
    return refusal(bench);
  }
  State& state = bench.state();
  Books books(state);
  Status status = Status::ok;
  while (status == Status::ok && state.shots < Bench::kMostShots) {
    const std::string fault = books.audit();
    if (!fault.empty()) {
      return fault;
    }
    status = shoot(state);
  }
  if (status != Status::converged) {
    return std::string("no end: ") + describe(status);
  }
  return scene.is_closed ? leak(state) : std::string();
}

// Solved in one go, and with everything read that can be read between two shots.
std::string read_on_the_way(const RandomScene& scene) {
  Bench whole(model_of(scene), scene, settings_of(scene)), sliced(model_of(scene), scene, settings_of(scene));
  if (whole.status() != Status::ok) {
    return refusal(whole);
  }
  Status status = Status::ok;
  while (status == Status::ok && sliced.state().shots < Bench::kMostShots) {
    unshot_fraction(sliced.state());
    for (int c = 0; c < sliced.state().scene.channels; ++c) {
      ledger(sliced.state(), c);
      element_radiosity(sliced.state(), 0, c, ambient_radiosity(sliced.state(), c));
    }
    status = shoot(sliced.state());
  }
  if (!whole.run()) {
    return unsolved(whole);
  }
  return whole.received() == sliced.received() && whole.state().shots == sliced.state().shots
             ? std::string()
             : "another flux in slices than in one go";
}

// An eye sees the same whenever it looks.
template <Engine Hemisphere>
Status look_without_a_turn(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                           Workspace& work, FormFactorRow& row) {
  EyeSample still = sample;
  still.eye.turn = 0;
  return Hemisphere(scene, table, still, work, row);
}

// One matrix of form factors, whatever the flux: elements shoot for themselves, with the finest table.
Settings one_matrix(const RandomScene& scene) {
  Settings settings = settings_of(scene);
  settings.engine = scene.hemisphere == RandomScene::Hemisphere::lunes ? look_without_a_turn<lune_rows>
                    : scene.hemisphere == RandomScene::Hemisphere::hemicube
                        ? look_without_a_turn<hemicube_rows>
                        : look_without_a_turn<hemicube_pixels>;
  settings.tables += settings.table_count - 1;
  settings.table_count = 1;
  settings.flux_per_row = Fraction::from_raw(0);
  settings.flux_per_eye = Fraction::from_raw(0xffffffffu);
  settings.overshoot = false;
  return settings;
}

// How far rounding may take all that is received: what is unshot, and a unit an element and shot, each
// multiplied by 1 / (1 - reflectance) as it bounces on.
double rounding(const State& state, std::size_t c) {
  const ErrorBound bound = error_bounds(state)[c];
  return (bound.unshot + static_cast<double>(state.scene.element_count) * (state.shots + 1.0)) /
         (1 - bound.largest_reflectance);
}

std::string scale_light(const RandomScene& scene) {
  const Settings settings = one_matrix(scene);
  Bench whole(model_of(scene), scene, settings), part(model_of(scene), scene, settings);
  if (whole.status() != Status::ok) {
    return refusal(whole);
  }
  constexpr std::uint32_t kDivisor = 3;
  DeviceScene dim = part.device();
  for (fixrad::Material& material : dim.materials) {
    for (std::uint32_t& emission : material.emission) {
      emission /= kDivisor;
    }
  }
  if (part.load(dim, settings) != Status::ok || !whole.run() || !part.run()) {
    return unsolved(part.status() == Status::converged ? whole : part);
  }
  if (whole.state().sweep.kind != SourceKind::element || part.state().sweep.kind != SourceKind::element) {
    return {};  // groups shot: another matrix
  }
  const std::vector<std::int32_t> all = whole.received(), third = part.received();
  const auto channels = static_cast<std::size_t>(whole.device().channels);
  for (std::size_t c = 0; c < channels; ++c) {
    double distance = 0;
    for (std::size_t i = c; i < all.size(); i += channels) {
      distance += std::abs(static_cast<double>(all[i]) - kDivisor * static_cast<double>(third[i]));
    }
    const double bound = rounding(whole.state(), c) + kDivisor * rounding(part.state(), c);
    if (distance > bound) {
      return "channel " + std::to_string(c) + ": a third of the emission gives " + std::to_string(distance) +
             " units else, more than " + std::to_string(bound);
    }
  }
  return {};
}

std::string same_flux(const RandomScene& scene, Model image, const char* what) {
  Bench a(model_of(scene), scene, settings_of(scene)), b(std::move(image), scene, settings_of(scene));
  if (a.status() != Status::ok) {
    return refusal(a);
  }
  if (!a.run() || !b.run()) {
    return unsolved(a);
  }
  return a.received() == b.received() ? std::string() : std::string("another flux with ") + what;
}

// A fixed shuffle of 0 .. n - 1.
std::vector<std::uint32_t> shuffled(std::size_t n, std::uint64_t seed) {
  std::vector<std::uint32_t> order(n);
  CounterRandom random(seed, 1, n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto j = static_cast<std::size_t>(random.next() * static_cast<double>(i + 1));
    order[i] = order[j];
    order[j] = static_cast<std::uint32_t>(i);
  }
  return order;
}

std::string shuffle_vertices(const RandomScene& scene) {
  const Model model = model_of(scene);
  Model image = model;
  const std::vector<std::uint32_t> places = shuffled(model.positions.size(), scene.seed);
  const std::vector<std::uint32_t> paints = shuffled(model.materials.size(), scene.seed);
  for (std::size_t v = 0; v < places.size(); ++v) {
    image.positions[places[v]] = model.positions[v];
  }
  for (std::size_t m = 0; m < paints.size(); ++m) {
    image.materials[paints[m]] = model.materials[m];
  }
  for (Face& face : image.faces) {
    face.material = paints[face.material];
    for (std::uint32_t& v : face.corners) {
      v = places[v];
    }
  }
  return same_flux(scene, std::move(image), "vertices and materials in another order");
}

// A scene's tables as a rotation of the grid makes them.
DeviceScene rotated(DeviceScene device, std::size_t rotation) {
  const auto turn = [&](auto& v, int extent) {
    const glm::ivec3 image = image_of(glm::ivec3(v[0], v[1], v[2]), rotation, extent);
    for (int k = 0; k < 3; ++k) {
      v[k] = static_cast<std::remove_reference_t<decltype(v[0])>>(image[k]);
    }
  };
  for (Vertex& vertex : device.vertices) {
    std::int16_t v[3] = {vertex.x, vertex.y, vertex.z};
    turn(v, kGridMax);
    vertex = {v[0], v[1], v[2]};
  }
  for (fixrad::Face& face : device.faces) {
    turn(face.normal, 0);
    turn(face.tangent, 0);
    turn(face.axis_u, 0);
    turn(face.axis_v, 0);
    turn(face.origin, kGridMax);
  }
  for (Element& element : device.elements) {
    turn(element.eye, kEyeScale * kGridMax);
  }
  return device;
}

// x, y, z to y, z, x and back, no sign changed.
constexpr std::size_t kCyclic[] = {8, 16};

std::string turn_axes(const RandomScene& scene) {
  Bench a(model_of(scene), scene, settings_of(scene)), b(model_of(scene), scene, settings_of(scene));
  if (a.status() != Status::ok) {
    return refusal(a);
  }
  const std::size_t rotation = kCyclic[scene.seed % 2];
  const DeviceScene image = rotated(b.device(), rotation);
  if (b.load(image, settings_of(scene)) != Status::ok) {
    return refusal(b);
  }
  if (!a.run() || !b.run()) {
    return unsolved(a);
  }
  return a.received() == b.received() ? std::string()
                                      : "another flux after rotation " + std::to_string(rotation);
}

// The row of form factors from the eye of element `e`, in share; by the finest table.
const std::uint32_t* look(Bench& bench, std::uint16_t e) {
  State& state = bench.state();
  clear(state.row);
  const EyeSample sample = {element_eye(state.scene, e), kRowOne, !state.is_closed, true};
  const DeltaTable& finest = state.settings.tables[state.settings.table_count - 1];
  return state.settings.engine(state.scene, finest, sample, state.work, state.row) == Status::ok
             ? state.row.share
             : nullptr;
}

bool is_clear(Bench& bench, std::uint16_t e) {
  State& state = bench.state();
  std::uint32_t share = 0;
  const Status status = hidden_share(state.scene, state.settings.probe[0], element_eye(state.scene, e),
                                     state.is_enclosed, state.work, share);
  return status == Status::ok && share <= kBuriedShare;
}

// Where each element of `a` is in `b`, by its eye and its face's normal; empty if some is not.
std::vector<std::uint16_t> places_in(const DeviceScene& a, const DeviceScene& b) {
  using Key = std::array<int, 6>;
  const auto key = [](const DeviceScene& device, const Element& e) {
    const auto& n = device.faces[e.face].normal;
    return Key{e.eye[0], e.eye[1], e.eye[2], n[0], n[1], n[2]};
  };
  std::map<Key, std::uint16_t> places;
  for (std::size_t e = 0; e < b.elements.size(); ++e) {
    places[key(b, b.elements[e])] = static_cast<std::uint16_t>(e);
  }
  std::vector<std::uint16_t> order;
  for (const Element& e : a.elements) {
    const auto found = places.find(key(a, e));
    if (found == places.end() || places.size() != a.elements.size()) {
      return {};
    }
    order.push_back(found->second);
  }
  return order;
}

// The plane of an element, and which side of it is lit.
std::array<std::int64_t, 4> plane_of(const DeviceScene& device, std::size_t e) {
  const fixrad::Face& face = device.faces[device.elements[e].face];
  const Vertex corner = device.vertices[device.corners[face.first_corner]];
  const std::int64_t height = face.normal[0] * std::int64_t{corner.x} +
                              face.normal[1] * std::int64_t{corner.y} +
                              face.normal[2] * std::int64_t{corner.z};
  return {face.normal[0], face.normal[1], face.normal[2], height / kUnit};
}

std::string shuffle_faces(const RandomScene& scene) {
  const Model model = model_of(scene);
  Model image = model;
  const std::vector<std::uint32_t> places = shuffled(model.faces.size(), scene.seed);
  for (std::size_t f = 0; f < places.size(); ++f) {
    image.faces[places[f]] = model.faces[f];
  }
  Bench a(model, scene, settings_of(scene)), b(image, scene, settings_of(scene));
  if (a.status() != Status::ok || b.status() != Status::ok) {
    return refusal(a.status() != Status::ok ? a : b);
  }
  const std::vector<std::uint16_t> order = places_in(a.device(), b.device());
  for (std::uint16_t e = 0; e < order.size(); ++e) {
    if (!is_clear(a, e)) {
      continue;  // inside a body, where a wall and what stands on it have one depth
    }
    const std::uint32_t *from = look(a, e), *to = look(b, order[e]);
    if (from == nullptr || to == nullptr) {
      return "a row is not sampled";
    }
    std::map<std::array<std::int64_t, 4>, std::int64_t> difference;  // by plane
    for (std::size_t j = 0; j < order.size(); ++j) {
      difference[plane_of(a.device(), j)] += static_cast<std::int64_t>(from[j]) - to[order[j]];
    }
    std::int64_t distance = 0;
    for (const auto& [plane, moved] : difference) {
      distance += std::abs(moved);
    }
    if (distance > kOrderOfFaces * (scene.bodies.empty() ? 0 : 1)) {
      return "element " + std::to_string(e) + " sees " + std::to_string(distance) +
             " of 2^20 elsewhere with the faces in another order";
    }
  }
  return {};
}

// The finest of lunes, on a mesh that is fine for so few faces.
constexpr std::uint32_t kFineElements = 300;
constexpr int kFineRows = 128;

// Exchange areas between faces, [face][face], from one row an element.
std::vector<double> exchange_areas(Bench& bench) {
  const DeviceScene& device = bench.device();
  const std::size_t faces = device.faces.size();
  std::vector<double> areas(faces * faces, 0.0);
  for (std::uint16_t e = 0; e < device.elements.size(); ++e) {
    const std::uint32_t* row = is_clear(bench, e) ? look(bench, e) : nullptr;
    for (std::size_t j = 0; row != nullptr && j < device.elements.size(); ++j) {
      areas[device.elements[e].face * faces + device.elements[j].face] +=
          static_cast<double>(device.elements[e].area) * row[j] / kRowOne;
    }
  }
  return areas;
}

std::string reciprocate(const RandomScene& scene) {
  RandomScene fine = scene;
  fine.elements = kFineElements;
  fine.rows = kFineRows;
  fine.hemisphere = RandomScene::Hemisphere::lunes;
  Bench bench(model_of(fine), fine, settings_of(fine));
  if (bench.status() != Status::ok) {
    return refusal(bench);
  }
  const std::vector<double> areas = exchange_areas(bench);
  const std::size_t faces = bench.device().faces.size();
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    for (std::size_t j = 0; j < faces; ++j) {
      difference += std::abs(areas[i * faces + j] - areas[j * faces + i]) / 2;
      sum += areas[i * faces + j];
    }
  }
  return difference <= kReciprocity * sum ? std::string()
                                          : "exchange areas of faces differ by " +
                                                std::to_string(difference / sum) + " from their transpose";
}

}  // namespace

const std::vector<Property>& properties() {
  static const std::vector<Property> all = {
      {"KeepsItsBooks",
       "Exact: the ledger balances after every shot; unshot flux never grows without overshooting; shooting "
       "ends; in a closed room nothing escapes or meets a back.",
       keep_books},
      // Where shooting can stop in the middle of a shot and go on later, it is to be cut into slices here.
      {"SlicesChangeNothing", "Exact: reading a solution between two shots leaves its bits alone.",
       read_on_the_way},
      {"EmissionScalesLight",
       "With one matrix of form factors light is linear in emission, to within what is unshot and a unit an "
       "element and shot, each over 1 - the largest reflectance.",
       scale_light},
      {"OrderOfVerticesAndMaterialsDoesNotMatter",
       "Exact: the order of shots follows the faces; vertices and materials are only referred to.",
       shuffle_vertices},
      {"CyclicAxesGiveTheSameBits",
       "Exact, for tables turned by a third of a turn about a diagonal of the grid: the core adds three "
       "products "
       "for every component of a vector in its eye's frame, whichever comes first. (Other rotations change "
       "signs, "
       "and a product that lies halfway between two numbers is rounded up whatever its sign.)",
       turn_axes},
      {"OrderOfFacesLeavesRowsAlone",
       "What an eye sees does not depend on who is drawn first: exact without bodies; with them rounded "
       "depths may "
       "tie where they touch or run through each other, for 2^-10 of a view at most.",
       shuffle_faces},
      {"ExchangeIsReciprocal",
       "A_i F_ij = A_j F_ji: exchange areas between faces, by one view of 128 lunes from the middle of each "
       "of 300 "
       "elements, are within 6 % of their transpose in sum. The bound is measured, three times the error of "
       "all but "
       "one scene in a hundred: elements that lie half under a body have one eye.",
       reciprocate},
  };
  return all;
}

}  // namespace fixrad::host
