#include "scene/model_file.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/text_file.h"
#include "scene/cut_out.h"

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

// A check of the ranges that a glTF file reads of its buffers. The importer library adds the offsets of a
// file without a check that the sum is inside: a large one wraps around, and bytes before or behind the
// buffer become vertices.

// Throws InputError, at the line, where a view lies outside of its buffer, an accessor outside of its view,
// or an embedded buffer is shorter than it says; also where the JSON is broken. It reads glTF 1 and 2, with
// JSON alone or in a container, whatever the file's name: the library also tries the contents of a file whose
// ending is another format's. Does nothing for other formats.
void check_gltf_ranges(const std::filesystem::path& file) {
  const std::optional<GltfJson> json = json_of(file);
  if (!json) return;
  const LocatedJson document = LocatedJson::parse(json->text, file.string());
  RangeCheck(document, json->in_container).run();
}

// The supported formats. All other loaders are removed: the importer library tries each of them on a file it
// does not recognise, and each might misinterpret garbage. OFF is not supported: its loader trusts the counts
// in a header, and a file of a few hundred bytes keeps it busy for minutes.
constexpr std::array<std::string_view, 8> kExtensions{"gltf", "glb", "obj", "3ds",
                                                      "ply",  "stl", "dae", "fbx"};

constexpr std::size_t kMostMaterials = 65'000;  // a triangle's material index has 16 bits

bool known(std::string_view extension) {
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem,
                         const std::string& remedy = {}) {
  throw InputError(file.string(), problem, remedy);
}

void check_readable(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) refuse(file, "no such file");
  if (error) refuse(file, error.message());
  if (std::filesystem::is_directory(status)) refuse(file, "is a folder, not a model", "choose a file in it");
  require_regular_file(file);
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) refuse(file, error.message());
  if (size == 0) refuse(file, "is empty");
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension.empty() || !known(std::string_view(extension).substr(1))) {
    std::string list;
    for (const std::string_view each : kExtensions) list += " ." + std::string(each);
    refuse(file, "is not a model format that can be read", "readable formats:" + list);
  }
}

void keep_known_loaders(Assimp::Importer& importer) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    const aiImporterDesc* description = importer.GetImporterInfo(i);
    std::string_view extensions = description->mFileExtensions;  // separated by blanks
    bool keep = false;
    while (!extensions.empty()) {
      const std::size_t end = std::min(extensions.find(' '), extensions.size());
      keep = keep || known(extensions.substr(0, end));
      extensions.remove_prefix(std::min(end + 1, extensions.size()));
    }
    if (!keep) others.push_back(importer.GetImporter(i));
  }
  // Unregistering leaves the loader's memory to the caller.
  for (Assimp::BaseImporter* loader : others) {
    importer.UnregisterLoader(loader);
    delete loader;
  }
}

std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "the importer gave no reason" : text;
}

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
  return {
      {m.a1, m.b1, m.c1, m.d1}, {m.a2, m.b2, m.c2, m.d2}, {m.a3, m.b3, m.c3, m.d3}, {m.a4, m.b4, m.c4, m.d4}};
}

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_material_count(const ModelMaterials& surface, const std::filesystem::path& file) {
  if (surface.materials.size() <= kMostMaterials) return;
  refuse(file, "has " + std::to_string(surface.materials.size()) + " materials; the limit is " +
                   std::to_string(kMostMaterials));
}

struct PlacedMesh {
  const aiMesh* mesh;
  glm::dmat4 to_model;
};

// Returns every mesh once for each node that shows it.
std::vector<PlacedMesh> placed_meshes(const aiScene& scene) {
  struct Visit {
    const aiNode* node;
    glm::dmat4 parent;
  };
  std::vector<PlacedMesh> placed;
  std::vector<Visit> stack{{scene.mRootNode, glm::dmat4(1.0)}};
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const glm::dmat4 to_model = visit.parent * matrix_of(visit.node->mTransformation);
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      placed.push_back({scene.mMeshes[visit.node->mMeshes[i]], to_model});
    }
    for (unsigned i = 0; i < visit.node->mNumChildren; ++i) {
      stack.push_back({visit.node->mChildren[i], to_model});
    }
  }
  return placed;
}

std::size_t triangles_in(const aiMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                                                [](const aiFace& face) { return face.mNumIndices == 3; }));
}

bool has_coordinates(const aiMesh& mesh, const ModelMaterials& surface) {
  const unsigned channel = surface.uv_channels.at(mesh.mMaterialIndex);
  return channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(channel);
}

// The importer counts rows from the bottom.
glm::dvec2 uv_of(const aiMesh& mesh, unsigned vertex, const ModelMaterials& surface) {
  if (!has_coordinates(mesh, surface)) return glm::dvec2(0.0);
  const aiVector3D& uv = mesh.mTextureCoords[surface.uv_channels[mesh.mMaterialIndex]][vertex];
  const glm::vec2 from_top(uv.x, 1.0F - uv.y);
  const bool usable = std::abs(from_top.x) <= kLargestTexCoord && std::abs(from_top.y) <= kLargestTexCoord;
  return usable ? glm::dvec2(from_top) : glm::dvec2(0.0);
}

bool reads_coordinates(const Material& material) {
  return material.cut_out && material.cut_out->reads_coordinates();
}

// The materials of meshes without texture coordinates: for each of the file's, one that is not cut out. It is
// made when first needed.
class SolidMaterials {
 public:
  SolidMaterials(ModelMaterials& surface, const std::filesystem::path& file)
      : surface_(surface), file_(file) {}

