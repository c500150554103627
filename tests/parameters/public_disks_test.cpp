// Compares our Poisson disks with the best published ones (public_disks.json says whose, and how measured).
#include <gtest/gtest.h>

#include <map>

#include "input/located_json.h"
#include "parameters/disk.h"
#include "parameters/disk_quality.h"

namespace penumbra::parameters {
namespace {

struct Figures {
  double half_plane_rmse = 1.0;
  double star_discrepancy = 1.0;
};

std::map<int, Figures> best_published() {
  const auto document = LocatedJson::read(PENUMBRA_SOURCE_DIR "/tests/parameters/public_disks.json");
  std::map<int, Figures> best;
  for (const auto& disk : document.value().at("disks")) {
    Figures& figures = best[disk.at("count").get<int>()];
    figures.half_plane_rmse = std::min(figures.half_plane_rmse, disk.at("half_plane_rmse").get<double>());
    figures.star_discrepancy = std::min(figures.star_discrepancy, disk.at("star_discrepancy").get<double>());
  }
  return best;
}

TEST(PublicDisks, OursHaveAFifthLessHalfPlaneErrorAtEverySize) {
  const auto published = best_published();
  for (const int count : kPoissonSizes) {
    ASSERT_TRUE(published.contains(count)) << count;
    EXPECT_LT(disk_quality(poisson_disk(count)).half_plane_rmse, 0.8 * published.at(count).half_plane_rmse)
        << count;
  }
}

// At 128 points the published set is the better by 7 %: our generator trades it for half-plane error.
TEST(PublicDisks, OursHaveLessStarDiscrepancyUpTo100Points) {
  const auto published = best_published();
  for (const int count : {25, 32, 64, 100}) {
    EXPECT_LT(disk_quality(poisson_disk(count)).star_discrepancy, published.at(count).star_discrepancy)
        << count;
  }
  EXPECT_LT(disk_quality(poisson_disk(128)).star_discrepancy, 1.07 * published.at(128).star_discrepancy);
}

TEST(PublicDisks, OursBeatVogelAtEverySize) {
  for (const int count : kPoissonSizes) {
    EXPECT_LT(disk_quality(poisson_disk(count)).half_plane_rmse,
              disk_quality(vogel_disk(count)).half_plane_rmse)
        << count;
  }
}

}  // namespace
}  // namespace penumbra::parameters
