#include "scene/gltf_ranges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/text_file.h"

namespace penumbra::scene {
namespace {

using Json = nlohmann::json;
using Pointer = LocatedJson::Pointer;

constexpr std::string_view kContainer = "glTF";
constexpr std::string_view kBodyOfGltf1 = "binary_glTF";  // the reserved buffer, whose uri is not read
constexpr std::streamoff kContainerHead = 20;  // magic, version and length; length and type of the JSON
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 40U;
constexpr const char* kRemedy = "the file is damaged or made to mislead: export it again";

// Returns the length of a container's JSON. Both versions have the length at the same place.
std::uint64_t json_length(std::ifstream& stream) {
  std::array<unsigned char, kContainerHead> head{};
  stream.seekg(0).read(reinterpret_cast<char*>(head.data()), kContainerHead);
  std::uint64_t length = 0;
  for (std::size_t i = 0; stream && i < 4; ++i) length |= std::uint64_t{head[12 + i]} << (8 * i);
  return length;
}

struct GltfJson {
  std::string text;
  bool in_container = false;
};

// Returns nothing where the file is no glTF.
std::optional<GltfJson> json_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(kContainer.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == kContainer) {
    const std::uint64_t length = json_length(stream);
    std::error_code error;
    if (!stream || length + kContainerHead > std::filesystem::file_size(file, error) || error ||
        length > kLargestTextFile)
      throw InputError(file.string(), "cannot be read: it is shorter than its head says", kRemedy);
    std::string json(length, '\0');
    stream.read(json.data(), static_cast<std::streamsize>(length));
    return GltfJson{std::move(json), true};
  }
  stream.clear();
  stream.seekg(0);
  char first = ' ';
  while (stream && std::string_view(" \t\r\n").find(first) != std::string_view::npos) stream.get(first);
  if (!stream || first != '{') return std::nullopt;
  return GltfJson{read_found_text_file(file), false};
}

class RangeCheck {
 public:
  RangeCheck(const LocatedJson& document, bool in_container)
      : document_(document), in_container_(in_container) {}

  void run() const {
    each("buffers", [this](const Pointer& at) { check_buffer(at); });
    each("bufferViews", [this](const Pointer& at) { check_view(at); });
    each("accessors", [this](const Pointer& at) { check_accessor(at); });
  }

 private:
  // The entries are a list in glTF 2, and an object of named entries in glTF 1.
  template <typename Check>
  void each(const std::string& kind, Check check) const {
    const Json& root = document_.value();
    if (!root.is_object() || !root.contains(kind)) return;
    const Json& entries = root.at(kind);
    if (entries.is_array())
      for (std::size_t i = 0; i < entries.size(); ++i) check(Pointer("/" + kind) / i);
    else if (entries.is_object())
      for (const auto& entry : entries.items()) check(Pointer("/" + kind) / entry.key());
  }

  const Json* member(const Pointer& at, const std::string& key) const {
    const Json& object = document_.at(at);
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  // Returns 0 where the number is absent.
  std::uint64_t number(const Pointer& at, const std::string& key) const {
    const Json* value = member(at, key);
    if (value == nullptr) return 0;
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() > kMostBytes)
      refuse(at / key, "'" + key + "' is not a whole number of at most 2^40");
    return value->get<std::uint64_t>();
  }

  // Returns the entry that "buffer" or "bufferView" names, or nothing where there is none; the library
  // refuses such a file or fills it with zeros.
  std::optional<Pointer> referred(const Pointer& at, const std::string& key, const std::string& kind) const {
    const Json* reference = member(at, key);
    const Json& root = document_.value();
    if (reference == nullptr || !root.contains(kind)) return std::nullopt;
    const Json& entries = root.at(kind);
    if (reference->is_string() && entries.is_object() && entries.contains(reference->get<std::string>()))
      return Pointer("/" + kind) / reference->get<std::string>();
    if (reference->is_number_unsigned() && entries.is_array() &&
        reference->get<std::uint64_t>() < entries.size())
      return Pointer("/" + kind) / reference->get<std::size_t>();
    return std::nullopt;
  }

