#include "reference/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "input/input_error.h"
#include "reference/disc_samples.h"

namespace penumbra::reference {
namespace {

constexpr unsigned kSolid = 0;  // geometries
constexpr unsigned kCutOut = 1;

template <typename Element>
void fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<Element>& elements, std::size_t per_item) {
  auto* buffer = static_cast<Element*>(rtcSetNewGeometryBuffer(
      geometry, type, 0, format, per_item * sizeof(Element), elements.size() / per_item));
  if (buffer == nullptr) throw EnvironmentError("Embree ran out of memory for the scene");
  std::copy(elements.begin(), elements.end(), buffer);
}

void check_indices(const scene::Mesh& mesh) {
  const bool inside = std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                  [&](std::uint32_t index) { return index < mesh.positions.size(); });
  if (!inside || mesh.indices.size() % 3 != 0) {
    throw InputError("", "the mesh's triangles name vertices it does not have");
  }
}

// Returns a uniform number in [0, 1) that the ray and the triangle determine.
float chance(const RTCFilterFunctionNArguments& asked, unsigned lane, std::size_t triangle) {
  const unsigned n = asked.N;
  std::uint64_t bits = mixed_bits(triangle) ^ RTCRayN_id(asked.ray, n, lane);
  for (const float number : {RTCRayN_org_x(asked.ray, n, lane), RTCRayN_org_y(asked.ray, n, lane),
                             RTCRayN_org_z(asked.ray, n, lane), RTCRayN_dir_x(asked.ray, n, lane),
                             RTCRayN_dir_y(asked.ray, n, lane), RTCRayN_dir_z(asked.ray, n, lane)})
    bits = mixed_bits(bits ^ std::bit_cast<std::uint32_t>(number));
  return std::ldexp(static_cast<float>(bits >> 40), -24);
}

// Rejects hits where the surface is open, and hits of blended triangles by chance.
void pass_openings(const RTCFilterFunctionNArguments* asked) {
  const auto& scene = *static_cast<const EmbreeScene*>(asked->geometryUserPtr);
  for (unsigned lane = 0; lane < asked->N; ++lane) {
    if (asked->valid[lane] == 0) continue;
    const std::size_t triangle = scene.triangle(kCutOut, RTCHitN_primID(asked->hit, asked->N, lane));
    const float u = RTCHitN_u(asked->hit, asked->N, lane), v = RTCHitN_v(asked->hit, asked->N, lane);
    const float opacity = scene.cut_outs().opacity(triangle, u, v);
    if (opacity < 1.0F && chance(*asked, lane, triangle) >= opacity) asked->valid[lane] = 0;
  }
}

}  // namespace

EmbreeScene::EmbreeScene(const scene::Scene& scene)
    : cut_outs_(scene), device_(nullptr, rtcReleaseDevice), scene_(nullptr, rtcReleaseScene) {
  const scene::Mesh& mesh = scene.mesh;
  check_indices(mesh);
  device_.reset(rtcNewDevice(nullptr));
  if (!device_) throw EnvironmentError("Embree cannot start on this machine");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(handle(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(handle(), RTC_BUILD_QUALITY_HIGH);
  if (cut_outs_.any()) {
    attach_apart(mesh);
  } else if (!mesh.indices.empty()) {
    attach(mesh, mesh.indices, kSolid);
  }
  rtcCommitScene(handle());
  if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE) {
    throw EnvironmentError("Embree could not build the scene, error " + std::to_string(error));
  }
}

std::optional<float> EmbreeScene::first_hit(const glm::vec3& from, const glm::vec3& direction,
                                            float farthest) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray.org_x = from.x;
  ray.ray.org_y = from.y;
  ray.ray.org_z = from.z;
  ray.ray.dir_x = direction.x;
  ray.ray.dir_y = direction.y;
  ray.ray.dir_z = direction.z;
  ray.ray.tfar = farthest;
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(handle(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return ray.ray.tfar;
}

void EmbreeScene::attach(const scene::Mesh& mesh, const std::vector<std::uint32_t>& indices,
                         unsigned geometry_id) {
  const std::unique_ptr<RTCGeometryTy, void (*)(RTCGeometry)> geometry(
      rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE), rtcReleaseGeometry);
  fill_buffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions, 1);
  fill_buffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices, 3);
  if (geometry_id == kCutOut) {
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryIntersectFilterFunction(geometry.get(), pass_openings);
    rtcSetGeometryOccludedFilterFunction(geometry.get(), pass_openings);
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(handle(), geometry.get(), geometry_id);
}

void EmbreeScene::attach_apart(const scene::Mesh& mesh) {
  if (rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_FILTER_FUNCTION_SUPPORTED) == 0) {
    throw EnvironmentError("this Embree was built without filter functions, which cut-outs need");
  }
  std::vector<std::uint32_t> indices[2];
  triangles_.resize(2);
  for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
    const unsigned geometry = cut_outs_.cuts(triangle) ? kCutOut : kSolid;
    const auto corner = mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
    indices[geometry].insert(indices[geometry].end(), corner, corner + 3);
    triangles_[geometry].push_back(static_cast<std::uint32_t>(triangle));
  }
  for (const unsigned geometry : {kSolid, kCutOut}) {
    if (!indices[geometry].empty()) attach(mesh, indices[geometry], geometry);
  }
}

}  // namespace penumbra::reference
