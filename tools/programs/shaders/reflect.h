// Reflection: the resources of a SPIR-V module by name, for a host that binds resources by name.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::shaders {

enum class ScalarKind { float32, int32, uint32, other };

// A scalar, vector or matrix of a uniform: the uniform itself, an element of it or a field.
struct UniformLeaf {
  std::string path;          // the uniform's name with subscripts and fields: "_Lights[1].colour"
  std::uint32_t offset = 0;  // bytes in the block
  ScalarKind scalar = ScalarKind::float32;
  std::uint32_t rows = 1;  // for a vector, the number of its components
  std::uint32_t columns = 1;
  std::uint32_t matrix_stride = 0;  // see UniformMember; 0 if not a matrix
  bool row_major = false;
};

struct UniformMember {
  std::string name;
  std::uint32_t offset = 0;        // bytes in its block
  std::uint32_t size = 0;          // bytes, without padding after the last element
  std::uint32_t array_length = 0;  // 0 when not an array
  std::uint32_t array_stride = 0;
  std::uint32_t matrix_stride = 0;  // 0 when not a matrix
  bool row_major = false;           // SPIR-V's decoration
  bool read = false;                // the module reads at least a part of it
  // The leaves are in declaration order, arrays element by element. They are empty for arrays of arrays.
  std::vector<UniformLeaf> leaves{};
};

enum class ResourceKind { uniform_block, storage_buffer, sampled_image, storage_image, sampler };

// Texture2D is the default; a cube has two dimensions.
struct ImageType {
  int dimensions = 2;
  bool cube = false;
  bool arrayed = false;
  bool multisampled = false;
  ScalarKind texel = ScalarKind::float32;  // type of the components that a read returns
};

struct Resource {
  ResourceKind kind = ResourceKind::uniform_block;
  std::string name;  // the HLSL variable; "$Global" for loose uniforms
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
  std::uint32_t size = 0;              // uniform blocks: bytes
  std::vector<UniformMember> members;  // uniform blocks
  ImageType image;                     // sampled and storage images
  bool written = false;                // storage buffers and images that are not declared to be read only
};

struct Reflection {
  std::vector<Resource> resources;  // those the entry point can reach
  std::array<std::uint32_t, 3> workgroup_size{1, 1, 1};
};

// Throws std::invalid_argument when the words are no SPIR-V module.
Reflection reflect(const std::vector<std::uint32_t>& spirv);

}  // namespace penumbra::shaders
