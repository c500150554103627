#include "shaders/misread_textures.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "shaders/module_search.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

// Comparisons (glslang appends the reference to the coordinate) and projections (the divisor) are excluded.
bool reads_by_coordinate_alone(spv::Op op) {
  return op == spv::OpImageSampleImplicitLod || op == spv::OpImageSampleExplicitLod ||
         op == spv::OpImageFetch || op == spv::OpImageGather || op == spv::OpImageRead;
}

std::uint32_t coordinates(spv::Dim dimension, bool is_array) {
  switch (dimension) {
    case spv::Dim1D:
    case spv::DimBuffer:
      return 1U + (is_array ? 1U : 0U);
    case spv::Dim3D:
    case spv::DimCube:
      return 3U + (is_array ? 1U : 0U);
    default:
      return 2U + (is_array ? 1U : 0U);
  }
}

class MisreadSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpName && instruction.size() > 2) {
      names_[instruction[1]] = spirv::literal_text(instruction.subspan(2));
    } else if (op == spv::OpTypeImage && instruction.size() > 5) {
      textures_[instruction[1]] = coordinates(static_cast<spv::Dim>(instruction[3]), instruction[5] != 0);
    } else if (op == spv::OpTypeVector && instruction.size() > 3) {
      vectors_[instruction[1]] = instruction[3];
    } else if (reads_by_coordinate_alone(op) && instruction.size() > 4) {
      read(instruction[3], instruction[4]);
      types_[instruction[2]] = instruction[1];
    } else if (instruction.size() > 2) {
      remember(op, instruction);
    }
  }

  // Records a value's type, and the variable from which it was loaded.
  void remember(spv::Op op, spirv::Words instruction) {
    bool has_result = false;
    bool has_type = false;
    spv::HasResultAndType(op, &has_result, &has_type);
    if (!has_result || !has_type) return;
    types_[instruction[2]] = instruction[1];
    if ((op == spv::OpLoad || op == spv::OpSampledImage || op == spv::OpImage) && instruction.size() > 3)
      sources_[instruction[2]] = instruction[3];
  }

  void read(std::uint32_t image, std::uint32_t coordinate) {
    const auto given = vectors_.find(types_[coordinate]);
    if (given == vectors_.end()) return;
    std::uint32_t type = types_[image];
    // The image may be a pair with its sampler.
    while (textures_.count(type) == 0 && sources_.count(image) != 0) {
      image = sources_[image];
      type = types_[image];
    }
    const auto needed = textures_.find(type);
    if (needed == textures_.end() || given->second <= needed->second) return;
    while (sources_.count(image) != 0) image = sources_[image];
    report("'" + names_[image] + "' is read with " + std::to_string(given->second) + " coordinates and has " +
           std::to_string(needed->second) +
           ": a texture is passed to a function that takes another kind (an array, where both "
           "eyes are drawn at once); declare it as that kind (TEXTURE2D_X)");
  }

  std::map<std::uint32_t, std::string> names_;
  std::map<std::uint32_t, std::uint32_t> textures_;  // number of coordinates of each image type
  std::map<std::uint32_t, std::uint32_t> vectors_;   // number of components of each vector type
  std::map<std::uint32_t, std::uint32_t> types_;     // types of values
  std::map<std::uint32_t, std::uint32_t> sources_;   // sources of values
};

}  // namespace

std::vector<hlsl::Diagnostic> misread_textures(const SpirvModule& module) {
  return MisreadSearch(module).run();
}

}  // namespace penumbra::shaders
