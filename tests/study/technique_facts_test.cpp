#include "study/technique_facts.h"

#include <gtest/gtest.h>

#include "study/synthetic_study.h"

namespace penumbra::study {
namespace {

using techniques::ExtentOf;
using techniques::GraphTexture;

Record record_with_map(int size, const char* format, int cascades) {
  Record record;
  record.map_size = size;
  record.map_format = format;
  record.cascades = cascades;
  return record;
}

GraphTexture texture(ExtentOf extent, const char* format, int divisor = 1) {
  GraphTexture made;
  made.name = "made";
  made.extent = extent;
  made.format = format;
  made.divisor = divisor;
  return made;
}

TEST(MapMebibytes, AreTheShadowMapsAlone) {
  EXPECT_EQ(map_mebibytes(record_with_map(2048, "D32", 4), {}), 16.0);
  EXPECT_EQ(map_mebibytes(record_with_map(2048, "D24", 4), {}), 16.0);
  EXPECT_EQ(map_mebibytes(record_with_map(2048, "D16", 1), {}), 8.0);
  EXPECT_EQ(map_mebibytes(record_with_map(2048, "D16", 2), {}), 4.0) << "two tiles beside each other";
}

TEST(MapMebibytes, CountTexturesOfTheMapAndOfTilesAndNotOfThePicture) {
  const Record record = record_with_map(2048, "D32", 4);  // the map has four tiles of 1024 x 1024
  EXPECT_EQ(map_mebibytes(record, {texture(ExtentOf::map, "rg32f")}), 16.0 + 32.0);
  EXPECT_EQ(map_mebibytes(record, {texture(ExtentOf::map, "rg16", 4)}), 16.0 + 1.0);
  EXPECT_EQ(map_mebibytes(record, {texture(ExtentOf::tile, "rgba16f")}), 16.0 + 4 * 8.0);
  EXPECT_EQ(map_mebibytes(record, {texture(ExtentOf::screen, "rgba32f")}), 16.0);
  GraphTexture fixed = texture(ExtentOf::fixed, "r8");
  fixed.size = {1024, 512, 2};
  EXPECT_EQ(map_mebibytes(record, {fixed}), 16.0 + 1.0) << "8 bits as declared, not as measured";
}

TEST(MapMebibytes, CountMipLevelsAndSamples) {
  const Record record = record_with_map(1024, "D32", 1);  // the map takes 4 MiB
  GraphTexture mips = texture(ExtentOf::map, "r32f");
  mips.mips = 2;
  EXPECT_EQ(map_mebibytes(record, {mips}), 4.0 + 4.0 + 1.0);
  mips.mips = 0;
  EXPECT_NEAR(map_mebibytes(record, {mips}), 4.0 + 4.0 * 4.0 / 3.0, 1e-5);
  GraphTexture samples = texture(ExtentOf::map, "r32f");
  samples.samples = 4;
  EXPECT_EQ(map_mebibytes(record, {samples}), 4.0 + 16.0);
}

TEST(TechniqueRows, HaveNoShadowMapWhereVolumesAreDrawn) {
  for (const auto& [name, fact] : facts_of(techniques::read_own_techniques()))
    EXPECT_EQ(fact.has_shadow_map, name != "shadow-volume") << name;
  FactsOfTechniques facts;
  facts["bilinear"].has_shadow_map = false;
  for (const TechniqueRow& row : technique_rows(synthetic::results(), facts))
    EXPECT_EQ(row.map_mebibytes == 0.0, row.choice.technique == "bilinear");
}

TEST(TechniqueRows, HaveTheErrorUnderEachLightInRecordOrder) {
  const Results results = synthetic::results();
  EXPECT_TRUE(technique_rows(results, {}).empty());
  FactsOfTechniques facts;
  facts["bilinear"].use_when = "always";
  const std::vector<TechniqueRow> rows = technique_rows(results, facts);
  ASSERT_EQ(rows.size(), choices(results).size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].choice, choices(results)[i]);
    EXPECT_EQ(rows[i].use_when, rows[i].choice.technique == "bilinear" ? "always" : "");
  }
  for (const SummaryLine& line : summarise(results)) {
    const std::size_t light = line.light_degrees == 0.53 ? 0 : 1;
    for (const TechniqueRow& row : rows) {
      if (row.choice != line.choice) continue;
      EXPECT_EQ(row.rmse_penumbra.at(light)->value, line.rmse_penumbra->value);
      if (line.light_degrees != middle_light(results)) continue;
      EXPECT_EQ(row.fetches->value, line.fetches->value);
    }
  }
}

}  // namespace
}  // namespace penumbra::study
