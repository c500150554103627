#include "reference/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "input/input_error.h"

namespace penumbra::reference {
namespace {

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

}  // namespace

EmbreeScene::EmbreeScene(const scene::Mesh& mesh) {
  check_indices(mesh);
  device_ = rtcNewDevice(nullptr);
  if (device_ == nullptr) throw EnvironmentError("Embree cannot start on this machine");
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  if (!mesh.indices.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    fill_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions, 1);
    fill_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices, 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_);
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
    throw EnvironmentError("Embree could not build the scene, error " + std::to_string(error));
  }
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

}  // namespace penumbra::reference
