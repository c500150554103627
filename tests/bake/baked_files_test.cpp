// Files are read as they were written, and the numbers of the pictures mean what they should.
#include "bake/baked_files.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bake/made_fields.h"
#include "input/input_error_matcher.h"
#include "platform/atomic_file.h"
#include "reference/scratch_folder.h"

namespace penumbra::bake {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Area kCovered{{-30.0, 12.5}, {64.0, 48.0}};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(BakedFiles, AHeightFieldIsReadAgainToHalfAStep) {
  const reference::ScratchFolder folder;
  const HeightField field = rough_field(33, 17, kCovered, 5);
  const std::filesystem::path json = folder.path() / "hills.json";
  write_baked_files(baked_files(field, "hills"), json);
  const HeightField read = read_height_field(json, {});
  EXPECT_EQ(read.width, 33);
  EXPECT_EQ(read.depth, 17);
  EXPECT_EQ(read.area, kCovered);
  EXPECT_EQ(read.holes, 0U);
  const auto [low, high] = std::minmax_element(field.metres.begin(), field.metres.end());
  const double half_step = 0.5 * (*high - *low) / 65535.0;
  for (std::size_t i = 0; i < field.metres.size(); ++i)
    ASSERT_NEAR(read.metres[i], field.metres[i], half_step + 1e-6 * std::abs(field.metres[i])) << i;
}

TEST(BakedFiles, AHeightFieldKeepsItsNumberOfSamplesWithoutASurface) {
  const reference::ScratchFolder folder;
  HeightField field = rough_field(4, 3, kCovered, 2);
  field.holes = 12;
  const std::filesystem::path json = folder.path() / "holes.json";
  const BakedFiles files = baked_files(field, "holes");
  EXPECT_EQ(nlohmann::json::parse(files.json)["samples_without_surface"], 12);
  write_baked_files(files, json);
  EXPECT_EQ(read_height_field(json, {}).holes, 12U);
  std::string without = text_of(json);
  const std::string key = ",\n  \"samples_without_surface\": 12";
  ASSERT_NE(without.find(key), std::string::npos) << without;
  std::ofstream(json, std::ios::binary) << without.erase(without.find(key), key.size());
  EXPECT_EQ(read_height_field(json, {}).holes, 0U) << "the key may be absent";
}

TEST(BakedFiles, LevelGroundHasOneHeight) {
  const reference::ScratchFolder folder;
  const HeightField field = made_field(2, 3, kCovered, [](glm::dvec2) { return 7.25; });
  const std::filesystem::path json = folder.path() / "level.json";
  write_baked_files(baked_files(field, "level"), json);
  EXPECT_THAT(read_height_field(json, {}).metres, testing::Each(7.25F));
}

// Channel c of picture p holds direction 4 p + c.
TEST(BakedFiles, EachDirectionIsAChannelInStepsOfAQuarterTurn) {
  HorizonAngles angles{3, 2, kCovered, {}};
  for (int number = 0; number < horizon_directions; ++number)
    for (int i = 0; i < 6; ++i)
      angles.radians[static_cast<std::size_t>(number)].push_back(0.1F * static_cast<float>(number) +
                                                                 0.01F * static_cast<float>(i));
  const BakedFiles files = baked_files(angles, "hz");
  ASSERT_EQ(files.pictures.size(), 2U);
  for (int picture = 0; picture < 2; ++picture) {
    // Four channels are refused, because they are not heights.
    expect_input_error(
        [&] {
          scene::decode_height_image(files.pictures.at("hz-" + std::to_string(picture) + ".png"), "hz.png",
                                     {});
        },
        HasSubstr("4 channels"));
  }
  std::vector<std::uint16_t> samples;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t channel = 4; channel < 8; ++channel)
      samples.push_back(
          as_16_bits(static_cast<double>(angles.radians[channel][i]) / (std::acos(-1.0) / 2.0)));
  EXPECT_EQ(files.pictures.at("hz-1.png"), encode_png_16(3, 2, 4, samples));
  const nlohmann::json json = nlohmann::json::parse(files.json);
  EXPECT_EQ(json["pictures"], (nlohmann::json{"hz-0.png", "hz-1.png"}));
  EXPECT_EQ(json["directions_degrees"], (nlohmann::json{0, 45, 90, 135, 180, 225, 270, 315}));
  EXPECT_EQ(json["corner_metres"], (nlohmann::json{-30.0, 12.5}));
}

// The sheet is cut slice by slice as Unity's importer does it: from the top left corner, each with its
// smallest y at the bottom.
TEST(BakedFiles, ADistanceFieldIsASheetOfSlices) {
  DistanceField field{{3, 2, 5}, {{-1.0, -2.0, -3.0}, {2.0, 0.0, 2.0}}, {}, 4};
  for (int i = 0; i < 30; ++i) field.metres.push_back(0.1F * static_cast<float>(i - 10));
  const BakedFiles files = baked_files(field, "mesh");
  const nlohmann::json json = nlohmann::json::parse(files.json);
  EXPECT_EQ(json["columns"], 3);
  EXPECT_EQ(json["rows"], 2);
  EXPECT_EQ(json["voxels"], (nlohmann::json{3, 2, 5}));
  EXPECT_EQ(json["open_edges"], 4);
  EXPECT_EQ(json["size_metres"], (nlohmann::json{3.0, 2.0, 5.0}));
  const double largest = json["distances_metres"][1];
  EXPECT_FLOAT_EQ(static_cast<float>(largest), 1.9F);
  EXPECT_EQ(json["distances_metres"][0], -largest);
  const scene::HeightImage sheet = scene::decode_height_image(files.pictures.at("mesh.png"), "mesh.png", {});
  ASSERT_EQ(sheet.width, 9);
  ASSERT_EQ(sheet.height, 4);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) {
        const int column = 3 * (z % 3) + x, row = 2 * (1 - z / 3) + y;  // counted from the bottom
        const double share = sheet.samples[static_cast<std::size_t>(9 * row + column)] / 65535.0;
        EXPECT_NEAR((2.0 * share - 1.0) * largest, field.at(x, y, z), 1.01 * largest / 65535.0)
            << x << y << z;
      }
  EXPECT_NO_THROW(baked_files(DistanceField{{1, 1, 1}, field.box, {0.0F}, 0}, "point"));
  expect_input_error(
      [&] {
        baked_files(DistanceField{{512, 1, 1025}, field.box, {}, 0}, "wide");
      },
      HasSubstr("16384"));
}