  void check_buffer(const Pointer& at) const {
    const std::uint64_t length = number(at, "byteLength");
    const Json* uri = member(at, "uri");
    if (uri == nullptr || !uri->is_string() || (in_container_ && at.back() == kBodyOfGltf1)) return;
    const std::string_view text = uri->get_ref<const std::string&>();
    if (!text.starts_with("data:")) return;  // a file's length is checked by the library
    const std::string_view head = text.substr(0, text.find(','));
    std::string_view data = text.substr(std::min(head.size() + 1, text.size()));
    std::uint64_t embedded = data.size();
    if (head.ends_with(";base64")) {
      while (data.ends_with('=')) data.remove_suffix(1);
      embedded = data.size() * 3 / 4;
    }
    if (length > embedded)
      refuse(at, "the buffer says that it has " + std::to_string(length) + " bytes, and has " +
                     std::to_string(embedded));
  }

  void require_inside(const Pointer& at, const std::string& what, std::uint64_t end, const std::string& of,
                      std::uint64_t length) const {
    if (end > length)
      refuse(at, "the " + what + " ends at byte " + std::to_string(end) + " of a " + of + " of " +
                     std::to_string(length) + " bytes");
  }

  void check_view(const Pointer& at) const {
    const std::uint64_t end = number(at, "byteOffset") + number(at, "byteLength");
    if (const std::optional<Pointer> buffer = referred(at, "buffer", "buffers"))
      require_inside(at, "view", end, "buffer", number(*buffer, "byteLength"));
  }

  void check_accessor(const Pointer& at) const {
    const std::uint64_t count = number(at, "count");
    check_elements(at, at, count, element_bytes(at));
    const Json* sparse = member(at, "sparse");
    if (sparse == nullptr) return;
    const std::uint64_t changed = number(at / "sparse", "count");
    if (member(at / "sparse", "indices") != nullptr)
      check_elements(at / "sparse" / "indices", at, changed, component_bytes(at / "sparse" / "indices"));
    if (member(at / "sparse", "values") != nullptr)
      check_elements(at / "sparse" / "values", at, changed, element_bytes(at));
  }

  // Checks `count` elements from the place that `at` names.
  void check_elements(const Pointer& at, const Pointer& accessor, std::uint64_t count,
                      std::uint64_t bytes) const {
    const std::optional<Pointer> view = referred(at, "bufferView", "bufferViews");
    const std::uint64_t offset = number(at, "byteOffset");
    if (!view || count == 0) return;
    std::uint64_t stride = std::max(number(*view, "byteStride"), number(accessor, "byteStride"));
    if (stride == 0) stride = bytes;
    if (stride > 0 && count > kMostBytes / stride)
      refuse(accessor, "the accessor has more elements than any buffer");
    require_inside(at, "accessor", offset + (count - 1) * stride + bytes, "view",
                   number(*view, "byteLength"));
  }

  std::uint64_t component_bytes(const Pointer& at) const {
    switch (number(at, "componentType")) {
      case 5120:
      case 5121:
        return 1;
      case 5122:
      case 5123:
        return 2;
      default:
        return 4;
    }
  }

  std::uint64_t element_bytes(const Pointer& at) const {
    static const std::map<std::string, std::uint64_t> components{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    const Json* type = member(at, "type");
    const auto found =
        type != nullptr && type->is_string() ? components.find(type->get<std::string>()) : components.end();
    return (found == components.end() ? 1 : found->second) * component_bytes(at);
  }

  [[noreturn]] void refuse(const Pointer& at, const std::string& problem) const {
    throw InputError(document_.where(at), problem, kRemedy);
  }

  const LocatedJson& document_;
  bool in_container_;
};

}  // namespace

void check_gltf_ranges(const std::filesystem::path& file) {
  const std::optional<GltfJson> json = json_of(file);
  if (!json) return;
  const LocatedJson document = LocatedJson::parse(json->text, file.string());
  RangeCheck(document, json->in_container).run();
}

}  // namespace penumbra::scene
