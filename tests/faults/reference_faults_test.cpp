// References are kept when memory or the disk fails: the image is right, or there is none.
#include "faults/every_fault.h"
#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/scratch_folder.h"

namespace penumbra::faults {
namespace {

namespace fs = std::filesystem;
using namespace reference;

constexpr int width = 10;
constexpr int height = 24;

RowJob job() {
  RowJob made;
  made.size = {width, height};
  made.valid.assign(std::size_t{width} * height, 1);
  made.samples = 1024;
  made.rays_per_pixel = 1024;
  made.key = "faulty";
  made.count = [](std::size_t pixel) {
    return HalfCounts{static_cast<std::uint16_t>(pixel % 500), static_cast<std::uint16_t>(pixel % 300)};
  };
  return made;
}

RunOptions options() {
  RunOptions run;
  run.jobs = 1;
  run.cancelled = [] { return false; };
  return run;
}

void expect_right(const std::optional<VisibilityImage>& image, bool must_be_there) {
  static const VisibilityImage expected = run_rows(job(), options(), nullptr);
  ASSERT_TRUE(image || !must_be_there);
  EXPECT_TRUE(!image || image->visibility == expected.visibility);
}

TEST(ReferenceFaults, AnImageIsRightWhateverFails) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "cache";
  const ReferenceCache cache(folder);
  std::optional<VisibilityImage> image;
  with_every_fault({[&] {
                      fs::remove_all(folder);
                      image.reset();
                    },
                    [&] { image = run_rows(job(), options(), &cache); },
                    [&](End end, bool) {
                      expect_right(image, end == End::done);
                      expect_right(cache.find("faulty"), false);
                      expect_right(run_rows(job(), options(), &cache), true);
                    }});
}

TEST(ReferenceFaults, AKeptImageIsOldOrNewWhole) {
  const ScratchFolder scratch;
  const ReferenceCache cache(scratch.path());
  const VisibilityImage right = run_rows(job(), options(), nullptr);
  cache.store("faulty", right);
  with_every_fault({[] {}, [&] { cache.store("faulty", right); },
                    [&](End, bool) { expect_right(cache.find("faulty"), true); }});
}

// A single fault may be got over: the folder is made, and the file opened again.
TEST(ReferenceFaults, AnImageThatIsNotKeptIsSaid) {
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "cache";
  const VisibilityImage right = run_rows(job(), options(), nullptr);
  bool stored = false;
  for (const Extent extent : {Extent::once, Extent::from_there})
    with_every_fault(Kind::full, extent,
                     {[&] { std::filesystem::remove_all(folder); },
                      [&] { stored = ReferenceCache(folder).store("faulty", right); },
                      [&](End, bool failed) {
                        EXPECT_EQ(stored, ReferenceCache(folder).find("faulty").has_value());
                        EXPECT_TRUE(stored || failed);
                        EXPECT_FALSE(stored && failed && extent == Extent::from_there);
                      }});
}

TEST(ReferenceFaults, ReadingGivesTheImageOrNone) {
  const ScratchFolder scratch;
  const ReferenceCache cache(scratch.path());
  cache.store("faulty", run_rows(job(), options(), nullptr));
  std::optional<VisibilityImage> image;
  with_every_fault({[&] { image.reset(); }, [&] { image = cache.find("faulty"); },
                    [&](End, bool failed) { expect_right(image, !failed); }});
}

}  // namespace
}  // namespace penumbra::faults
