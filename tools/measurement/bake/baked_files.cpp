#include "bake/baked_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bake/png_16.h"
#include "bake/texels_16.h"
#include "input/input_error.h"
#include "input/located_json.h"
#include "platform/atomic_file.h"
#include "scene/height_image.h"

namespace penumbra::bake {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeights = "height-field";
constexpr const char* kAngles = "horizon-angles";
constexpr const char* kDistances = "distance-field";
constexpr int kLargestPictureSide = 16384;
constexpr int kVersion = 1;

Json area_json(const Area& area) {
  return {{"corner_metres", {area.corner.x, area.corner.y}}, {"size_metres", {area.size.x, area.size.y}}};
}

}  // namespace

BakedFiles baked_files(const HeightField& field, const std::string& stem) {
  check_height_field(field);
  const HeightRange range = range_of(field);
  BakedFiles files;
  const std::string picture = stem + ".png";
  files.pictures[picture] = encode_png_16(field.width, field.depth, 1, height_texels(field, range));
  Json json = {{"kind", kHeights}, {"version", kVersion}, {"picture", picture}};
  json["heights_metres"] = {range.low, range.high};
  json.update(area_json(field.area));
  files.json = json.dump(2) + "\n";
  return files;
}

BakedFiles baked_files(const HorizonAngles& angles, const std::string& stem) {
  BakedFiles files;
  Json json = {{"kind", kAngles}, {"version", kVersion}, {"pictures", Json::array()}};
  for (int first = 0; first < horizon_directions; first += horizon_channels) {
    const std::string picture = fmt::format("{}-{}.png", stem, first / horizon_channels);
    files.pictures[picture] =
        encode_png_16(angles.width, angles.depth, horizon_channels, angle_texels(angles, first));
    json["pictures"].push_back(picture);
  }
  json["directions_degrees"] = Json::array();
  for (int number = 0; number < horizon_directions; ++number)
    json["directions_degrees"].push_back(45 * number);
  json["angles_degrees"] = {0, 90};
  json.update(area_json(angles.area));
  files.json = json.dump(2) + "\n";
  return files;
}

BakedFiles baked_files(const DistanceField& field, const std::string& stem) {
  const auto [width, height, slices] = field.voxels;
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(slices))));
  const int rows = (slices + columns - 1) / columns;
  if (columns * width > kLargestPictureSide || rows * height > kLargestPictureSide) {
    throw InputError(
        "",
        fmt::format("{} x {} x {} voxels are a picture of {} x {} texels, and {} per side can be read", width,
                    height, slices, columns * width, rows * height, kLargestPictureSide),
        "bake fewer voxels");
  }
  double largest = 0.0;
  for (const float metres : field.metres) largest = std::max(largest, std::abs(static_cast<double>(metres)));
  if (largest == 0.0) largest = 1.0;
  const std::size_t row_length = static_cast<std::size_t>(columns) * static_cast<std::size_t>(width);
  std::vector<std::uint16_t> samples(row_length * static_cast<std::size_t>(rows) *
                                     static_cast<std::size_t>(height));
  for (int z = 0; z < slices; ++z) {
    const int left = z % columns * width, bottom = (rows - 1 - z / columns) * height;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        samples[static_cast<std::size_t>(bottom + y) * row_length + static_cast<std::size_t>(left + x)] =
            as_16_bits(0.5 + 0.5 * static_cast<double>(field.at(x, y, z)) / largest);
  }
  BakedFiles files;
  const std::string picture = stem + ".png";
  files.pictures[picture] = encode_png_16(columns * width, rows * height, 1, samples);
  const glm::dvec3 size = field.box.maximum - field.box.minimum;
  const Json json = {{"kind", kDistances},
                     {"version", kVersion},
                     {"picture", picture},
                     {"voxels", {width, height, slices}},
                     {"columns", columns},
                     {"rows", rows},
                     {"distances_metres", {-largest, largest}},
                     {"corner_metres", {field.box.minimum.x, field.box.minimum.y, field.box.minimum.z}},
                     {"size_metres", {size.x, size.y, size.z}},
                     {"open_edges", field.open_edges}};
  files.json = json.dump(2) + "\n";
  return files;
}

void write_baked_files(const BakedFiles& files, const std::filesystem::path& json) {
  for (const auto& [name, bytes] : files.pictures)
    platform::write_file_atomically(json.parent_path() / name, std::span<const std::byte>(bytes));
  platform::write_file_atomically(json, files.json);
}

HeightField read_height_field(const std::filesystem::path& json, const scene::ReadingProcess& process) {
  const LocatedJson document = LocatedJson::read(json);
  JsonObject object(document);
  if (const std::string kind = object.text("kind", ""); kind != kHeights) {
    object.fail("kind", fmt::format("'{}' is no {}", kind, kHeights), "penumbra bake heightfield writes one");
  }
  if (const int version = object.integer("version", 0); version != kVersion)
    object.fail("version", fmt::format("version {} of the format is unknown", version), "bake it again");
  const std::string picture = object.text("picture", "");
  const bool plain =
      !picture.empty() && std::filesystem::path(picture).filename() == picture && picture != "..";
  if (!plain) object.fail("picture", "must be the name of a file in the same folder");
  const std::vector<double> range = object.numbers("heights_metres", 2);
  const std::vector<double> corner = object.numbers("corner_metres", 2),
                            size = object.numbers("size_metres", 2);
  object.finish();
  const scene::HeightImage image =
      scene::read_height_image_apart(json.parent_path() / picture, std::nullopt, process);
  try {
    return heights_of_image(image, {{corner[0], corner[1]}, {size[0], size[1]}}, {range[0], range[1]});
  } catch (const InputError& error) {
    throw InputError(json.string(), error.what());
  }
}

}  // namespace penumbra::bake