TEST(BakedFiles, ABrokenFileIsNamedWithItsLine) {
  const reference::ScratchFolder folder;
  const std::filesystem::path json = folder.path() / "hills.json";
  const auto refuse = [&](const std::string& from, const std::string& to, const auto& says) {
    write_baked_files(baked_files(rough_field(4, 4, kCovered, 1), "hills"), json);
    std::string text = text_of(json);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(json, std::ios::binary) << text.replace(at, from.size(), to);
    expect_input_error([&] { read_height_field(json, {}); }, says);
  };
  refuse("\"kind\": \"height-field\",", "", HasSubstr("'kind' is missing"));
  refuse("height-field", "horizon-angles", HasSubstr("'horizon-angles' is not a height field"));
  refuse("height-field", "horizon-angles", AllOf(HasSubstr("hills.json:2"), HasSubstr("bake heightfield")));
  refuse("\"version\": 1", "\"version\": 2", HasSubstr("hills.json:3"));
  refuse("hills.png", "../hills.png", AllOf(HasSubstr("hills.json:4"), HasSubstr("same folder")));
  for (const char* end : {"\\u0000", "\\u0000.txt", "\\n", "\\u202E"})
    refuse("hills.png", std::string("hills.png") + end,
           AllOf(HasSubstr("hills.json:4"), HasSubstr("same folder")));
  refuse("hills.png", ".", AllOf(HasSubstr("hills.json:4"), HasSubstr("same folder")));
  refuse("hills.png", "absent.png", HasSubstr("absent.png"));
  refuse("heights_metres", "heights", HasSubstr("heights_metres"));
  refuse("64.0", "-64.0", AllOf(HasSubstr("hills.json"), HasSubstr("cannot cover")));
  refuse("64.0", "1e999", HasSubstr("hills.json:"));
  for (const char* count : {"-1", "17"})
    refuse("\"samples_without_surface\": 0", std::string("\"samples_without_surface\": ") + count,
           AllOf(HasSubstr("hills.json:"), HasSubstr(std::string(count) + " of 16 samples")));
}

// Such a pair is left where a machine stops between the two, or a person copies one of them.
TEST(BakedFiles, APictureOfAnotherBakeIsRefused) {
  const reference::ScratchFolder folder;
  const std::filesystem::path json = folder.path() / "hills.json";
  write_baked_files(baked_files(rough_field(4, 4, kCovered, 1), "hills"), json);
  EXPECT_NO_THROW(read_height_field(json, {}));
  const BakedFiles other = baked_files(rough_field(4, 4, kCovered, 2), "hills");
  platform::write_file_atomically(folder.path() / "hills.png",
                                  std::span<const std::byte>(other.pictures.at("hills.png")));
  expect_input_error(
      [&] { read_height_field(json, {}); },
      AllOf(HasSubstr("hills.png: does not belong to"), HasSubstr("hills.json"), HasSubstr("bake it again")));
  std::ofstream(json, std::ios::binary) << other.json;
  EXPECT_NO_THROW(read_height_field(json, {}));
  nlohmann::json without = nlohmann::json::parse(other.json);
  without.erase("picture_hashes");
  std::ofstream(json, std::ios::binary) << without;
  expect_input_error([&] { read_height_field(json, {}); },
                     AllOf(HasSubstr("hills.json"), HasSubstr("no hash of 'hills.png'")));
}

TEST(BakedFiles, EveryPictureHasItsHash) {
  HorizonAngles angles{1, 1, kCovered, {}};
  for (std::vector<float>& radians : angles.radians) radians.push_back(0.5F);
  const nlohmann::json json = nlohmann::json::parse(baked_files(angles, "hz").json);
  EXPECT_EQ(json["picture_hashes"].size(), 2U);
  EXPECT_EQ(json["picture_hashes"]["hz-0.png"], json["picture_hashes"]["hz-1.png"])
      << "their content is equal";
}

TEST(BakedFiles, SamplesFitTheirPicture) {
  const std::vector<std::uint16_t> six(6);
  EXPECT_NO_THROW(encode_png_16(2, 3, 1, six));
  EXPECT_THROW(encode_png_16(2, 2, 1, six), std::invalid_argument);
  EXPECT_THROW(encode_png_16(1, 2, 3, six), std::invalid_argument);
  EXPECT_THROW(encode_png_16(0, 0, 1, {}), std::invalid_argument);
  EXPECT_EQ(as_16_bits(-1.0), 0);
  EXPECT_EQ(as_16_bits(0.5), 32768);
  EXPECT_EQ(as_16_bits(2.0), 65535);
}

}  // namespace
}  // namespace penumbra::bake
