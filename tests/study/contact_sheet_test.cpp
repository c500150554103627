#include "study/contact_sheet.h"

#include <gtest/gtest.h>

#include <random>

#include "study/composition.h"
#include "study/picture_search.h"

namespace penumbra::study {
namespace {

Picture noise(std::uint32_t seed) {
  Picture picture = filled_picture(30, 20, {});
  std::mt19937 random(seed);
  for (std::uint8_t& sample : picture.samples) sample = static_cast<std::uint8_t>(random());
  return picture;
}

struct MadeUp {
  std::vector<Record> records;
  std::vector<PictureRow> rows;

  void add(const std::string& scene, double degrees, const std::string& technique) {
    const auto seed = static_cast<std::uint32_t>(10 * rows.size());
    Record record;
    record.scene = scene;
    record.light_degrees = degrees;
    record.title = technique;
    record.metrics.rmse_penumbra = 0.125;
    record.metrics.fetches_mean = 40.0;
    record.metrics.preprocess_fetches_per_pixel = 2.5;
    records.push_back(record);
    PictureRow row;
    row.scene = scene;
    row.technique = technique;
    row.light_degrees = degrees;
    row.reference = noise(1000 + static_cast<std::uint32_t>(degrees));
    row.result = noise(seed + 1);
    row.error = noise(seed + 2);
    row.fetches = noise(seed + 3);
    rows.push_back(row);
  }
};

// The line is drawn alone, and found again in the sheet.
bool holds_text(const Picture& sheet, const std::string& line, int text_size = kTextSize) {
  const int width = caption_width(line, text_size);
  const Picture alone = compose({{line, filled_picture(width, 1, {255, 255, 255}), {}}}, 1, 0, text_size);
  return occurrences(sheet, cropped(alone, {8, 8, width, text_size})) > 0;
}

TEST(ContactSheet, HoldsTheReferenceOncePerLightAndEveryResult) {
  MadeUp study;
  for (const double degrees : {2.0, 5.0}) {
    for (const char* technique : {"a", "b"}) study.add("boxes", degrees, technique);
  }
  const Picture sheet = contact_sheet(study.records, study.rows, {});
  EXPECT_EQ(occurrences(sheet, study.rows[0].reference), 1);
  EXPECT_EQ(occurrences(sheet, study.rows[2].reference), 1);
  for (const PictureRow& row : study.rows) {
    EXPECT_EQ(occurrences(sheet, row.result), 1);
    EXPECT_EQ(occurrences(sheet, row.error), 0) << "nobody asked for it";
  }
}

TEST(ContactSheet, ARecordsSheetHasItsFourPicturesEnlargedForTheLegends) {
  MadeUp study;
  study.add("boxes", 2.0, "a");
  const PictureRow& row = study.rows[0];
  const Picture sheet = record_sheet(study.records[0], row);
  for (const PackedPicture* picture : {&row.reference, &row.result, &row.error, &row.fetches})
    EXPECT_EQ(occurrences(sheet, enlarged(*picture, 15)), 1);
  EXPECT_EQ(sheet.width / (30 * 15), 2) << "columns";
}

TEST(ContactSheet, ALightTakesARow) {
  MadeUp study;
  for (const double degrees : {2.0, 5.0}) {
    for (const char* technique : {"a", "b"}) study.add("boxes", degrees, technique);
  }
  const Picture rows = contact_sheet(study.records, study.rows, {});
  const Picture one = contact_sheet(study.records, study.rows, {.columns = 6});
  EXPECT_EQ(rows.width - 8, (one.width - 8) / 2) << "three cells of six, and a margin";
  EXPECT_GT(rows.height, one.height);
}

TEST(ContactSheet, ShowsADebugViewOfThoseThatHaveIt) {
  MadeUp study;
  for (const char* technique : {"over the screen", "a function"}) study.add("boxes", 2.0, technique);
  study.rows[0].debug_views["Cascades"] = noise(77);
  study.rows[0].debug_views["PenumbraWidth"] = noise(78);
  const Picture sheet =
      contact_sheet(study.records, study.rows, {.pictures = {{SheetPicture::debug_view, "Cascades"}}});
  EXPECT_EQ(occurrences(sheet, noise(77)), 1);
  EXPECT_EQ(occurrences(sheet, noise(78)), 0) << "nobody asked for it";
  EXPECT_EQ(sheet, contact_sheet({study.records[0]}, {study.rows[0]},
                                 {.pictures = {{SheetPicture::debug_view, "Cascades"}}}))
      << "the function has no cell";
}

TEST(ContactSheet, NamesADebugViewAsTheInspectorDoes) {
  MadeUp study;
  study.add("boxes", 2.0, "a");
  study.rows[0].debug_views["PenumbraWidth"] = noise(78);
  const Picture sheet =
      contact_sheet(study.records, study.rows, {.pictures = {{SheetPicture::debug_view, "PenumbraWidth"}}});
  EXPECT_TRUE(holds_text(sheet, "Penumbra Width"));
  EXPECT_FALSE(holds_text(sheet, "PenumbraWidth"));
}

TEST(ContactSheet, ShowsTheWindowZoomed) {
  MadeUp study;
  study.add("boxes", 2.0, "a");
  const PictureWindow window{4, 3, 10, 8};
  const Picture sheet = contact_sheet(study.records, study.rows, {.window = window, .zoom = 4});
  EXPECT_EQ(occurrences(sheet, enlarged(cropped(study.rows[0].result, window), 4)), 1);
  EXPECT_EQ(occurrences(sheet, study.rows[0].result), 0);
  EXPECT_THROW(contact_sheet(study.records, study.rows, {.window = PictureWindow{25, 0, 10, 8}}),
               std::invalid_argument);
}

TEST(ContactSheet, InsetsStandBeneathEveryPicture) {
  MadeUp study;
  study.add("boxes", 2.0, "a");
  const PictureWindow window{2, 2, 26, 16};
  const PictureWindow inset{6, 5, 5, 4};
  const Picture sheet =
      contact_sheet(study.records, study.rows, {.window = window, .insets = {inset}, .zoom = 2});
  for (const PackedPicture& picture : {study.rows[0].reference, study.rows[0].result}) {
    EXPECT_EQ(occurrences(sheet, enlarged(cropped(picture, inset), (52 - 8) / 5)), 1);
  }
}

TEST(ContactSheet, TheReferenceStandsWhereItIsAskedTo) {
  MadeUp study;
  for (const char* technique : {"a", "b"}) study.add("boxes", 2.0, technique);
  const auto column_of = [&](bool last) {
    const Picture sheet = contact_sheet(study.records, study.rows, {.reference_last = last, .columns = 3});
    EXPECT_EQ(occurrences(sheet, study.rows[0].reference), 1);
    return occurrences(cropped(sheet, {0, 0, sheet.width / 3, sheet.height}), study.rows[0].reference);
  };
  EXPECT_EQ(column_of(false), 1);
  EXPECT_EQ(column_of(true), 0);
}

TEST(ContactSheet, ShowsWhatIsAskedForAndAMaskOnlyWhereThereIsOne) {
  MadeUp study;
  study.add("boxes", 2.0, "a");
  study.add("boxes", 2.0, "b");
  study.rows[1].mask = noise(77);
  study.records[1].metrics.mask = MaskShares{0.25, 0.001};
  const Picture sheet =
      contact_sheet(study.records, study.rows,
                    {.pictures = {SheetPicture::error, SheetPicture::fetches, SheetPicture::mask}});
  for (const PictureRow& row : study.rows) {
    EXPECT_EQ(occurrences(sheet, row.error), 1);
    EXPECT_EQ(occurrences(sheet, row.fetches), 1);
    EXPECT_EQ(occurrences(sheet, row.result), 0);
  }
  EXPECT_EQ(occurrences(sheet, study.rows[1].mask), 1);
}

// The caption has the error, and the fetches of all passes together.
TEST(ContactSheet, CaptionsHoldNameErrorAndFetches) {
  MadeUp study;
  study.add("boxes", 2.0, "blockerSamples=4");
  const Picture sheet = contact_sheet(study.records, study.rows, {.zoom = 14});
  for (const char* line :
       {"Ray traced", "boxes, light of 2°", "blockerSamples=4", "penumbra error 0.125, 42.5 fetches"}) {
    EXPECT_TRUE(holds_text(sheet, line)) << line;
  }
  study.records[0].metrics.rmse_penumbra.reset();
  const Picture lit = contact_sheet(study.records, study.rows, {});
  EXPECT_NE(lit, sheet) << "no penumbra to be wrong in";
}

// A cell has 240 pixels, the least there is, and 8 lie between cells.
TEST(ContactSheet, ALongCaptionIsBrokenAndTheCellKeepsItsWidth) {
  MadeUp study;
  study.add("boxes", 2.0, "PCSS 24+16 at half resolution, masked and denoised");
  const Picture sheet = contact_sheet(study.records, study.rows, {.zoom = 6});
  EXPECT_EQ(sheet.width, 2 * (240 + 8) + 8);
  for (const char* line : {"PCSS 24+16 at half", "resolution,", "masked and denoised",
                           "penumbra error 0.125,", "42.5 fetches"}) {
    EXPECT_TRUE(holds_text(sheet, line)) << line;
  }
}

// 420 pixels hold the figures in smaller letters, but not in the 28 that so wide a sheet would have.
TEST(ContactSheet, LettersAreALittleSmallerWhereThatKeepsALineWhole) {
  MadeUp study;
  for (const char* technique : {"a", "b", "c"}) study.add("boxes", 2.0, technique);
  const Picture sheet = contact_sheet(study.records, study.rows, {.zoom = 14});
  EXPECT_EQ(sheet.width, 4 * (420 + 8) + 8);
  const std::string line = "penumbra error 0.125, 42.5 fetches";
  int size = 28;
  while (caption_width(line, size) > 420 - size / 2) --size;
  EXPECT_LT(size, 28);
  EXPECT_TRUE(holds_text(sheet, line, size));
}

TEST(ContactSheet, RecordsAndPicturesGoTogether) {
  MadeUp study;
  EXPECT_THROW(contact_sheet({}, {}, {}), std::invalid_argument);
  study.add("boxes", 2.0, "a");
  EXPECT_THROW(contact_sheet(study.records, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
