#include "gpu/pipeline_statistics.h"

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// Any device answers, or says that it cannot: lavapipe came without the extension in Mesa 22.3. What the
// figures are is tested with the cost room, on a device that has them.
TEST(PipelineStatistics, ADeviceHasThemOrSaysWhatItLacks) {
  try {
    const StatisticsDevice device("");
    EXPECT_THAT(device.compute({compile_test_shader("AddUniform.hlsl"), "Main"}), Not(IsEmpty()));
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no VK_KHR_pipeline_executable_properties here"));
    EXPECT_THAT(error.what(), HasSubstr(list_devices().front().name));
  }
}

TEST(PipelineStatistics, AMissingDeviceIsNamedWithThoseThereAre) {
  try {
    StatisticsDevice device("no such device");
    FAIL() << "there is one";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no Vulkan device 'no such device'; there are"));
  }
}

}  // namespace
}  // namespace penumbra::gpu
