#include "gpu/device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

std::string refusal(const DeviceOptions& options) {
  try {
    const Device device(options);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "no EnvironmentError";
}

TEST(DeviceChoice, TakesTheSoftwareDeviceWhenNothingIsSaidAndThereIsOne) {
  const std::vector<DeviceInfo> all = list_devices();
  const bool there_is_one =
      std::any_of(all.begin(), all.end(), [](const auto& info) { return info.is_software; });
  EXPECT_EQ(Device().info().is_software, there_is_one) << Device().info().name;
}

TEST(DeviceChoice, FindsADeviceByIndexAndByPartOfItsNameInAnyCase) {
  for (const DeviceInfo& info : list_devices()) {
    EXPECT_EQ(Device({.name = std::to_string(info.index)}).info().name, info.name);
    std::string part = info.name.substr(0, 5);
    for (char& letter : part) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    EXPECT_EQ(Device({.name = part}).info().name.substr(0, 5), info.name.substr(0, 5));
  }
}

TEST(DeviceChoice, AnswersAnUnknownNameWithTheDevicesThereAre) {
  const std::string first = list_devices().front().name;
  EXPECT_THAT(refusal({.name = "no such card"}),
              testing::AllOf(testing::HasSubstr("'no such card'"), testing::HasSubstr("0: " + first)));
  EXPECT_THAT(refusal({.name = "99"}), testing::HasSubstr("0: " + first));
  EXPECT_THAT(refusal({.name = "-1"}), testing::HasSubstr("0: " + first));
}

// The loader asks the environment each time where its drivers are.
TEST(DeviceChoice, SaysHowToGetADriverWhenThereIsNone) {
  const std::map<std::string, std::string> nowhere{{"VK_DRIVER_FILES", "/nowhere.json"},
                                                   {"VK_ICD_FILENAMES", "/nowhere.json"}};
  std::map<std::string, std::string> before;
  for (const auto& [name, value] : nowhere) {
    if (const char* old = std::getenv(name.c_str())) before[name] = old;  // NOLINT(concurrency-mt-unsafe)
    setenv(name.c_str(), value.c_str(), 1);                               // NOLINT(concurrency-mt-unsafe)
  }
  const std::string said = refusal({});
  EXPECT_THROW(list_devices(), EnvironmentError);
  for (const auto& [name, value] : nowhere) unsetenv(name.c_str());  // NOLINT(concurrency-mt-unsafe)
  for (const auto& [name, value] : before) {
    setenv(name.c_str(), value.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  }
  EXPECT_THAT(said, testing::AllOf(testing::HasSubstr("Vulkan does not start"),
                                   testing::HasSubstr("mesa-vulkan-drivers")));
}

TEST(DeviceChoice, DescribesTheDevice) {
  const DeviceInfo info = Device().info();
  EXPECT_THAT(info.api_version, testing::StartsWith("1."));
  EXPECT_THAT(info.driver, testing::Not(testing::IsEmpty()));
}

// The layers must be heard at all before their silence says something.
TEST(Validation, IsHeard) {
  Device device({.name = "", .validation = true});
  RasterShaders shaders;  // the fragment shader writes two of the three colours
  shaders.vertex = compile_test_shader("Triangle.hlsl", "Vertex", hlsl::Stage::vertex);
  shaders.vertex_entry = "Vertex";
  shaders.fragment = compile_test_shader("Triangle.hlsl", "Fragment", hlsl::Stage::fragment);
  shaders.fragment_entry = "Fragment";
  shaders.colours = {Format::rgba32f, Format::r32f, Format::r32f};
  RasterPass pass(device, shaders);
  pass.bindings().buffer("_Corners", Buffer(device, 3 * 4 * sizeof(float)));
  const Image first(device, Format::rgba32f, 1, 1);
  const Image second(device, Format::r32f, 1, 1);
  const Image third(device, Format::r32f, 1, 1);
  RasterTile tile{0, 0, 1, 1, 3, {}};
  tile.push_constants.resize(16);
  pass.draw({{&first, &second, &third}}, {tile});
  EXPECT_THAT(device.validation_log()->messages(), testing::Contains(testing::HasSubstr("Attachment 2")));
}

struct SpinningPass {
  explicit SpinningPass(const Device& device)
      : spirv(compile_test_shader("Spin.hlsl")), result(device, 4), pass(device, {.spirv = spirv}) {
    pass.bindings().buffer("_Result", result);
    pass.dispatch({1, 1, 1});  // the driver compiles here
  }

  std::vector<std::uint32_t> spirv;
  Buffer result;
  ComputePass pass;
};

using GroupCount = std::array<std::uint32_t, 3>;

GroupCount rows_of(double groups) {
  const double width = std::min(std::ceil(groups), 65535.0);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(std::ceil(groups / width)), 1};
}

// Groups of the spinning shader that keep the device busy for about that long, however many run side by side.
GroupCount groups_that_take(double seconds) {
  const Device device;
  SpinningPass spinning(device);
  double groups = 4.0, taken = 0.0;
  while (taken < 0.01) {
    groups *= 4.0;
    const auto start = std::chrono::steady_clock::now();
    spinning.pass.dispatch(rows_of(groups));
    taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  return rows_of(groups * seconds / taken);
}

// False when not even one group ends in that time, as on a busy machine.
bool refuses_what_takes_longer_than(double seconds, std::shared_ptr<const ValidationLog>& log) {
  const GroupCount groups = groups_that_take(10.0 * seconds);
  Device device({.name = "", .validation = true, .timeout_seconds = seconds});
  log = device.validation_log();
  std::optional<SpinningPass> spinning;
  try {
    spinning.emplace(device);
  } catch (const EnvironmentError&) {
    return false;
  }
  EXPECT_THROW(spinning->pass.dispatch(groups), EnvironmentError);
  EXPECT_THROW(spinning->pass.dispatch({1, 1, 1}), EnvironmentError) << "the device is out of use";
  return true;
}

TEST(Timeout, IsAnErrorAndNotAHang) {
  std::shared_ptr<const ValidationLog> log;
  double seconds = 0.3;
  while (!refuses_what_takes_longer_than(seconds, log)) seconds *= 2.0;
  EXPECT_THAT(log->messages(), testing::IsEmpty()) << "nothing is destroyed while the shader runs";
}

TEST_F(Gpu, TimesGrowWithTheWork) {
  SpinningPass spinning(*device);
  // The least of many: one that had to wait for a processor says nothing of the work.
  const std::vector<double> runs = spinning.pass.dispatch(groups_that_take(0.01), 10);
  const double little = *std::min_element(runs.begin(), runs.end());
  const auto start = std::chrono::steady_clock::now();
  const std::vector<double> much = spinning.pass.dispatch(groups_that_take(0.5), 2);
  const std::chrono::duration<double, std::nano> wall = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(much.size(), 2U);
  EXPECT_GT(little, 0.0);
  EXPECT_GT(much[0], 5.0 * little);
  EXPECT_LE(much[0] + much[1], wall.count());
}

}  // namespace
}  // namespace penumbra::gpu
