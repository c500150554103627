#include "bake/baked_files.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "bake/height_file.h"
#include "input/input_error.h"
#include "input/text_line.h"
#include "platform/atomic_file.h"
#include "platform/hashed_fields.h"
#include "scene/image_file.h"

namespace penumbra::bake {
namespace {

[[noreturn]] void fail(png_structp /*png*/, png_const_charp message) {
  throw std::invalid_argument(std::string("libpng: ") + message);
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

void append(png_structp png, png_bytep data, png_size_t length) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), first, first + length);
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

using Json = nlohmann::ordered_json;

constexpr const char* kAngles = "horizon-angles";
constexpr const char* kDistances = "distance-field";
constexpr const char* kObjects = "distance-field-objects";
constexpr int kLargestPictureSide = 16384;

Json area_json(const Area& area) {
  return {{"corner_metres", {area.corner.x, area.corner.y}}, {"size_metres", {area.size.x, area.size.y}}};
}

Json box_json(const parameters::Bounds& box) {
  const glm::dvec3 size = box.maximum - box.minimum;
  return {{"corner_metres", {box.minimum.x, box.minimum.y, box.minimum.z}},
          {"size_metres", {size.x, size.y, size.z}}};
}

// The arrangement of the slices of one z in a picture, in columns and rows.
struct Slices {
  int columns = 0;
  int rows = 0;
};

Slices slices_of(const std::array<int, 3>& voxels) {
  const auto [width, height, slices] = voxels;
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(slices))));
  const int rows = (slices + columns - 1) / columns;
  if (columns * width > kLargestPictureSide || rows * height > kLargestPictureSide) {
    throw InputError(
        "",
        fmt::format("{} x {} x {} voxels are a picture of {} x {} texels, and {} per side can be read", width,
                    height, slices, columns * width, rows * height, kLargestPictureSide),
        "bake fewer voxels");
  }
  return {columns, rows};
}

// The picture's rows run from the top, as Unity's importer of 3D textures takes them.
std::vector<std::byte> picture_of(const std::array<int, 3>& voxels, const Slices& slices,
                                  const std::vector<std::uint16_t>& texels) {
  const auto [width, height, depth] = voxels;
  const std::size_t row_length = static_cast<std::size_t>(slices.columns) * static_cast<std::size_t>(width);
  std::vector<std::uint16_t> samples(row_length * static_cast<std::size_t>(slices.rows) *
                                     static_cast<std::size_t>(height));
  std::size_t next = 0;
  for (int z = 0; z < depth; ++z) {
    const int left = z % slices.columns * width, bottom = (slices.rows - 1 - z / slices.columns) * height;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        samples[static_cast<std::size_t>(bottom + y) * row_length + static_cast<std::size_t>(left + x)] =
            texels[next++];
  }
  return encode_png_16(slices.columns * width, slices.rows * height, 1, samples);
}

BakedFiles finished(Json json, BakedFiles files) {
  for (const auto& [name, bytes] : files.pictures)
    json[hashes_key][name] = platform::hash_of(platform::text_of(bytes));
  files.json = json.dump(2) + "\n";
  return files;
}

}  // namespace

void check_stem(const std::string& stem) {
  if (!is_one_line(stem))
    throw InputError(stem,
                     "has a line end, a control character or a byte that is not UTF-8, and the JSON file "
                     "names its pictures",
                     "choose a name of letters, digits and '-'");
}

BakedFiles baked_files(const HeightField& field, const std::string& stem) {
  check_height_field(field);
  const HeightRange range = range_of(field);
  BakedFiles files;
  const std::string picture = stem + ".png";
  files.pictures[picture] = encode_png_16(field.width, field.depth, 1, height_texels(field, range));
  Json json = {{"kind", height_field_kind}, {"version", baked_version}, {"picture", picture}};
  json["heights_metres"] = {range.low, range.high};
  json.update(area_json(field.area));
  json["samples_without_surface"] = field.holes;
  return finished(json, std::move(files));
}

BakedFiles baked_files(const HorizonAngles& angles, const std::string& stem) {
  BakedFiles files;
  Json json = {{"kind", kAngles}, {"version", baked_version}, {"pictures", Json::array()}};
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
  return finished(json, std::move(files));
}

BakedFiles baked_files(const DistanceField& field, const std::string& stem) {
  double largest = 0.0;
  for (const float metres : field.metres) largest = std::max(largest, std::abs(static_cast<double>(metres)));
  if (largest == 0.0) largest = 1.0;
  std::vector<std::uint16_t> texels;
  texels.reserve(field.metres.size());
  for (const float metres : field.metres)
    texels.push_back(as_16_bits(0.5 + 0.5 * static_cast<double>(metres) / largest));
  const Slices slices = slices_of(field.voxels);
  BakedFiles files;
  const std::string picture = stem + ".png";
  files.pictures[picture] = picture_of(field.voxels, slices, texels);
  Json json = {{"kind", kDistances}, {"version", baked_version}, {"picture", picture}};
  json["voxels"] = field.voxels;
  json["columns"] = slices.columns;
  json["rows"] = slices.rows;
  json["distances_metres"] = {-largest, largest};
  json.update(box_json(field.box));
  json["open_edges"] = field.open_edges;
  return finished(json, std::move(files));
}

