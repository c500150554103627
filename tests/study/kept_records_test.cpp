// A study that is interrupted goes on where it stopped, with the same results.
#include "study/kept_records.h"

#include <gtest/gtest.h>

#include <fstream>

#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKey = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

class KeptRecordsTest : public testing::Test {
 protected:
  KeptRecordsTest() { fs::remove_all(folder_); }
  ~KeptRecordsTest() override { fs::remove_all(folder_); }

  static KeptRecord made() {
    const Results results = synthetic::results();
    KeptRecord kept{results.frames.front(), results.records.front(), {}, {"_Unset", "_Other"}};
    kept.pictures = synthetic::picture_row(kept.record.scene, kept.record.technique);
    kept.pictures.light_degrees = kept.record.light_degrees;
    kept.pictures.debug_views.emplace("Cascades", kept.pictures.reference);
    return kept;
  }

  std::size_t files() const {
    std::size_t count = 0;
    if (!fs::exists(folder_)) return 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) count += entry.is_regular_file();
    return count;
  }

  fs::path folder_ =
      fs::temp_directory_path() /
      (std::string("penumbra-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(KeptRecordsTest, GiveBackWhatWasStoredInAnotherRun) {
  const KeptRecord kept = made();
  KeptRecords(folder_).store(kKey, kept);
  const std::optional<KeptRecord> found = KeptRecords(folder_).find(kKey);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->record, kept.record);
  EXPECT_EQ(found->unset_uniforms, kept.unset_uniforms);
  EXPECT_EQ(found->pictures.scene, kept.pictures.scene);
  EXPECT_EQ(found->pictures.technique, kept.pictures.technique);
  for (const auto picture : {&PictureRow::reference, &PictureRow::result, &PictureRow::error,
                             &PictureRow::fetches, &PictureRow::fetch_counts, &PictureRow::mask})
    EXPECT_EQ(found->pictures.*picture, kept.pictures.*picture);
  EXPECT_EQ(found->pictures.debug_views, kept.pictures.debug_views);
  EXPECT_EQ(found->pictures.error_scale, kept.pictures.error_scale);
  EXPECT_EQ(found->pictures.fetch_scale, kept.pictures.fetch_scale);
}

TEST_F(KeptRecordsTest, AreDroppedAfterTheStudy) {
  KeptRecords first(folder_);
  first.store(kKey, made());
  EXPECT_EQ(files(), 1U);
  KeptRecords second(folder_);
  second.drop();
  EXPECT_EQ(files(), 1U) << "of another study";
  EXPECT_TRUE(second.find(kKey));
  second.drop();
  EXPECT_EQ(files(), 0U);
}

TEST_F(KeptRecordsTest, ThatAreDamagedAreMeasuredAgain) {
  KeptRecords(folder_).store(kKey, made());
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  }
  EXPECT_FALSE(KeptRecords(folder_).find(kKey));
}

}  // namespace
}  // namespace penumbra::study
