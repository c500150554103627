// Tests edges of a multisampled picture: the reference, and a technique that shades each of their samples.
#include <gmock/gmock.h>

#include "study/case_setup.h"
#include "study/small_study.h"

namespace penumbra::study {
namespace {

std::map<std::string, Record> at_edges(const std::string& scene, int samples) {
  SmallStudy study(scene::built_in(scene), 2.0, 160, 90);
  study.settings.noise_seeds = 2;
  study.settings.edge_samples = samples;
  return study.records(library_subjects({"screen-pcss-angular-24-16", "screen-pcss-angular-24-16-edges"}));
}

double fetches_of(const Record& record, const std::string& pass) {
  for (const PassRecord& of : record.passes)
    if (of.pass == pass) return of.fetches_per_pixel;
  ADD_FAILURE() << "no pass " << pass;
  return 0.0;
}

// The samples of the graph's targets lie where the reference's pictures are taken: else their surfaces, and
// the error, would be those of neighbours.
TEST(Edges, ShadingEachSampleHalvesTheError) {
  const auto of = at_edges("street", 4);
  const Record& pixels = of.at("screen-pcss-angular-24-16");
  const Record& samples = of.at("screen-pcss-angular-24-16-edges");
  EXPECT_EQ(samples.reference.kind, "ray-traced disc light, mean of 4 samples at edges");
  EXPECT_EQ(samples.reference.samples, 4 * 64);
  EXPECT_GT(samples.metrics.pixels, 150U);
  EXPECT_LT(samples.metrics.pixels, 160U * 90U / 10U);
  EXPECT_EQ(samples.metrics.pixels, pixels.metrics.pixels);
  EXPECT_EQ(samples.metrics.invalid, 0U);
  EXPECT_LT(*samples.metrics.rmse_all, 0.5 * *pixels.metrics.rmse_all);
  EXPECT_GT(*samples.metrics.fetches_mean, 2.0 * *pixels.metrics.fetches_mean) << "at edges";
}

// Everywhere else a pixel is shaded once.
TEST(Edges, OtherPixelsAreShadedOnce) {
  const auto of = at_edges("contact-boxes", 0);
  const Record& pixels = of.at("screen-pcss-angular-24-16");
  const Record& samples = of.at("screen-pcss-angular-24-16-edges");
  const double per_pixel = *pixels.metrics.fetches_mean;
  EXPECT_LT(fetches_of(samples, "ShadePixels"), per_pixel + 1.0);
  EXPECT_GT(fetches_of(samples, "ShadePixels"), 0.5 * per_pixel)
      << "of the whole picture: the sky costs less";
  EXPECT_LT(fetches_of(samples, "ShadeSamples"), 0.5 * per_pixel);
  EXPECT_LE(fetches_of(samples, "MarkSamples"), 4.0);
  EXPECT_LT(fetches_of(samples, "MarkSurfaces"), 2.0);
}

TEST(Edges, HaveTwoFourOrEightSamples) {
  EXPECT_THROW(sample_offsets(3), std::invalid_argument);
}

SampleView view(const glm::vec3& position, const glm::vec3& normal, std::uint32_t triangle, float visibility,
                bool valid = true) {
  SampleView made;
  made.receivers = {1, 1, {glm::vec4(position, 1.0F)}, {}, {glm::vec4(normal, 0.0F)}, {triangle}};
  made.traced = {1, 1, {visibility}, {static_cast<std::uint8_t>(valid ? 1 : 0)}, 0.02, 64};
  return made;
}

TEST(EdgeReference, IsTheMeanWhereSamplesSeeSeveralSurfaces) {
  parameters::Camera camera;
  camera.position = {0.0, 0.0, 0.0};
  camera.fov_y_degrees = 90.0;  // a pixel of a picture of one row is 2 m wide at 1 m
  const glm::vec3 up(0.0F, 1.0F, 0.0F);
  const SampleView first = view({0.0F, 0.0F, 10.0F}, up, 1, 1.0F);
  const auto of = [&](const SampleView& second) {
    return edge_reference(std::vector<SampleView>{first, second}, camera);
  };
  const reference::VisibilityImage edge = of(view({0.0F, 0.0F, 10.0F}, {1.0F, 0.0F, 0.0F}, 2, 0.5F));
  EXPECT_EQ(edge.valid[0], 1);
  EXPECT_FLOAT_EQ(edge.visibility[0], 0.75F);
  EXPECT_EQ(edge.samples, 128);
  EXPECT_NEAR(edge.noise_floor, 0.02 / std::sqrt(2.0), 1e-9);
  EXPECT_EQ(of(view({0.0F, 11.0F, 10.0F}, up, 2, 0.5F)).valid[0], 1) << "apart by more than half of 20 m";
  EXPECT_EQ(of(view({0.0F, 9.0F, 10.0F}, up, 2, 0.5F)).valid[0], 0);
  EXPECT_EQ(of(view({0.0F, 11.0F, 10.0F}, up, 1, 0.5F)).valid[0], 0) << "one triangle";
  EXPECT_EQ(of(view({0.0F, 11.0F, 10.0F}, up, 2, 0.5F, false)).valid[0], 0) << "beside the sky";
}

}  // namespace
}  // namespace penumbra::study
