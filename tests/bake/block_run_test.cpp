// A finished bake is kept, an interrupted one is not, and one that fails says why.
#include "bake/block_run.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>

namespace penumbra::bake {
namespace {

class BlockRun : public testing::Test {
 protected:
  BlockRun() { std::filesystem::remove_all(folder_); }
  ~BlockRun() override { std::filesystem::remove_all(folder_); }

  BakeJob job() {
    return {"0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef", 10, [this](int block) {
              ++computed_;
              const auto number = static_cast<float>(block);
              return std::vector<float>{number, number + 0.5F};
            }};
  }

  static std::vector<float> expected() {
    std::vector<float> numbers;
    for (int i = 0; i < 20; ++i) numbers.push_back(static_cast<float>(i) * 0.5F);
    return numbers;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      (std::string("penumbra-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  platform::CacheStore store_{folder_};
  std::atomic<int> computed_{0};
};

TEST_F(BlockRun, GivesTheBlocksInOrder) {
  double next = 0.0;
  BakeOptions options;
  options.jobs = 4;
  options.progress = [&](double done, double total) {
    EXPECT_EQ(done, next++);
    EXPECT_EQ(total, 10.0);
  };
  EXPECT_EQ(run_bake(job(), options), expected());
  EXPECT_EQ(next, 11.0);
}

TEST_F(BlockRun, IsKeptWhenItIsWhole) {
  BakeOptions options;
  options.jobs = 1;
  options.store = &store_;
  options.cancelled = [this] { return computed_ == 4; };
  EXPECT_THROW(run_bake(job(), options), platform::Interrupted);
  EXPECT_EQ(computed_, 4);
  EXPECT_FALSE(std::filesystem::exists(folder_));

  options.cancelled = nullptr;
  EXPECT_EQ(run_bake(job(), options), expected());
  EXPECT_EQ(computed_, 14);
  EXPECT_EQ(run_bake(job(), options), expected());
  EXPECT_EQ(computed_, 14);
}

TEST_F(BlockRun, OfAnotherKeyIsAnother) {
  BakeOptions options;
  options.store = &store_;
  run_bake(job(), options);
  BakeJob other = job();
  other.key.back() = '0';
  run_bake(other, options);
  EXPECT_EQ(computed_, 20);
}

TEST_F(BlockRun, ThrowsWhatABlockThrows) {
  BakeJob failing = job();
  failing.block = [](int block) -> std::vector<float> {
    if (block == 3) throw std::runtime_error("block 3");
    return {};
  };
  BakeOptions options;
  options.jobs = 2;
  EXPECT_THROW(run_bake(failing, options), std::runtime_error);
}

}  // namespace
}  // namespace penumbra::bake
