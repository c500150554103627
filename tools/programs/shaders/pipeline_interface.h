// The facts that a Vulkan pipeline needs about a module: descriptors, push constants, and the variables that
// are passed between stages. It is for a host that creates pipelines from arbitrary shaders.
//
// Based on the Vulkan specification, "Shader Interfaces": locations, components and descriptor types.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::shaders {

enum class DescriptorKind {
  uniform_buffer,
  storage_buffer,
  sampled_image,
  storage_image,
  uniform_texel_buffer,
  storage_texel_buffer,
  combined_image_sampler,
  sampler,
  input_attachment
};

struct Descriptor {
  DescriptorKind kind = DescriptorKind::uniform_buffer;
  std::string name;
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
  std::uint32_t count = 1;  // elements of an array; 1 for an array without a size
};

enum class ScalarType { float32, int32, uint32 };

// A location of a stage's inputs or outputs; matrices and arrays take several.
struct StageLocation {
  std::uint32_t location = 0;
  std::uint32_t component = 0;   // first
  std::uint32_t components = 4;  // 1 to 4
  ScalarType type = ScalarType::float32;
};

struct PipelineInterface {
  std::vector<Descriptor> descriptors;
  std::uint32_t push_constant_bytes = 0;  // counted from offset 0
  std::vector<StageLocation> inputs;      // without built-ins; sorted by location
  std::vector<StageLocation> outputs;
};

// Returns the interface that the entry point can reach. Throws std::invalid_argument if the words are not a
// SPIR-V module or have no such entry point, if an input or output has a type with other than 32 bits, and
// for arrays larger than any device binds.
PipelineInterface pipeline_interface(const std::vector<std::uint32_t>& spirv, const std::string& entry);

}  // namespace penumbra::shaders