BakedFiles baked_files(const ObjectFields& fields, const std::string& stem) {
  const Slices slices = slices_of(fields.voxels);
  BakedFiles files;
  const std::string picture = stem + ".png";
  files.pictures[picture] = picture_of(fields.voxels, slices, fields.texels());
  Json json = {{"kind", kObjects}, {"version", baked_version}, {"picture", picture}};
  json["voxels"] = fields.voxels;
  json["columns"] = slices.columns;
  json["rows"] = slices.rows;
  json["ground_triangles"] = fields.ground_triangles;
  json["flat_triangles"] = fields.flat_triangles;
  json["objects"] = Json::array();
  for (const ObjectField& object : fields.objects) {
    Json written = {{"first_voxel", object.first}, {"voxels", object.field.voxels}};
    written["distances_metres"] = {-object.largest_metres, object.largest_metres};
    written.update(box_json(object.field.box));
    written["triangles"] = object.triangles;
    written["parts"] = object.parts;
    written["open_edges"] = object.field.open_edges;
    written["too_thin"] = std::round(1e4 * object.thin_share) / 1e4;
    json["objects"].push_back(std::move(written));
  }
  return finished(json, std::move(files));
}

void write_baked_files(const BakedFiles& files, const std::filesystem::path& json) {
  std::vector<platform::FileContent> written;
  for (const auto& [name, bytes] : files.pictures)
    written.push_back({json.parent_path() / name, platform::text_of(bytes)});
  written.push_back({json, files.json});
  platform::write_files_atomically(written);
}

HeightField read_height_field(const std::filesystem::path& json, const scene::ReadingProcess& process) {
  const HeightFile file = read_height_file(json);
  const scene::HeightImage image = scene::read_height_image_apart(file.picture, std::nullopt, process);
  if (file.holes < 0 || static_cast<std::size_t>(file.holes) > image.samples.size())
    throw InputError(
        file.holes_at,
        fmt::format("{} of {} samples cannot be without a surface", file.holes, image.samples.size()),
        "bake it again");
  try {
    HeightField field = heights_of_image(image, file.area, file.range);
    field.holes = static_cast<std::size_t>(file.holes);
    return field;
  } catch (const InputError& error) {
    throw InputError(json.string(), error.what());
  }
}

std::vector<std::byte> encode_png_16(int width, int height, int channels,
                                     std::span<const std::uint16_t> samples) {
  const bool whole = width > 0 && height > 0 && (channels == 1 || channels == 4) &&
                     samples.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                           static_cast<std::size_t>(channels);
  if (!whole) throw std::invalid_argument("samples do not fit the picture's size");
  std::vector<std::byte> bytes;
  const Writer writer;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16,
               channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png, writer.info);
  const std::size_t row = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
  std::vector<png_byte> big_endian(2 * row);
  for (std::size_t y = static_cast<std::size_t>(height);
       y-- > 0;) {  // the file begins with the picture's top row
    for (std::size_t i = 0; i < row; ++i) {
      const unsigned sample = samples[y * row + i];
      big_endian[2 * i] = static_cast<png_byte>(sample >> 8U);
      big_endian[2 * i + 1] = static_cast<png_byte>(sample & 0xFFU);
    }
    png_write_row(writer.png, big_endian.data());
  }
  png_write_end(writer.png, writer.info);
  return bytes;
}

std::uint16_t as_16_bits(double share) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0));
}

HeightRange range_of(const HeightField& field) {
  const auto [low, high] = std::minmax_element(field.metres.begin(), field.metres.end());
  return {static_cast<double>(*low), static_cast<double>(*high > *low ? *high : *low + 1.0F)};
}

std::vector<std::uint16_t> height_texels(const HeightField& field, const HeightRange& range) {
  std::vector<std::uint16_t> texels;
  texels.reserve(field.metres.size());
  for (const float metres : field.metres)
    texels.push_back(as_16_bits((static_cast<double>(metres) - range.low) / (range.high - range.low)));
  return texels;
}

std::vector<std::uint16_t> angle_texels(const HorizonAngles& angles, int first) {
  const std::size_t count = angles.radians[0].size();
  std::vector<std::uint16_t> texels;
  texels.reserve(horizon_channels * count);
  for (std::size_t i = 0; i < count; ++i)
    for (int channel = 0; channel < horizon_channels; ++channel)
      texels.push_back(
          as_16_bits(static_cast<double>(angles.radians[static_cast<std::size_t>(first + channel)][i]) /
                     (std::numbers::pi / 2.0)));
  return texels;
}

}  // namespace penumbra::bake
