#include "shaders/module_problems.h"

#include <bit>
#include <set>

#include "hlsl/name_set.h"
#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

class InstructionSearch final : public ModuleSearch {
 public:
  InstructionSearch(const SpirvModule& module, hlsl::Stage stage) : ModuleSearch(module), stage_(stage) {}

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    const bool discards =
        hlsl::is_one_of(op, {spv::OpKill, spv::OpTerminateInvocation, spv::OpDemoteToHelperInvocationEXT});
    if (discards && stage_ != hlsl::Stage::fragment)
      report("clip() and discard end a pixel, and a " + std::string(hlsl::stage_name(stage_)) +
             " program has none: only fragment programs have them");
    // The front end itself puts one into hull programs.
    if (op == spv::OpControlBarrier && stage_ != hlsl::Stage::compute && stage_ != hlsl::Stage::hull)
      report("a barrier waits for the threads of a group, and a " + std::string(hlsl::stage_name(stage_)) +
             " program has none: only compute programs have barriers with sync");
  }

  hlsl::Stage stage_;
};

bool is_atomic(spv::Op op) {
  return op >= spv::OpAtomicLoad && op <= spv::OpAtomicXor;
}

// Returns the index of the pointer operand in an instruction that reads or writes memory; 0 for others.
std::size_t pointer_word(spv::Op op) {
  if (op == spv::OpStore || op == spv::OpAtomicStore) return 1;
  return is_atomic(op) || hlsl::is_one_of(op, {spv::OpLoad, spv::OpAccessChain, spv::OpInBoundsAccessChain})
             ? 3
             : 0;
}

class MemorySearch final : public ModuleSearch {
 public:
  MemorySearch(const SpirvModule& module, hlsl::Stage stage) : ModuleSearch(module), stage_(stage) {}

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    note_read_only(op, instruction);
    if (op == spv::OpTypePointer && instruction.size() > 2) classes_[instruction[1]] = instruction[2];
    if (const std::size_t at = pointer_word(op); at != 0 && instruction.size() > at)
      use(op, class_of(instruction[at]));
    const bool makes_pointer = hlsl::is_one_of(
        op, {spv::OpVariable, spv::OpAccessChain, spv::OpInBoundsAccessChain, spv::OpCopyObject});
    if (makes_pointer && instruction.size() > 2) classes_[instruction[2]] = class_of(instruction[1]);
  }

  // Records buffers whose struct has members that may not be written, and the variables behind pointers into
  // them.
  void note_read_only(spv::Op op, spirv::Words instruction) {
    if (op == spv::OpMemberDecorate && instruction.size() > 3 && instruction[3] == spv::DecorationNonWritable)
      read_only_.insert(instruction[1]);
    if (op == spv::OpTypePointer && instruction.size() > 3 && read_only_.contains(instruction[3]))
      read_only_.insert(instruction[1]);
    if (op == spv::OpVariable && instruction.size() > 2 && read_only_.contains(instruction[1]))
      read_only_.insert(instruction[2]);
    const bool part =
        hlsl::is_one_of(op, {spv::OpAccessChain, spv::OpInBoundsAccessChain, spv::OpCopyObject});
    if (part && instruction.size() > 3 && read_only_.contains(instruction[3]))
      read_only_.insert(instruction[2]);
    if (is_atomic(op) && op != spv::OpAtomicLoad && pointer_word(op) < instruction.size() &&
        read_only_.contains(instruction[pointer_word(op)]))
      report("an Interlocked function changes a buffer that can only be read: declare it as an RW buffer");
  }

  // Returns the storage class of a pointer's type, or of a pointer.
  std::uint32_t class_of(std::uint32_t id) const {
    const auto found = classes_.find(id);
    return found == classes_.end() ? std::uint32_t{spv::StorageClassMax} : found->second;
  }

  void use(spv::Op op, std::uint32_t storage) {
    if (storage == spv::StorageClassWorkgroup && stage_ != hlsl::Stage::compute)
      report(std::string("a groupshared variable is used in a ") + hlsl::stage_name(stage_) +
             " program: only compute programs have them");
    if (is_atomic(op) && (storage == spv::StorageClassFunction || storage == spv::StorageClassPrivate))
      report(
          "an Interlocked function changes a local variable: it takes groupshared variables and elements "
          "of RW resources");
  }

  hlsl::Stage stage_;
  std::set<std::uint32_t> read_only_;               // structs, pointer types, variables and pointers
  std::map<std::uint32_t, std::uint32_t> classes_;  // storage class of each pointer and type of pointers
};

constexpr std::int32_t lowest_offset = -8;
constexpr std::int32_t highest_offset = 7;

// Returns the index of the image operands of an instruction with an offset in texels; 0 for none.
std::size_t image_operands(spv::Op op) {
  switch (op) {
    case spv::OpImageSampleImplicitLod:
    case spv::OpImageSampleExplicitLod:
    case spv::OpImageSampleProjImplicitLod:
    case spv::OpImageSampleProjExplicitLod:
    case spv::OpImageFetch:
      return 5;
    case spv::OpImageSampleDrefImplicitLod:
    case spv::OpImageSampleDrefExplicitLod:
    case spv::OpImageSampleProjDrefImplicitLod:
    case spv::OpImageSampleProjDrefExplicitLod:
      return 6;
    default:
      return 0;
  }
}

class OffsetSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpConstant && instruction.size() == 4) {
      constants_[instruction[2]] = {instruction[3]};
    } else if (op == spv::OpConstantNull && instruction.size() == 3) {
      constants_[instruction[2]] = {0};
    } else if (op == spv::OpConstantComposite && instruction.size() > 3) {
      std::vector<std::uint32_t>& parts = constants_[instruction[2]];
      for (const std::uint32_t id : instruction.subspan(3))
        if (const auto part = constants_.find(id); part != constants_.end())
          parts.insert(parts.end(), part->second.begin(), part->second.end());
    } else if (const std::size_t operands = image_operands(op);
               operands != 0 && instruction.size() > operands) {
      offset(instruction.subspan(operands));
    }
  }

  // `operands` are the mask, then the operands of its bits from the lowest up; a gradient has two.
  void offset(spirv::Words operands) {
    const std::uint32_t mask = operands[0];
    const std::uint32_t wanted = spv::ImageOperandsConstOffsetMask | spv::ImageOperandsOffsetMask;
    if ((mask & wanted) == 0) return;
    const bool constant = (mask & spv::ImageOperandsConstOffsetMask) != 0;
    const std::uint32_t before =
        mask & (spv::ImageOperandsBiasMask | spv::ImageOperandsLodMask | spv::ImageOperandsGradMask);
    std::size_t at = 1U + static_cast<std::size_t>(std::popcount(before));
    if ((mask & spv::ImageOperandsGradMask) != 0) ++at;
    if (at >= operands.size()) return;
    const auto known = constants_.find(operands[at]);
    if (!constant && known == constants_.end())
      return report(
          "the offset of a texture read must be a constant from -8 to 7; if it depends on a loop counter, "
          "write [unroll] before the loop");
    if (known == constants_.end()) return;
    for (const std::uint32_t word : known->second) {
      const auto texels = std::bit_cast<std::int32_t>(word);
      if (texels < lowest_offset || texels > highest_offset)
        return report("the offset of a texture read is " + std::to_string(texels) +
                      " texels, and must be from -8 to 7");
    }
  }

  std::map<std::uint32_t, std::vector<std::uint32_t>> constants_;  // the words of all their components
};

// Comparisons (glslang appends the reference to the coordinate) and projections (the divisor) are excluded.
bool reads_by_coordinate_alone(spv::Op op) {
  return hlsl::is_one_of(op, {spv::OpImageSampleImplicitLod, spv::OpImageSampleExplicitLod, spv::OpImageFetch,
                              spv::OpImageGather, spv::OpImageRead});
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
    if ((hlsl::is_one_of(op, {spv::OpLoad, spv::OpSampledImage, spv::OpImage})) && instruction.size() > 3)
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

// Returns the operands of a reading instruction that may be textures and samplers.
spirv::Words handles(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  const bool reads = (op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageQuerySamples) ||
                     (op >= spv::OpImageSparseSampleImplicitLod && op <= spv::OpImageSparseRead);
  if (op == spv::OpSampledImage && instruction.size() > 4) return instruction.subspan(3, 2);
  if (op == spv::OpImageWrite && instruction.size() > 1) return instruction.subspan(1, 1);
  return reads && instruction.size() > 3 ? instruction.subspan(3, 1) : spirv::Words{};
}

class LostSearch final : public ModuleSearch {
 public:
  using ModuleSearch::ModuleSearch;

 private:
  void visit(spirv::Words instruction) override {
    switch (spirv::opcode(instruction)) {
      case spv::OpTypeImage:
      case spv::OpTypeSampledImage:
        if (instruction.size() > 1) kinds_[instruction[1]] = "texture";
        break;
      case spv::OpTypeSampler:
        if (instruction.size() > 1) kinds_[instruction[1]] = "sampler";
        break;
      case spv::OpUndef:
      case spv::OpConstantNull:
        if (of_resource(instruction)) undefined_[instruction[2]] = kinds_[instruction[1]];
        break;
      case spv::OpPhi:
      case spv::OpSelect:
        if (of_resource(instruction))
          report("a " + kinds_[instruction[1]] +
                 " is selected at run time, which HLSL does not allow; read both and select between the "
                 "results");
        break;
      default:
        for (const std::uint32_t id : handles(instruction)) read(id);
    }
  }

  bool of_resource(spirv::Words instruction) const {
    return instruction.size() > 2 && kinds_.count(instruction[1]) != 0;
  }

  void read(std::uint32_t id) {
    const auto found = undefined_.find(id);
    if (found == undefined_.end()) return;
    report("a " + found->second +
           " is read uninitialised; if every path does initialise it, one function reads it both "
           "with a comparison sampler and with another sampler, which glslang miscompiles: use a "
           "separate function for each");
  }

  std::map<std::uint32_t, std::string> kinds_;      // kinds of types
  std::map<std::uint32_t, std::string> undefined_;  // undefined values
};

}  // namespace

std::vector<hlsl::Diagnostic> refused_instructions(const SpirvModule& module, hlsl::Stage stage) {
  return InstructionSearch(module, stage).run();
}

std::vector<hlsl::Diagnostic> refused_memory(const SpirvModule& module, hlsl::Stage stage) {
  return MemorySearch(module, stage).run();
}

std::vector<hlsl::Diagnostic> refused_offsets(const SpirvModule& module) {
  return OffsetSearch(module).run();
}

std::vector<hlsl::Diagnostic> misread_textures(const SpirvModule& module) {
  return MisreadSearch(module).run();
}

std::vector<hlsl::Diagnostic> lost_resources(const SpirvModule& module) {
  return LostSearch(module).run();
}

}  // namespace penumbra::shaders
