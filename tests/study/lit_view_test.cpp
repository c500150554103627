// Draws lit pictures of a small study from end to end, against one that was looked at.
#include "study/lit_view.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "study/small_study.h"

namespace penumbra::study {
namespace {

std::vector<PictureRow> lit_rows(const std::vector<std::string>& techniques, int supersampling) {
  SmallStudy study(scene::built_in("contact-boxes"), 2.0, 96 * supersampling, 54 * supersampling);
  study.settings.frame.shadows.cascades = parameters::ShadowSettings().cascades;
  lighting::LitSettings lit;
  lit.supersampling = supersampling;
  lit.sun_rays = 64;
  lit.cache = study.cache.path();
  LitView view(lit, [](auto&&...) {});
  study.settings.answered = [&](const SubjectAnswer& answer) { view.add(answer); };
  std::vector<Subject> subjects = library_subjects(techniques);
  for (Subject& subject : subjects) subject.raster_bias = {};  // the bias of the picture
  StudyOutcome outcome = study.run(subjects);
  view.replace_pictures(outcome.pictures);
  return outcome.pictures;
}

Picture golden(const std::string& name) {
  std::ifstream stream(std::string(PENUMBRA_SOURCE_DIR) + "/tests/golden/" + name, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return decode_png(std::as_bytes(std::span(bytes)), name);
}

// The picture has boxes of six paints on concrete in the afternoon, their shadows blue with sky and soft at
// their ends. Another compiler or processor rounds rays and powers in another way: a pixel at an edge may
// change, the picture may not.
TEST(LitView, IsThePictureThatWasLookedAt) {
  const std::vector<PictureRow> rows = lit_rows({"pcss-angular-24-16"}, 2);
  ASSERT_EQ(rows.size(), 1U);
  if (const char* folder = std::getenv("PENUMBRA_UPDATE_GOLDEN"); folder != nullptr) {
    const std::span<const std::byte> png = rows[0].result.png();
    std::ofstream(std::string(PENUMBRA_SOURCE_DIR) + "/tests/golden/lit-contact-boxes.png", std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  }
  const Picture expected = golden("lit-contact-boxes.png");
  const Picture result = rows[0].result;
  ASSERT_EQ(result.width, expected.width);
  ASSERT_EQ(result.height, expected.height);
  double sum = 0.0;
  int far = 0;
  for (std::size_t i = 0; i < expected.samples.size(); ++i) {
    const int apart = std::abs(int{result.samples[i]} - int{expected.samples[i]});
    sum += apart;
    far += apart > 24 ? 1 : 0;
  }
  EXPECT_LT(sum / static_cast<double>(expected.samples.size()), 0.5);
  EXPECT_LT(far, 20);
}

TEST(LitView, PicturesOfOneFrameDifferByTheirShadowsAlone) {
  const std::vector<PictureRow> rows = lit_rows({"hard", "pcss-angular-24-16"}, 1);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].reference, rows[1].reference);
  const Picture first = rows[0].result, second = rows[1].result;
  int same = 0;
  int other = 0;
  for (int y = 0; y < 54; ++y) {
    for (int x = 0; x < 96; ++x) (pixel(first, x, y) == pixel(second, x, y) ? same : other) += 1;
  }
  EXPECT_GT(same, other) << "what both see lit or shadowed";
  EXPECT_GT(other, 100) << "penumbrae";
  for (const PictureRow& row : rows) EXPECT_EQ(row.error.unpacked().width, 96);
}

TEST(LitView, AllPicturesHaveTheSizeThatWasAskedFor) {
  const std::vector<PictureRow> rows = lit_rows({"screen-pcss-angular-24-16-masked"}, 2);
  for (const PackedPicture* picture :
       {&rows[0].reference, &rows[0].result, &rows[0].error, &rows[0].fetches, &rows[0].mask}) {
    EXPECT_EQ(picture->unpacked().width, 96);
    EXPECT_EQ(picture->unpacked().height, 54);
  }
}

TEST(LitView, ReplacesThePicturesOfItsOwnStudyAlone) {
  const LitView view({}, [](auto&&...) {});
  std::vector<PictureRow> rows(1);
  EXPECT_THROW(view.replace_pictures(rows), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
