#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>

#include "platform/interrupt.h"
#include "reference/row_blocks.h"
#include "reference/scratch_folder.h"

namespace penumbra::reference {
namespace {

constexpr int width = 10;
constexpr int height = 45;
constexpr int pixels = width * height;

struct CountedJob {
  std::atomic<int> asked = 0;
  RowJob job;

  CountedJob() {
    job.size = {width, height};
    job.valid.assign(std::size_t{pixels}, 1);
    job.samples = 1024;
    job.rays_per_pixel = 1024;
    job.key = "counted";
    job.count = [this](std::size_t pixel) {
      ++asked;
      return HalfCounts{static_cast<std::uint16_t>(pixel % 500), static_cast<std::uint16_t>(pixel % 300)};
    };
  }
};

TEST(RowBlocks, ACancelledRunKeepsNothingAndTheNextOneIsWhole) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path() / "cache");
  CountedJob job;
  RunOptions run;
  run.cancelled = [&] { return job.asked >= pixels / 2; };
  EXPECT_THROW(run_rows(job.job, run, &cache), platform::Interrupted);
  EXPECT_LT(job.asked, pixels);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  CountedJob whole;
  EXPECT_EQ(run_rows(whole.job, {}, &cache), run_rows(CountedJob().job, {}, nullptr));
  EXPECT_EQ(whole.asked, pixels);
}

TEST(RowBlocks, TheErrorOfARowIsThrown) {
  CountedJob job;
  job.job.count = [](std::size_t pixel) -> HalfCounts {
    if (pixel == pixels / 2) throw std::runtime_error("of a pixel");
    return {};
  };
  EXPECT_THROW(run_rows(job.job, {}, nullptr), std::runtime_error);
}

TEST(KeptImage, AnswersItsJobOrIsNone) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  CountedJob job;
  const VisibilityImage whole = run_rows(job.job, {}, &cache);
  EXPECT_EQ(kept_image(job.job, &cache), whole);
  EXPECT_FALSE(kept_image(job.job, nullptr).has_value());
  const auto expect_none = [&](const VisibilityImage& forged, const char* what) {
    cache.store(job.job.key, forged);
    EXPECT_FALSE(kept_image(job.job, &cache).has_value()) << what;
  };
  expect_none({0, 0, {}, {}, 0.0, 1024}, "of no size");
  expect_none({1 << 30, 0, {}, {}, 0.0, 1024}, "of an absurd size without pixels");
  expect_none({height, width, whole.visibility, whole.valid, 0.0, 1024}, "turned");
  expect_none({width, height, whole.visibility, whole.valid, 0.0, 512}, "of other samples");
  VisibilityImage other = whole;
  other.valid[7] = 0;
  expect_none(other, "of other receivers");
}

TEST(RowBlocks, PixelsWithoutReceiverAreNeitherAskedNorCounted) {
  CountedJob job;
  for (std::size_t pixel = 0; pixel < job.job.valid.size(); pixel += 3) job.job.valid[pixel] = 0;
  double total = 0.0;
  double last = 0.0;
  RunOptions run;
  run.progress = [&](double done, double all) { last = done, total = all; };
  const VisibilityImage image = run_rows(job.job, run, nullptr);
  EXPECT_EQ(job.asked, pixels * 2 / 3);
  EXPECT_EQ(total, 1024.0 * job.asked);
  EXPECT_EQ(last, total);
  EXPECT_EQ(image.visibility[3], 1.0F);
}

}  // namespace
}  // namespace penumbra::reference