  std::size_t material_of(const aiMesh& mesh) {
    const std::size_t index = mesh.mMaterialIndex;
    if (!reads_coordinates(surface_.materials.at(index)) || has_coordinates(mesh, surface_)) return index;
    const auto [known, is_new] = solid_.try_emplace(index, surface_.materials.size());
    if (!is_new) return known->second;
    Material solid = surface_.materials[index];
    surface_.notes.push_back(file_.string() + ": mesh '" + mesh.mName.C_Str() + "' is solid: material '" +
                             solid.name + "' cuts it out and it has no texture coordinates");
    solid.cut_out.reset();
    surface_.materials.push_back(std::move(solid));
    surface_.uv_channels.push_back(surface_.uv_channels[index]);
    check_material_count(surface_, file_);
    return known->second;
  }

 private:
  ModelMaterials& surface_;
  const std::filesystem::path& file_;
  std::map<std::size_t, std::size_t> solid_;
};

void append_vertices(ModelFile& model, const PlacedMesh& placed, const std::filesystem::path& file) {
  const aiMesh& mesh = *placed.mesh;
  const glm::dmat3 linear(placed.to_model);
  // A singular transform flattens the mesh; its normals are then derived from the faces.
  const bool normals = mesh.HasNormals() && glm::determinant(linear) != 0.0;
  const glm::dmat3 to_normal = normals ? glm::transpose(glm::inverse(linear)) : glm::dmat3(0.0);
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    const glm::dvec3 position(placed.to_model * glm::dvec4(p.x, p.y, p.z, 1.0));
    if (!finite(position)) {
      refuse(file, "vertex " + std::to_string(i) + " of mesh '" + std::string(mesh.mName.C_Str()) +
                       "' is not finite");
    }
    glm::dvec3 normal(0.0);
    if (normals) {
      const aiVector3D& n = mesh.mNormals[i];
      const glm::dvec3 turned = to_normal * glm::dvec3(n.x, n.y, n.z);
      const double length = glm::length(turned);
      if (std::isfinite(length) && length > 1e-12) normal = turned / length;
    }
    model.positions.push_back(position);
    model.normals.push_back(normal);
    model.uvs.push_back(uv_of(mesh, i, model.surface));
    model.has_uvs = model.has_uvs || model.uvs.back() != glm::dvec2(0.0);
  }
  model.has_uvs = model.has_uvs || reads_coordinates(model.surface.materials.at(mesh.mMaterialIndex));
}

struct TrianglesOf {
  std::size_t first_vertex;
  std::size_t material;
};

void append_triangles(ModelFile& model, const PlacedMesh& placed, const TrianglesOf& of,
                      const std::filesystem::path& file) {
  const aiMesh& mesh = *placed.mesh;
  const bool mirrored = glm::determinant(glm::dmat3(placed.to_model)) < 0.0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines cast no shadow
    for (const unsigned corner : {0U, mirrored ? 2U : 1U, mirrored ? 1U : 2U}) {
      const unsigned index = face.mIndices[corner];
      if (index >= mesh.mNumVertices) {
        refuse(file, "face " + std::to_string(i) + " of mesh '" + std::string(mesh.mName.C_Str()) +
                         "' refers to vertex " + std::to_string(index) + " of " +
                         std::to_string(mesh.mNumVertices));
      }
      model.indices.push_back(static_cast<std::uint32_t>(of.first_vertex + index));
    }
    model.triangle_materials.push_back(static_cast<std::uint16_t>(of.material));
  }
}

}  // namespace

ModelFile read_model_file(const std::filesystem::path& file, std::size_t triangle_limit) {
  check_readable(file);
  check_gltf_ranges(file);
  Assimp::Importer importer;
  auto* folder = new ModelFolder(file);
  importer.SetIOHandler(folder);  // the importer owns it
  keep_known_loaders(importer);
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate);
  if (!folder->refused().empty())
    refuse(file, "names the file '" + folder->refused() + "', which lies outside the model's folder",
           "copy it beside the model, and name it there");
  const std::string missing = folder->missing().empty() ? "" : folder->missing().front();
  if (scene == nullptr || scene->mRootNode == nullptr) {
    if (!missing.empty())
      refuse(file, "names the file '" + missing + "', which is not there", "put it beside the model");
    refuse(file, "cannot be read: " + one_line(importer.GetErrorString()));
  }
  const std::vector<PlacedMesh> meshes = placed_meshes(*scene);
  std::size_t triangles = 0, vertices = 0;
  for (const PlacedMesh& placed : meshes) {
    triangles += triangles_in(*placed.mesh);
    vertices += placed.mesh->mNumVertices;
  }
  if (triangles == 0) refuse(file, "has no triangles");
  if (triangles > triangle_limit || vertices > 3 * triangle_limit) {
    refuse(file,
           "has " + std::to_string(triangles) + " triangles and " + std::to_string(vertices) +
               " vertices; the limit is " + std::to_string(triangle_limit) +
               " triangles and three times as many vertices",
           "reduce it, or cut out the part whose shadows matter");
  }
  ModelFile model;
  model.surface = read_model_materials(*scene, file);
  if (!missing.empty())
    model.surface.notes.push_back(file.string() + ": names the file '" + missing +
                                  "', which is not there; what it has is left out");
  check_material_count(model.surface, file);
  SolidMaterials solid(model.surface, file);
  for (const PlacedMesh& placed : meshes) {
    const std::size_t first = model.positions.size();
    append_vertices(model, placed, file);
    append_triangles(model, placed, {first, solid.material_of(*placed.mesh)}, file);
  }
  return model;
}

}  // namespace penumbra::scene
