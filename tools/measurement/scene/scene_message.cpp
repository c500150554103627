#include "scene/scene_message.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/image_file.h"

namespace penumbra::scene {

using platform::ByteReader;
using platform::ByteWriter;

namespace {

void require(bool holds, const char* problem) {
  if (!holds) throw std::invalid_argument(problem);
}

template <typename Vector>
bool all_finite(const std::vector<Vector>& list) {
  return std::all_of(list.begin(), list.end(), [](const Vector& vector) {
    for (int i = 0; i < Vector::length(); ++i)
      if (!std::isfinite(vector[i])) return false;
    return true;
  });
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The functions here and below bind all members: adding a member to a struct breaks the build until it is
// serialised, too.
void write(ByteWriter& out, const Texture& texture) {
  const auto& [width, height, rgba] = texture;
  out.value(width);
  out.value(height);
  out.values(rgba);
}

Texture read_texture(ByteReader& in) {
  Texture texture;
  texture.width = in.value<int>();
  texture.height = in.value<int>();
  texture.rgba = in.values<std::uint8_t>();
  const auto fits = [](int side) { return side > 0 && side <= kLargestImageSide; };
  require(fits(texture.width) && fits(texture.height), "a texture whose size is out of range");
  require(texture.rgba.size() == std::size_t{4} * static_cast<std::size_t>(texture.width) *
                                     static_cast<std::size_t>(texture.height),
          "a texture without all of its pixels");
  return texture;
}

void write(ByteWriter& out, const CutOut& cut_out) {
  const auto& [pattern, texture, channel, wrap_u, wrap_v, factor, cutoff, mode] = cut_out;
  out.number(static_cast<std::uint64_t>(pattern));
  out.value(texture);
  out.number(static_cast<std::uint64_t>(channel));
  out.number(static_cast<std::uint64_t>(wrap_u));
  out.number(static_cast<std::uint64_t>(wrap_v));
  out.value(factor);
  out.value(cutoff);
  out.number(static_cast<std::uint64_t>(mode));
}

CutOut read_cut_out(ByteReader& in) {
  CutOut cut_out;
  cut_out.pattern = in.enumerator(AlphaPattern::smoke);
  cut_out.texture = in.value<int>();
  cut_out.channel = in.enumerator(TextureChannel::alpha);
  cut_out.wrap_u = in.enumerator(TextureWrap::clamp);
  cut_out.wrap_v = in.enumerator(TextureWrap::clamp);
  cut_out.factor = in.value<float>();
  cut_out.cutoff = in.value<float>();
  cut_out.mode = in.enumerator(AlphaMode::blended);
  require(std::isfinite(cut_out.factor) && std::isfinite(cut_out.cutoff),
          "a cut-out with a number that is not finite");
  return cut_out;
}

void write(ByteWriter& out, const Material& material) {
  const auto& [name, base_colour, roughness, base_colour_texture, normal_texture, translucency, cut_out] =
      material;
  out.text(name);
  out.value(base_colour);
  out.value(roughness);
  out.value(base_colour_texture);
  out.value(normal_texture);
  out.value(translucency);
  out.number(cut_out ? 1 : 0);
  if (cut_out) write(out, *cut_out);
}

Material read_material(ByteReader& in) {
  Material material;
  material.name = in.text();
  material.base_colour = in.value<glm::vec3>();
  material.roughness = in.value<float>();
  material.base_colour_texture = in.value<int>();
  material.normal_texture = in.value<int>();
  material.translucency = in.value<float>();
  if (in.flag()) material.cut_out = read_cut_out(in);
  require(is_finite(material.base_colour) && std::isfinite(material.roughness) &&
              std::isfinite(material.translucency),
          "a material with a number that is not finite");
  return material;
}

void write(ByteWriter& out, const Mesh& mesh) {
  const auto& [positions, normals, indices, uvs, triangle_materials] = mesh;
  out.values(positions);
  out.values(normals);
  out.values(indices);
  out.values(uvs);
  out.values(triangle_materials);
}

Mesh read_mesh(ByteReader& in) {
  Mesh mesh;
  mesh.positions = in.values<glm::vec3>();
  mesh.normals = in.values<glm::vec3>();
  mesh.indices = in.values<std::uint32_t>();
  mesh.uvs = in.values<glm::vec2>();
  mesh.triangle_materials = in.values<std::uint16_t>();
  return mesh;
}

void check(const Mesh& mesh, std::size_t materials) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.normals.size() == vertices && (mesh.uvs.empty() || mesh.uvs.size() == vertices) &&
              mesh.indices.size() % 3 == 0 &&
              (mesh.triangle_materials.empty() || mesh.triangle_materials.size() == mesh.triangle_count()),
          "a mesh whose arrays differ in length");
  require(all_finite(mesh.positions) && all_finite(mesh.normals) && all_finite(mesh.uvs),
          "a vertex that is not finite");
  require(std::all_of(mesh.indices.begin(), mesh.indices.end(),
                      [vertices](std::uint32_t index) { return index < vertices; }),
          "a triangle with a vertex index out of range");
  require(std::all_of(mesh.triangle_materials.begin(), mesh.triangle_materials.end(),
                      [materials](std::uint16_t material) { return material < materials; }),
          "a triangle with a material index out of range");
}

void check(const Scene& scene) {
  require(!scene.materials.empty(), "a scene without materials");
  check(scene.mesh, scene.materials.size());
  const auto textures = static_cast<int>(scene.textures.size());
  for (const Material& material : scene.materials) {
    const int cut_out_texture = material.cut_out ? material.cut_out->texture : -1;
    for (const int texture : {material.base_colour_texture, material.normal_texture, cut_out_texture})
      require(texture >= -1 && texture < textures, "a material with a texture index out of range");
    require(!material.cut_out || !material.cut_out->reads_coordinates() || !scene.mesh.uvs.empty(),
            "a cut-out without texture coordinates");
  }
  const parameters::Camera& camera = scene.camera;
  for (const glm::dvec3& v :
       {scene.origin, camera.position, camera.forward, camera.up, scene.light_direction})
    require(is_finite(v), "a position or direction that is not finite");
  for (const double number : {camera.fov_y_degrees, camera.aspect, camera.near_plane, camera.far_plane,
                              scene.shadow_distance_metres})
    require(std::isfinite(number) && number > 0.0, "a camera value that is not positive and finite");
}

}  // namespace

