#include "gpu/resources.h"

#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "gpu/gpu_test.h"
#include "input/input_error.h"

namespace penumbra::gpu {
namespace {

constexpr int kWidth = 37;  // odd, so that a row is no multiple of anything
constexpr int kHeight = 11;

std::vector<std::byte> random_bytes(std::size_t count) {
  std::mt19937 random(7);
  std::vector<std::byte> bytes(count);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() & 0xFFU);
  return bytes;
}

// These are bit patterns that a shadow map should never hold and must survive: NaNs with payload, infinities,
// out of range.
std::vector<float> poison() {
  using Limits = std::numeric_limits<float>;
  return {std::bit_cast<float>(0x7FC0'0000U),
          std::bit_cast<float>(0xFFFF'FFFFU),
          Limits::infinity(),
          -Limits::infinity(),
          -1.0F,
          2.0F,
          1e30F,
          -0.0F,
          Limits::denorm_min(),
          0.0F,
          1.0F,
          0.5F};
}

class GpuFormat : public Gpu, public testing::WithParamInterface<Format> {};

TEST_P(GpuFormat, KeepsEveryBitThroughUploadAndDownload) {
  ASSERT_TRUE(device->supports(GetParam()));
  Image image(*device, GetParam(), kWidth, kHeight);
  std::vector<std::byte> bytes = random_bytes(image.size_bytes());
  if (GetParam() == Format::depth24) {
    for (std::size_t at = 3; at < bytes.size(); at += 4) bytes[at] = std::byte{0};
  }
  image.upload(bytes);
  EXPECT_EQ(image.download<std::byte>(), bytes);
}

TEST_P(GpuFormat, RefusesAnUploadOfAnotherSize) {
  Image image(*device, GetParam(), kWidth, kHeight);
  EXPECT_THROW(image.upload(random_bytes(image.size_bytes() - 1)), std::invalid_argument);
  EXPECT_THROW(image.upload(random_bytes(image.size_bytes() + 1)), std::invalid_argument);
}

TEST_P(GpuFormat, HasANameThatFindsIt) {
  EXPECT_EQ(find_format(name(GetParam())), GetParam());
  EXPECT_EQ(find_format("r64f"), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Formats, GpuFormat, testing::ValuesIn(all_formats().begin(), all_formats().end()),
                         format_name);

class GpuLoad : public Gpu {
 protected:
  std::vector<std::uint32_t> bits_seen_by_shader(const Image& image) {
    const std::vector<std::uint32_t> spirv = compile_test_shader("LoadBits.hlsl");
    ComputePass pass(*device, {.spirv = spirv});
    const auto texels = static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
    const Buffer result(*device, texels * sizeof(std::uint32_t));
    pass.bindings().image("_Map", image);
    pass.bindings().buffer("_Result", result);
    pass.dispatch({std::uint32_t(image.width()), std::uint32_t(image.height()), 1});
    return result.download<std::uint32_t>();
  }
};

TEST_F(GpuLoad, PoisonedDepthsReachTheShaderBitForBit) {
  for (const Format format : {Format::depth32, Format::r32f}) {
    const std::vector<float> texels = poison();
    Image image(*device, format, 4, 3);
    image.upload(texels);
    EXPECT_EQ(image.download<std::uint32_t>(),
              std::vector<std::uint32_t>(reinterpret_cast<const std::uint32_t*>(texels.data()),
                                         reinterpret_cast<const std::uint32_t*>(texels.data()) + 12));
    const std::vector<std::uint32_t> seen = bits_seen_by_shader(image);
    for (std::size_t at = 0; at < texels.size(); ++at) {
      EXPECT_EQ(seen[at], std::bit_cast<std::uint32_t>(texels[at])) << name(format) << " texel " << at;
    }
  }
}

// A unorm texel is its integer over the largest. The texels are 0, 1 and an arbitrary one.
TEST_F(GpuLoad, UnormDepthsReachTheShaderAsFractions) {
  Image depth16(*device, Format::depth16, 3, 1);
  depth16.upload(std::vector<std::uint16_t>{0, 65535, 12345});
  Image depth24(*device, Format::depth24, 3, 1);
  depth24.upload(std::vector<std::uint32_t>{0, 0xFF'FFFF, 0x12'3456});
  const std::vector<std::uint32_t> seen16 = bits_seen_by_shader(depth16);
  const std::vector<std::uint32_t> seen24 = bits_seen_by_shader(depth24);
  const float ulp = std::numeric_limits<float>::epsilon();
  const std::vector<double> expected16{0.0, 1.0, 12345.0 / 65535.0};
  const std::vector<double> expected24{0.0, 1.0, double(0x12'3456) / double(0xFF'FFFF)};
  for (std::size_t at = 0; at < 3; ++at) {
    EXPECT_NEAR(std::bit_cast<float>(seen16[at]), expected16[at], expected16[at] * ulp);
    EXPECT_NEAR(std::bit_cast<float>(seen24[at]), expected24[at], expected24[at] * ulp);
  }
}

TEST_F(Gpu, BuffersKeepEveryByteAndPartialUploadsLeaveTheRest) {
  std::vector<std::byte> bytes = random_bytes(4100);
  Buffer buffer(*device, std::span<const std::byte>(bytes));
  EXPECT_EQ(buffer.download<std::byte>(), bytes);
  buffer.upload(std::vector<std::uint32_t>{1, 2});
  const std::vector<std::uint32_t> words = buffer.download<std::uint32_t>();
  EXPECT_EQ(words[0], 1U);
  EXPECT_EQ(words[1], 2U);
  EXPECT_EQ(words.size(), 1025U);
  EXPECT_EQ(std::memcmp(&words[2], &bytes[8], 4092), 0);
}

TEST_F(Gpu, RefusesWhatDoesNotFit) {
  Buffer buffer(*device, 10);
  EXPECT_THROW(buffer.upload(random_bytes(11)), std::invalid_argument);
  EXPECT_THROW(buffer.download<std::uint32_t>(), std::invalid_argument);
  EXPECT_THROW(Buffer(*device, 0), std::invalid_argument);
  EXPECT_THROW(Buffer(*device, std::size_t(1) << 50), EnvironmentError);
  EXPECT_THROW(Image(*device, Format::depth32, 0, 1), std::invalid_argument);
  EXPECT_THROW(Image(*device, Format::depth32, 1 << 20, 1), EnvironmentError);
}

TEST_F(Gpu, ResourcesOutliveTheirDevice) {
  Buffer buffer(*device, 4);
  device.reset();
  buffer.upload(std::vector<int>{42});
  EXPECT_EQ(buffer.download<int>(), std::vector<int>{42});
}

}  // namespace
}  // namespace penumbra::gpu
