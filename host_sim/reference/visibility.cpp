// SPDX-License-Identifier: MIT
#include "host_sim/reference/visibility.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>

namespace fixrad::host {
namespace {

/// Both ends of a segment are shortened by this part of its length.
constexpr float kSegmentMargin = 1e-5F;

/// Triangles that lie closer together than this, over half the scene's size, lie in one plane.
constexpr double kOnePlane = 4.0 * RayScene::kLift;

/// Cosine between a ray and the normal of what it met, -1 to 1: negative on the front.
double hit_cosine(const RTCRayHit& query) {
  const glm::dvec3 normal{query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z};
  const glm::dvec3 direction{query.ray.dir_x, query.ray.dir_y, query.ray.dir_z};
  return glm::dot(glm::normalize(normal), glm::normalize(direction));
}

/// Embree's callback for single rays: lets a ray pass through triangles that turn their back.
void pass_back_faces(const RTCFilterFunctionNArguments* arguments) {
  RTCRayHit query;
  query.ray = rtcGetRayFromRayN(arguments->ray, arguments->N, 0);
  query.hit = rtcGetHitFromHitN(arguments->hit, arguments->N, 0);
  if (hit_cosine(query) >= 0.0) {
    arguments->valid[0] = 0;
  }
}

bool is_hit(const RTCRayHit& query) {
  return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

void set_ray(RTCRay& ray, const glm::dvec3& origin, const glm::dvec3& direction, float tnear, float tfar) {
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = tnear;
  ray.tfar = tfar;
  ray.time = 0.0F;
  ray.mask = std::numeric_limits<unsigned>::max();
  ray.id = 0;
  ray.flags = 0;
}

/// One segment of a packet.
template <class Rays>
void set_ray(Rays& rays, std::size_t k, const glm::dvec3& origin, const glm::dvec3& direction) {
  rays.org_x[k] = static_cast<float>(origin.x);
  rays.org_y[k] = static_cast<float>(origin.y);
  rays.org_z[k] = static_cast<float>(origin.z);
  rays.dir_x[k] = static_cast<float>(direction.x);
  rays.dir_y[k] = static_cast<float>(direction.y);
  rays.dir_z[k] = static_cast<float>(direction.z);
  rays.tnear[k] = kSegmentMargin;
  rays.tfar[k] = 1.0F - kSegmentMargin;
  rays.time[k] = 0.0F;
  rays.mask[k] = std::numeric_limits<unsigned>::max();
  rays.id[k] = 0;
  rays.flags[k] = 0;
}

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  glm::dvec3 centre{0.0};
  double half_size = 1.0;
  double per_half_size = 1.0;

  ~Impl() {
    if (scene != nullptr) {
      rtcReleaseScene(scene);
    }
    if (device != nullptr) {
      rtcReleaseDevice(device);
    }
  }

  glm::dvec3 to_unit(const glm::dvec3& position) const { return (position - centre) * per_half_size; }

  void fit(const std::vector<glm::dvec3>& positions) {
    if (positions.empty()) {
      return;
    }
    glm::dvec3 low = positions[0];
    glm::dvec3 high = positions[0];
    for (const glm::dvec3& position : positions) {
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    centre = 0.5 * (low + high);
    const glm::dvec3 half = 0.5 * (high - low);
    half_size = std::max({half.x, half.y, half.z});
    if (!(half_size > 0.0)) {
      half_size = 1.0;
    }
    per_half_size = 1.0 / half_size;
  }

  RTCRayHit intersect(const glm::dvec3& from, const glm::dvec3& direction, RTCFilterFunctionN filter) const {
    RTCRayHit query;
    set_ray(query.ray, from, direction, 0.0F, std::numeric_limits<float>::infinity());
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.filter = filter;
    rtcIntersect1(scene, &context, &query);
    return query;
  }

  /// Segments between surface points.
  struct Packet {
    const glm::dvec3* p;
    const glm::dvec3& p_normal;
    const glm::dvec3* q;
    const glm::dvec3& q_normal;
    std::size_t count;
  };

  /// Bit k is set where segment k is free.
  template <class Rays, std::size_t Width, class Query>
  std::uint32_t occluded(const Packet& packet, Query query) const {
    Rays rays;
    alignas(32) std::array<int, Width> valid{};
    const glm::dvec3 p_lift = kLift * packet.p_normal;
    const glm::dvec3 q_lift = kLift * packet.q_normal;
    for (std::size_t k = 0; k < packet.count; ++k) {
      const glm::dvec3 from = to_unit(packet.p[k]) + p_lift;
      set_ray(rays, k, from, to_unit(packet.q[k]) + q_lift - from);
      valid[k] = -1;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    query(valid.data(), scene, &context, &rays);
    std::uint32_t open = 0;
    for (std::size_t k = 0; k < packet.count; ++k) {
      open |= rays.tfar[k] >= 0.0F ? 1U << k : 0U;
    }
    return open;
  }

  void attach(const std::vector<glm::dvec3>& positions, const std::vector<std::uint32_t>& triangles) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size() / 3));
    if (vertices == nullptr || indices == nullptr) {
      rtcReleaseGeometry(geometry);
      throw std::runtime_error("no memory for the triangles of the visibility test");
    }
    for (const glm::dvec3& position : positions) {
      const glm::dvec3 unit = to_unit(position);
      *vertices++ = static_cast<float>(unit.x);
      *vertices++ = static_cast<float>(unit.y);
      *vertices++ = static_cast<float>(unit.z);
    }
    std::copy(triangles.begin(), triangles.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

RayScene::RayScene(const std::vector<glm::dvec3>& positions, const std::vector<std::uint32_t>& triangles)
    : impl_(std::make_unique<Impl>()) {
  if (triangles.size() % 3 != 0 || std::any_of(triangles.begin(), triangles.end(),
                                               [&](std::uint32_t i) { return i >= positions.size(); })) {
    throw std::runtime_error("the triangles of the visibility test refer to positions that do not exist");
  }
  impl_->device = rtcNewDevice(nullptr);
  if (impl_->device == nullptr) {
    throw std::runtime_error("Embree cannot start: error " + std::to_string(rtcGetDeviceError(nullptr)));
  }
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  impl_->fit(positions);
  if (!triangles.empty()) {
    impl_->attach(positions, triangles);
  }
  rtcCommitScene(impl_->scene);
  const RTCError error = rtcGetDeviceError(impl_->device);
  if (error != RTC_ERROR_NONE) {
    throw std::runtime_error("Embree cannot take the scene: error " + std::to_string(error));
  }
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

bool RayScene::visible(const glm::dvec3& p, const glm::dvec3& p_normal, const glm::dvec3& q,
                       const glm::dvec3& q_normal) const {
  const glm::dvec3 from = impl_->to_unit(p) + kLift * p_normal;
  const glm::dvec3 to = impl_->to_unit(q) + kLift * q_normal;
  RTCRay ray;
  set_ray(ray, from, to - from, kSegmentMargin, 1.0F - kSegmentMargin);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar >= 0.0F;  // Embree sets it to minus infinity when something is in the way
}

std::uint32_t RayScene::visible_packet(const glm::dvec3* p, const glm::dvec3& p_normal, const glm::dvec3* q,
                                       const glm::dvec3& q_normal, std::size_t count) const {
  const Impl::Packet packet = {p, p_normal, q, q_normal, count};
  return count <= 4 ? impl_->occluded<RTCRay4, 4>(packet, rtcOccluded4)
                    : impl_->occluded<RTCRay8, kPacket>(packet, rtcOccluded8);
}

std::optional<RayHit> RayScene::nearest(const glm::dvec3& origin, const glm::dvec3& normal,
                                        const glm::dvec3& direction) const {
  const glm::dvec3 from = impl_->to_unit(origin) + kLift * normal;
  RTCRayHit first = impl_->intersect(from, direction, nullptr);
  if (!is_hit(first)) {
    return std::nullopt;
  }
  if (hit_cosine(first) >= 0.0) {
    const RTCRayHit front = impl_->intersect(from, direction, pass_back_faces);
    const double gap = static_cast<double>(front.ray.tfar) - static_cast<double>(first.ray.tfar);
    if (is_hit(front) && gap * hit_cosine(first) <= kOnePlane) {
      first = front;
    }
  }
  return RayHit{first.hit.primID, static_cast<double>(first.ray.tfar) * impl_->half_size,
                hit_cosine(first) < 0.0};
}

}  // namespace fixrad::host
