// SPDX-License-Identifier: MIT
#include "host_sim/sweep/work.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "lib/form_factor/scanline.h"
#include "lib/form_factor/spans.h"
#include "lib/form_factor/split.h"

namespace fixrad::host {
namespace {

enum class Cut { lunes, hemicube, pixels };

std::optional<Cut> cut_of(const std::string& engine) {
  return engine == "lunes"    ? std::optional(Cut::lunes)
         : engine == "rows"   ? std::optional(Cut::hemicube)
         : engine == "pixels" ? std::optional(Cut::pixels)
                              : std::nullopt;
}

void add(Work& sum, const Work& part) {
  for (unsigned i = 0; i < kWorkUnits; ++i) {
    sum[i] += part[i];
  }
}

// One eye at a time, in a workspace of its own.
class EyeCounter {
 public:
  EyeCounter(const Scene& scene, const Sizes& sizes, Cut cut) : device_(sizes), cut_(cut) {
    [[maybe_unused]] const Status status = device_.load(scene, Settings{});
  }

  void count(const WorkRecorder::Eye& eye) {
    Workspace& work = device_.state().work;
    const Scene& scene = device_.state().scene;
    make_view(scene, eye.sample.eye, backs_in(eye.sample), work);
    make_grids(scene, eye.sample.eye, work);
    sum_[kEye] += 1;
    sum_[kVertex] += scene.vertex_count;
    sum_[kFace] += scene.face_count;
    sum_[kView] += work.view_count;
    const int size = 1 << eye.table.resolution_log2;
    const int sides = cut_ == Cut::lunes ? 1 : kSides;
    for (int side = 0; side < sides; ++side) {
      if (side != kTop) {
        turn_view(side, scene.vertex_count, work);
        sum_[kVertex] += scene.vertex_count;
      }
      for (int first = side == kTop ? 0 : size / 2; first < size; first += kBandRows) {
        count_band(eye, side, first);
      }
    }
  }

  const Work& sum() const { return sum_; }

 private:
  void count_band(const WorkRecorder::Eye& eye, int side, int first) {
    const DeltaTable& table = eye.table;
    const int count = band_count(table, first);
    Workspace& work = device_.state().work;
    const Scene& scene = device_.state().scene;
    if (cut_ == Cut::lunes) {
      enter_band(scene, table, first, count, work);
    } else {
      enter_side_band(scene, table, side, first, count, work);
    }
    sum_[kBandVertex] += scene.vertex_count;
    sum_[kBandFace] += work.view_count;
    VisibleSpans visible(scene, eye.sample.eye, work);
    for (int i = 0; i < count; ++i) {
      const BandRow row = {row_plane(table, first + i), static_cast<RowMask>(1u << i)};
      sum_[kRow] += 1;
      if (cut_ == Cut::pixels) {
        sum_[kPixel] += std::uint64_t{1} << table.resolution_log2;
        count_pixel_row(row, table.resolution_log2);
      } else {
        count_row(row, visible);
      }
    }
  }

  template <typename Use>
  void for_each_interval(const BandRow& row, const Use& use) {
    const State& state = device_.state();
    for (std::uint16_t i = 0; i < state.work.view_count; ++i) {
      FaceView& view = state.work.views[i];
      if ((view.rows & row.bit) != 0) {
        sum_[kInterval] += 1;
        const Interval part = face_interval(state.scene, row, state.work.directions, view);
        if (part.begin < part.end) {
          use(i, part);
        }
      }
    }
  }

  void count_pieces(std::uint16_t view, const RowPlane& plane, Interval part) {
    const State& state = device_.state();
    for (ElementWalk walk(state.scene, state.work.views[view], plane, part); walk.next();) {
      sum_[kPiece] += 1;
    }
  }

