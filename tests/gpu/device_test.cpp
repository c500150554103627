#include "gpu/device.h"

#include <chrono>
#include <cstdlib>
#include <map>

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

TEST(DeviceChoice, TakesTheSoftwareDeviceWhenNothingIsSaid) {
  EXPECT_TRUE(Device().info().is_software) << Device().info().name;
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
  const std::vector<std::uint32_t> spirv = compile_test_shader("CopyImage.hlsl");
  ComputePass pass(device, {.spirv = spirv});
  Image image(device, Format::rgba32f, 1, 1);
  image.upload(std::vector<float>(4, 0.0F));
  pass.bindings().sampled_image(slot_of(spirv, "_Map"), image);
  pass.bindings().storage_image(slot_of(spirv, "_Image"), image);
  pass.dispatch({1, 1, 1});
  EXPECT_THAT(device.validation_log()->messages(), testing::Contains(testing::HasSubstr("layout")));
}

struct SpinningPass {
  explicit SpinningPass(const Device& device)
      : spirv(compile_test_shader("Spin.hlsl")), result(device, 4), pass(device, {.spirv = spirv}) {
    pass.bindings().storage_buffer(slot_of(spirv, "_Result"), result);
    pass.dispatch({1, 1, 1});  // the driver compiles here
  }

  std::vector<std::uint32_t> spirv;
  Buffer result;
  ComputePass pass;
};

TEST(Timeout, IsAnErrorAndNotAHang) {
  std::shared_ptr<const ValidationLog> log;
  {
    Device device({.name = "", .validation = true, .timeout_seconds = 0.3});
    log = device.validation_log();
    SpinningPass spinning(device);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(spinning.pass.dispatch({8'000, 1, 1}), EnvironmentError);  // seconds of work
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(900));
    EXPECT_THROW(spinning.pass.dispatch({1, 1, 1}), EnvironmentError) << "the device is out of use";
  }
  EXPECT_THAT(log->messages(), testing::IsEmpty()) << "nothing is destroyed while the shader runs";
}

TEST_F(Gpu, TimesGrowWithTheWork) {
  SpinningPass spinning(*device);
  const double little = spinning.pass.dispatch({20, 1, 1}, 3).back();
  const auto start = std::chrono::steady_clock::now();
  const std::vector<double> much = spinning.pass.dispatch({1000, 1, 1}, 2);
  const std::chrono::duration<double, std::nano> wall = std::chrono::steady_clock::now() - start;
  ASSERT_EQ(much.size(), 2U);
  EXPECT_GT(little, 0.0);
  EXPECT_GT(much[0], 5.0 * little);
  EXPECT_LE(much[0] + much[1], wall.count());
  EXPECT_GT(much[0] + much[1], 0.5 * wall.count()) << "the device did nothing else";
}

}  // namespace
}  // namespace penumbra::gpu
