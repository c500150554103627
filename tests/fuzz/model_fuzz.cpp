// Reads models of any numbers, as far as the code is ours: the importer, which is not instrumented, is given
// whole files. The first byte says which kind; the rest are its numbers.
#include <algorithm>
#include <cstring>

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "scene/scene.h"
#include "scene/scene_message.h"

namespace penumbra::fuzz {

namespace {

// Triangles of any bits, each a normal, three corners and two bytes.
std::string stl(std::string_view bytes) {
  constexpr std::size_t triangle = 50;
  const auto count = static_cast<std::uint32_t>(bytes.size() / triangle);
  std::string file(80, ' ');
  file.append(reinterpret_cast<const char*>(&count), sizeof count);
  return file.append(bytes.substr(0, count * triangle));
}

float next_number(std::string_view& bytes) {
  float number = 0.0F;
  if (bytes.size() < sizeof number) return number;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes.remove_prefix(sizeof number);
  return number;
}

// Eight vertices with normals and coordinates, then faces of three or four of them, each of some material.
std::string obj(std::string_view bytes) {
  std::string file = "mtllib model.mtl\n";
  for (int i = 0; i < 8; ++i)
    for (const char* kind : {"v", "vn", "vt"}) {
      file += kind;
      for (int axis = 0; axis < 3; ++axis) file += " " + std::to_string(next_number(bytes));
      file += "\n";
    }
  for (; bytes.size() >= 5; bytes.remove_prefix(5)) {
    file += "usemtl m" + std::to_string(static_cast<unsigned char>(bytes[4]) % 3) + "\nf";
    for (int corner = 0; corner < (bytes[4] & 64 ? 4 : 3); ++corner) {
      const std::string vertex = std::to_string(1 + (static_cast<unsigned char>(bytes[corner]) & 7));
      file += " " + vertex + "/" + vertex + "/" + vertex;
    }
    file += "\n";
  }
  return file;
}

}  // namespace

void targets::model(std::string_view bytes) {
  static const ScratchFolder folder;
  static const bool written = [] {
    folder.write("model.mtl", "newmtl m0\nKd 1 0.5 0\nmap_Kd none.png\nnewmtl m1\nKd nan -1 1e30\nNs 1e9\n");
    return true;
  }();
  (void)written;
  const std::uint8_t kind = take_byte(bytes);
  const bool text = (kind & 1) != 0;
  const std::filesystem::path file =
      folder.write(text ? "model.obj" : "model.stl", text ? obj(bytes) : stl(bytes));
  scene::ImportOptions options;
  options.z_up = (kind & 2) != 0;
  options.ground = (kind & 4) != 0;
  options.height_metres = (kind & 8) != 0 ? 2.0 : 0.0;
  options.triangle_limit = 1000;
  read([&] {
    const scene::Scene scene = scene::import(file, options);
    const std::string message = scene::encode(scene);
    require(scene::encode(scene::decode_scene(message)) == message, "what is imported may be sent");
  });
}

}  // namespace penumbra::fuzz