  void count_row(const BandRow& row, VisibleSpans& visible) {
    const Workspace& work = device_.state().work;
    visible.reset();
    for_each_interval(row, [&](std::uint16_t view, Interval part) {
      sum_[kMet] += visible.count();
      [[maybe_unused]] const bool fits = visible.insert(view, part, row.plane);
    });
    sum_[kSpan] += visible.count();
    for (std::uint16_t i = 0; i < visible.count(); ++i) {
      if (visible.view(i) != kNothing && !work.views[visible.view(i)].is_back) {
        count_pieces(visible.view(i), row.plane, visible.part(i));
      }
    }
  }

  void count_pixel_row(const BandRow& row, int resolution_log2) {
    const State& state = device_.state();
    for_each_interval(row, [&](std::uint16_t view, Interval part) {
      // As in the engine, a pixel is covered where its centre is.
      const int bits = kRowLog2 - resolution_log2;
      const auto first_from = [bits](std::int32_t x) { return (x + (1 << (bits - 1)) - 1) >> bits; };
      sum_[kPixelTest] += static_cast<std::uint64_t>(first_from(part.end) - first_from(part.begin));
      if (!state.work.views[view].is_back) {
        count_pieces(view, row.plane, part);
      }
    });
  }

  SimulatedDevice device_;
  Cut cut_;
  Work sum_ = {};
};

}  // namespace

const std::array<const char*, kWorkUnits> kWorkNames = {
    "eye",  "vertex", "face",       "view",  "band_vertex", "band_face",  "row",     "interval", "span_met",
    "span", "piece",  "pixel_test", "pixel", "share",       "face_share", "element", "unshot"};

Observer WorkRecorder::observer() {
  Observer observer = {};
  observer.context = this;
  observer.on_eye = [](void* self, const DeltaTable& table, const EyeSample& sample) {
    static_cast<WorkRecorder*>(self)->eyes_.push_back({sample, table});
  };
  observer.on_shot = [](void* self, const Shot& shot) { static_cast<WorkRecorder*>(self)->take_shot(shot); };
  return observer;
}

void WorkRecorder::take_shot(const Shot& shot) {
  const FormFactorRow& row = state_->row;
  const auto reached = static_cast<std::uint64_t>(
      std::count_if(row.share, row.share + row.count, [](std::uint32_t share) { return share != 0; }));
  const std::uint64_t channels = state_->scene.channels;
  transport_[shot.source.kind == SourceKind::face ? kFaceShare : kShare] += reached * channels;
  transport_[kElement] += row.count;
  if (!shot.is_emission) {
    transport_[kUnshot] += unshot_fluxes(shot) * channels;
  }
}

// A pass surveys all sources and then asks one after the other, in order, whether it has enough: where their
// order starts again, a pass has begun. A shot plans its amount and books it; a patch's eyes need the flux of
// each element twice more.
std::uint64_t WorkRecorder::unshot_fluxes(const Shot& shot) {
  const EyeSource& source = shot.source;
  const bool starts_pass = !last_ || last_->kind != source.kind || source.first <= last_->first;
  last_ = source;
  const std::uint64_t sources =
      source.kind == SourceKind::face ? state_->scene.face_count : state_->scene.element_count;
  const std::uint64_t of_shot = source.kind == SourceKind::element ? 3
                                : source.kind == SourceKind::patch ? std::uint64_t{5} * source.count
                                                                   : 1;
  return (starts_pass ? 2 * sources : 0) + of_shot;
}

std::optional<Work> count_work(const BakeResult& result, const BakeOptions& options,
                               const WorkRecorder& recorder) {
  const std::optional<Cut> cut = cut_of(options.engine);
  if (!cut || options.solver != "shooting") {
    return std::nullopt;
  }
  const std::vector<WorkRecorder::Eye>& eyes = recorder.eyes();
  const Scene scene = result.device.view();
  Work work = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, eyes.size(), 256), Work{},
      [&](const tbb::blocked_range<std::size_t>& range, Work sum) {
        EyeCounter counter(scene, result.plan.sizes, *cut);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          counter.count(eyes[i]);
        }
        add(sum, counter.sum());
        return sum;
      },
      [](Work a, const Work& b) {
        add(a, b);
        return a;
      });
  add(work, recorder.transport());
  return work;
}

}  // namespace fixrad::host
