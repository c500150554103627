// What a SPIR-V module binds: by name, for a host that fills resources by name.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::shaders {

struct UniformMember {
  std::string name;
  std::uint32_t offset = 0;        // bytes in its block
  std::uint32_t size = 0;          // bytes, padding after the last element left out
  std::uint32_t array_length = 0;  // 0 when not an array
  std::uint32_t array_stride = 0;
  std::uint32_t matrix_stride = 0;  // 0 when not a matrix
  bool row_major = false;           // as SPIR-V decorates it
  bool read = false;                // the module reads it, in part at least
};

enum class ResourceKind { uniform_block, storage_buffer, sampled_image, storage_image, sampler };

struct Resource {
  ResourceKind kind = ResourceKind::uniform_block;
  std::string name;  // the HLSL variable; "$Global" for loose uniforms
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
  std::uint32_t size = 0;              // uniform blocks: bytes
  std::vector<UniformMember> members;  // uniform blocks
};

struct Reflection {
  std::vector<Resource> resources;  // those the entry point can reach
  std::array<std::uint32_t, 3> workgroup_size{1, 1, 1};
};

// Throws std::invalid_argument when the words are no SPIR-V module.
Reflection reflect(const std::vector<std::uint32_t>& spirv);

}  // namespace penumbra::shaders
