#include "bake/height_file.h"

#include <fmt/format.h>

#include <vector>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/text_file.h"
#include "input/text_line.h"
#include "platform/hashed_fields.h"

namespace penumbra::bake {
namespace {

constexpr std::size_t kLargestPicture = std::size_t{512} << 20U;  // bytes

// Throws InputError where the picture beside the JSON file is not the one that the file was written with.
void check_picture(JsonObject& object, const std::filesystem::path& json, const std::string& picture) {
  JsonObject hashes = object.object(hashes_key);
  const std::string expected = hashes.text(picture, "");
  if (expected.empty())
    hashes.fail(picture, fmt::format("there is no hash of '{}' in '{}'", picture, hashes_key),
                "bake it again");
  hashes.finish();
  const std::filesystem::path file = json.parent_path() / picture;
  if (platform::hash_of(read_found_text_file(file, kLargestPicture)) != expected)
    throw InputError(
        file.string(),
        fmt::format("does not belong to '{}', which was written with another picture", json.string()),
        "bake it again, or copy both files of one bake");
}

}  // namespace

HeightFile read_height_file(const std::filesystem::path& json) {
  const LocatedJson document = LocatedJson::read_found(json);
  JsonObject object(document);
  if (const std::string kind = object.text("kind", ""); kind != height_field_kind) {
    object.fail("kind",
                kind.empty()
                    ? fmt::format("'kind' is missing, which is \"{}\" in a height field", height_field_kind)
                    : fmt::format("'{}' is not a height field", kind),
                "penumbra bake heightfield writes one");
  }
  if (const int version = object.integer("version", 0); version != baked_version)
    object.fail("version", fmt::format("version {} of the format is unknown", version), "bake it again");
  const std::string picture = object.text("picture", "");
  const bool plain = is_one_line(picture) && !picture.empty() &&
                     std::filesystem::path(picture).filename() == picture && picture != ".." &&
                     picture != ".";
  if (!plain) object.fail("picture", "must be the name of a file in the same folder");
  const std::vector<double> range = object.numbers("heights_metres", 2);
  const std::vector<double> corner = object.numbers("corner_metres", 2),
                            size = object.numbers("size_metres", 2);
  const int holes = object.integer("samples_without_surface", 0);
  check_picture(object, json, picture);
  object.finish();
  return {json.parent_path() / picture,
          {range[0], range[1]},
          {{corner[0], corner[1]}, {size[0], size[1]}},
          holes,
          object.where("samples_without_surface")};
}

}  // namespace penumbra::bake