void write(ByteWriter& out, const ImportOptions& options) {
  const auto& [metres_per_unit, z_up, minus_z_up, height_metres, ground, triangle_limit, process] = options;
  out.value(metres_per_unit);
  out.number(z_up ? 1 : 0);
  out.number(minus_z_up ? 1 : 0);
  out.value(height_metres);
  out.number(ground ? 1 : 0);
  out.number(triangle_limit);
}

ImportOptions read_import_options(ByteReader& in) {
  ImportOptions options;
  options.metres_per_unit = in.value<double>();
  options.z_up = in.flag();
  options.minus_z_up = in.flag();
  options.height_metres = in.value<double>();
  options.ground = in.flag();
  options.triangle_limit = in.number();
  return options;
}

std::string encode(const Texture& texture) {
  ByteWriter out;
  write(out, texture);
  return out.take();
}

std::string encode(const Scene& scene) {
  const auto& [name, description, notes, mesh, materials, textures, origin, camera, light_direction,
               shadow_distance_metres, seen_distance_metres, ground_triangles, clouds] = scene;
  ByteWriter out;
  out.text(name);
  out.text(description);
  out.list(notes, [&](const std::string& note) { out.text(note); });
  write(out, mesh);
  out.list(materials, [&](const Material& material) { write(out, material); });
  out.list(textures, [&](const Texture& texture) { write(out, texture); });
  out.value(origin);
  out.value(camera);
  out.value(light_direction);
  out.value(shadow_distance_metres);
  out.value(seen_distance_metres);
  out.value(static_cast<std::uint64_t>(ground_triangles));
  out.number(clouds ? 1 : 0);
  if (clouds) out.value(*clouds);
  return out.take();
}

std::string encode(const HeightImage& image) {
  ByteWriter out;
  out.value(image.width);
  out.value(image.height);
  out.values(image.samples);
  return out.take();
}

HeightImage decode_heights(std::string_view bytes) {
  ByteReader in(bytes);
  HeightImage image;
  image.width = in.value<int>();
  image.height = in.value<int>();
  image.samples = in.values<std::uint16_t>();
  const auto fits = [](int side) { return side >= 2 && side <= kLargestHeightImageSide; };
  require(in.exhausted() && fits(image.width) && fits(image.height) &&
              image.samples.size() ==
                  static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "damaged heights");
  return image;
}

Texture decode_texture(std::string_view bytes) {
  ByteReader in(bytes);
  Texture texture = read_texture(in);
  require(in.exhausted(), "a damaged answer");
  return texture;
}

Scene decode_scene(std::string_view bytes) {
  ByteReader in(bytes);
  Scene scene;
  scene.name = in.text();
  scene.description = in.text();
  scene.notes = in.list<std::string>([&] { return in.text(); });
  scene.mesh = read_mesh(in);
  scene.materials = in.list<Material>([&] { return read_material(in); });
  scene.textures = in.list<Texture>([&] { return read_texture(in); });
  scene.origin = in.value<glm::dvec3>();
  scene.camera = in.value<parameters::Camera>();
  scene.light_direction = in.value<glm::dvec3>();
  scene.shadow_distance_metres = in.value<double>();
  scene.seen_distance_metres = in.value<double>();
  scene.ground_triangles = in.value<std::uint64_t>();
  if (in.flag()) scene.clouds = in.value<CloudLayer>();
  require(scene.ground_triangles <= scene.mesh.triangle_count(), "more ground than triangles");
  require(in.exhausted(), "a damaged answer");
  check(scene);
  return scene;
}

}  // namespace penumbra::scene
