#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "platform/interrupt.h"
#include "reference/hand_built.h"
#include "reference/row_blocks.h"
#include "reference/scratch_folder.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

constexpr int width = 10;
constexpr int height = 45;  // five blocks of eight rows and one of five
constexpr int pixels = width * height;
constexpr int block_pixels = width * rows_per_block;
constexpr std::size_t three_blocks = std::size_t{3} * std::size_t{block_pixels};

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

// Cancels once `blocks` blocks are done.
RunOptions stop_after(int blocks, std::atomic<bool>& stop) {
  RunOptions run;
  run.progress = [&stop, blocks](double done, double) {
    if (done >= 1024.0 * block_pixels * blocks) stop = true;
  };
  run.cancelled = [&stop] { return stop.load(); };
  run.checkpoint_seconds = 1e9;
  return run;
}

TEST(Resume, FinishedBlocksAreNotComputedAgain) {
  for (const int blocks : {1, 3, 5}) {
    const ScratchFolder folder;
    const ReferenceCache cache(folder.path());
    CountedJob first;
    const VisibilityImage expected = run_rows(first.job, {}, nullptr);
    EXPECT_EQ(first.asked, pixels);

    CountedJob stopped;
    std::atomic<bool> stop = false;
    EXPECT_THROW(run_rows(stopped.job, stop_after(blocks, stop), &cache), platform::Interrupted);
    EXPECT_EQ(stopped.asked, blocks * block_pixels);

    CountedJob resumed;
    double reused = -1.0;
    RunOptions run;
    run.progress = [&](double done, double total) {
      if (reused < 0.0) reused = done;
      EXPECT_EQ(total, 1024.0 * pixels);
    };
    EXPECT_EQ(run_rows(resumed.job, run, &cache), expected);
    EXPECT_EQ(resumed.asked, pixels - blocks * block_pixels);
    EXPECT_EQ(reused, 1024.0 * blocks * block_pixels);
    EXPECT_EQ(cache.find("counted"), expected);
    EXPECT_TRUE(cache.find_beginning("counted").empty()) << "the beginning is gone once the whole is there";
  }
}

TEST(Resume, CheckpointsLeaveABeginningForAProcessThatIsKilled) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  CountedJob job;
  job.job.count = [&](std::size_t pixel) -> HalfCounts {
    if (pixel >= three_blocks) throw std::runtime_error("the machine stops here");
    return {1, 2};
  };
  RunOptions run;
  run.checkpoint_seconds = 0.0;
  EXPECT_THROW(run_rows(job.job, run, &cache), std::runtime_error);
  EXPECT_EQ(cache.find_beginning("counted").size(), three_blocks);
}

TEST(Resume, ABeginningLongerThanTheImageIsIgnored) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  cache.store_beginning("counted", std::vector<HalfCounts>(pixels + 1, HalfCounts{9, 9}));
  CountedJob job;
  const VisibilityImage image = run_rows(job.job, {}, &cache);
  EXPECT_EQ(job.asked, pixels);
  EXPECT_EQ(image.visibility[1], 2.0F / 1024.0F);
}

TEST(Resume, ABeginningOfMorePointsThanAreAskedIsIgnored) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  cache.store_beginning("counted", std::vector<HalfCounts>(three_blocks, HalfCounts{1000, 25}));
  CountedJob job;
  run_rows(job.job, {}, &cache);
  EXPECT_EQ(job.asked, pixels);
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

TEST(Resume, AnInterruptedTraceEndsAsAnUninterruptedOne) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  const hand_built::Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-9.0, 0.0, -9.0, 9.0}, 3.0);
  const scene::Receivers receivers = hand_built::receivers(
      setting, {width, height}, [](int x, int y) { return glm::dvec2(0.01 * x - 0.05, 0.1 * y); });
  const VisibilityImage expected = trace_visibility(scene, receivers, setting.light);
  std::atomic<bool> stop = false;
  EXPECT_THROW(trace_visibility(scene, receivers, setting.light, {}, stop_after(2, stop), &cache),
               platform::Interrupted);
  double retraced = 0.0;
  double before = -1.0;
  RunOptions run;
  run.progress = [&](double done, double) {
    if (before >= 0.0) retraced += done - before;
    before = done;
  };
  EXPECT_EQ(trace_visibility(scene, receivers, setting.light, {}, run, &cache), expected);
  EXPECT_EQ(retraced, 1024.0 * (pixels - 2 * block_pixels));
}

TEST(Resume, PixelsWithoutReceiverAreNeitherAskedNorCounted) {
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
