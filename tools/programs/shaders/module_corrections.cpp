#include "shaders/module_corrections.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>

#include "shaders/module_rewrite.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

// The module's declarations, read in the order that SPIR-V prescribes.
struct Inputs {
  bool fragment = false;
  std::size_t first_type = 0;  // the end of the decorations
  std::unordered_set<std::uint32_t> flat_ids;
  std::unordered_set<std::uint32_t> integers;  // types: int, and vectors and arrays of it
  std::unordered_set<std::uint32_t> pointers;  // pointers to such inputs
  std::vector<std::uint32_t> missing;
};

void read(spirv::Words instruction, std::size_t at, Inputs& inputs) {
  const spv::Op op = spirv::opcode(instruction);
  const auto word = [&](std::size_t i) { return i < instruction.size() ? instruction[i] : 0; };
  if (op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer && inputs.first_type == 0)
    inputs.first_type = at;
  switch (op) {
    case spv::OpEntryPoint:
      inputs.fragment = inputs.fragment || word(1) == spv::ExecutionModelFragment;
      break;
    case spv::OpDecorate:
      if (word(2) == spv::DecorationFlat) inputs.flat_ids.insert(word(1));
      break;
    case spv::OpTypeInt:
      inputs.integers.insert(word(1));
      break;
    case spv::OpTypeVector:
    case spv::OpTypeArray:
      if (inputs.integers.count(word(2)) != 0) inputs.integers.insert(word(1));
      break;
    case spv::OpTypePointer:
      if (word(2) == spv::StorageClassInput && inputs.integers.count(word(3)) != 0)
        inputs.pointers.insert(word(1));
      break;
    case spv::OpVariable:
      if (inputs.pointers.count(word(1)) != 0 && inputs.flat_ids.count(word(2)) == 0)
        inputs.missing.push_back(word(2));
      break;
    default:
      break;
  }
}

// No gather of HLSL has a bias that could need it.
bool asks_for_gather_bias(spirv::Words one) {
  if (spirv::opcode(one) == spv::OpCapability)
    return one.size() > 1 && one[1] == spv::CapabilityImageGatherBiasLodAMD;
  return spirv::opcode(one) == spv::OpExtension &&
         spirv::literal_text(one.subspan(1)) == "SPV_AMD_texture_gather_bias_lod";
}

constexpr std::size_t gather_mask = 6;  // after result type, result, image, coordinate and component

bool has_four_offsets(spirv::Words one) {
  const spv::Op op = spirv::opcode(one);
  return (op == spv::OpImageGather || op == spv::OpImageDrefGather) && one.size() == gather_mask + 2 &&
         one[gather_mask] == spv::ImageOperandsConstOffsetsMask;
}

bool is_remainder(spirv::Words one) {
  return spirv::opcode(one) == spv::OpFMod || spirv::opcode(one) == spv::OpSMod;
}

template <typename Condition>
bool has_any(const SpirvModule& module, Condition condition) {
  bool found = false;
  spirv::for_each_instruction(module, [&](spirv::Words one) { found = found || condition(one); });
  return found;
}

void append(SpirvModule& to, spv::Op op, std::uint32_t type, std::uint32_t result, std::uint32_t a,
            std::uint32_t b) {
  to.insert(to.end(), {5U << 16U | static_cast<std::uint32_t>(op), type, result, a, b});
}

class ZeroedStatics {
 public:
  void run(SpirvModule& module) {
    SpirvModule result(module.begin(), module.begin() + spirv::header_words);
    spirv::for_each_instruction(module, [&](spirv::Words words) {
      const spv::Op op = spirv::opcode(words);
      if (op == spv::OpTypePointer && words[2] == spv::StorageClassPrivate) pointees_[words[1]] = words[3];
      if (has_null(op, words)) nullable_.insert(words[1]);
      const bool unset = op == spv::OpVariable && words.size() == 4 && words[3] == spv::StorageClassPrivate;
      if (!unset || !nullable_.contains(pointees_[words[1]])) {
        result.insert(result.end(), words.begin(), words.end());
        return;
      }
      const std::uint32_t null = null_of(pointees_[words[1]], result);
      result.insert(result.end(), {5U << 16U | spv::OpVariable, words[1], words[2], words[3], null});
    });
    module = std::move(result);
  }

 private:
  bool has_null(spv::Op op, spirv::Words words) const {
    switch (op) {
      case spv::OpTypeBool:
      case spv::OpTypeInt:
      case spv::OpTypeFloat:
        return true;
      case spv::OpTypeVector:
      case spv::OpTypeMatrix:
      case spv::OpTypeArray:
        return nullable_.contains(words[2]);
      case spv::OpTypeStruct:
        return std::all_of(words.begin() + 2, words.end(),
                           [&](std::uint32_t member) { return nullable_.contains(member); });
      default:
        return false;
    }
  }

  std::uint32_t null_of(std::uint32_t type, SpirvModule& result) {
    std::uint32_t& null = nulls_[type];
    if (null == 0) {
      null = result[3]++;
      result.insert(result.end(), {3U << 16U | spv::OpConstantNull, type, null});
    }
    return null;
  }

  std::map<std::uint32_t, std::uint32_t> pointees_;  // types that pointers to private variables point to
  std::set<std::uint32_t> nullable_;                 // nullable types
  std::map<std::uint32_t, std::uint32_t> nulls_;     // null constants by type
};

struct Types {
  std::set<std::uint32_t> floats;
  std::map<std::uint32_t, std::uint32_t> vector_components;  // component's type by vector type
  std::set<std::uint32_t> matrices;                          // matrices of integers and bools
  std::set<std::uint32_t> counts;                            // counts of their vectors
  std::uint32_t unsigned_type = 0;
};

Types read_types(const SpirvModule& module) {
  Types types;
  spirv::for_each_instruction(module, [&](spirv::Words words) {
    if (spirv::opcode(words) == spv::OpTypeFloat) types.floats.insert(words[1]);
    if (spirv::opcode(words) == spv::OpTypeVector) types.vector_components[words[1]] = words[2];
    if (spirv::opcode(words) == spv::OpTypeInt && words[2] == 32 && words[3] == 0)
      types.unsigned_type = words[1];
    if (spirv::opcode(words) != spv::OpTypeMatrix || types.floats.contains(types.vector_components[words[2]]))
      return;
    types.matrices.insert(words[1]);
    types.counts.insert(words[3]);
  });
  return types;
}

bool lies_in_a_buffer(const SpirvModule& module, const Types& types) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> members;  // members that are decorated as matrices
  bool found = false;
  spirv::for_each_instruction(module, [&](spirv::Words words) {
    if (spirv::opcode(words) == spv::OpMemberDecorate && words[3] == spv::DecorationMatrixStride)
      members.insert({words[1], words[2]});
    if (spirv::opcode(words) != spv::OpTypeStruct) return;
    for (std::uint32_t i = 2; i < words.size(); ++i)
      found = found || (types.matrices.contains(words[i]) && members.contains({words[1], i - 2}));
  });
  return found;
}

void append(SpirvModule& to, spv::Op op, std::initializer_list<std::uint32_t> operands) {
  to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16U | static_cast<std::uint32_t>(op));
  to.insert(to.end(), operands);
}

bool begins_types(spv::Op op) {
  return op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer;
}

}  // namespace

void flatten_integer_inputs(SpirvModule& module) {
  Inputs inputs;
  const SpirvModule& read_only = module;
  const bool whole = spirv::for_each_instruction(read_only, [&](spirv::Words instruction) {
    read(instruction, static_cast<std::size_t>(instruction.data() - module.data()), inputs);
  });
  if (!whole) return;  // malformed; the validator reports it
  if (!inputs.fragment) return;
  SpirvModule decorations;
  for (const std::uint32_t id : inputs.missing)
    decorations.insert(decorations.end(), {(3U << 16U) | spv::OpDecorate, id, spv::DecorationFlat});
  const auto place = module.begin() + static_cast<std::ptrdiff_t>(inputs.first_type);
  module.insert(place, decorations.begin(), decorations.end());
}

void drop_gather_bias(SpirvModule& module) {
  constexpr std::size_t mask = gather_mask;
  SpirvModule kept(module.begin(), module.begin() + spirv::header_words);
  kept.reserve(module.size());
  spirv::for_each_instruction(module, [&](spirv::Words one) {
    if (asks_for_gather_bias(one)) return;
    const std::size_t begin = kept.size();
    kept.insert(kept.end(), one.begin(), one.end());
    const bool biased = spirv::opcode(one) == spv::OpImageDrefGather && one.size() > mask + 1 &&
                        (one[mask] & spv::ImageOperandsBiasMask) != 0;
    if (!biased) return;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(begin + mask + 1));  // the bias comes first
    kept[begin + mask] &= ~static_cast<std::uint32_t>(spv::ImageOperandsBiasMask);
    if (kept[begin + mask] == 0) kept.pop_back();
    kept[begin] = static_cast<std::uint32_t>((kept.size() - begin) << 16U) | spv::OpImageDrefGather;
  });
  module = std::move(kept);
}

void split_gathers(SpirvModule& module) {
  if (!has_any(module, has_four_offsets)) return;
  std::map<std::uint32_t, spirv::Words> composites;             // constants, by id
  std::map<std::uint32_t, std::uint32_t> component_of_vectors;  // types
  const SpirvModule& read_only = module;
  spirv::for_each_instruction(read_only, [&](spirv::Words one) {
    if (spirv::opcode(one) == spv::OpTypeVector) component_of_vectors[one[1]] = one[2];
    if (spirv::opcode(one) == spv::OpConstantComposite && one.size() == 7)
      composites[one[2]] = one.subspan(3);
  });
  ModuleRewrite rewrite(read_only);
  spirv::for_each_instruction(read_only, [&](spirv::Words one) {
    const auto offsets = has_four_offsets(one) ? composites.find(one[gather_mask + 1]) : composites.end();
    if (offsets == composites.end()) return rewrite.keep(one);
    ModuleRewrite::Words texels;
    for (const std::uint32_t offset : offsets->second) {
      const std::uint32_t four = rewrite.result(
          spirv::opcode(one), one[1], {one[3], one[4], one[5], spv::ImageOperandsConstOffsetMask, offset});
      texels.push_back(rewrite.result(spv::OpCompositeExtract, component_of_vectors.at(one[1]), {four, 3}));
    }
    rewrite.result(spv::OpCompositeConstruct, one[1], texels, one[2]);
  });
  module = rewrite.finished();
}

void truncate_remainders(SpirvModule& module) {
  if (!has_any(module, is_remainder)) return;
  SpirvModule result(module.begin(), module.begin() + spirv::header_words);
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    if (spirv::opcode(instruction) == spv::OpSMod && instruction.size() == 5) {
      const std::uint32_t type = instruction[1];
      const std::uint32_t a = instruction[3];
      const std::uint32_t b = instruction[4];
      const std::uint32_t quotient = result[3]++;
      const std::uint32_t product = result[3]++;
      append(result, spv::OpSDiv, type, quotient, a, b);
      append(result, spv::OpIMul, type, product, b, quotient);
      append(result, spv::OpISub, type, instruction[2], a, product);
      return;
    }
    result.insert(result.end(), instruction.begin(), instruction.end());
    if (spirv::opcode(instruction) == spv::OpFMod)
      result[result.size() - instruction.size()] =
          static_cast<std::uint32_t>(instruction.size()) << 16U | spv::OpFRem;
  });
  module = std::move(result);
}

void copy_scalar_conditions(SpirvModule& module) {
  std::unordered_set<std::uint32_t> bool_types;
  std::unordered_set<std::uint32_t> bools;  // results of a type of bool: words 1 and 2 of what has both
  spirv::for_each_instruction(module, [&](spirv::WrittenWords words) {
    const spv::Op op = spirv::opcode(words);
    if (op == spv::OpTypeBool && words.size() == 2) bool_types.insert(words[1]);
    if (words.size() < 3 || bool_types.count(words[1]) == 0) return;
    const bool condition = (op == spv::OpAny || op == spv::OpAll) && words.size() == 4;
    if (condition && bools.count(words[3]) != 0) words[0] = (words[0] & ~0xFFFFU) | spv::OpCopyObject;
    bools.insert(words[2]);
  });
}

void zero_statics(SpirvModule& module) {
  ZeroedStatics().run(module);
}

void make_whole_matrices_arrays(SpirvModule& module) {
  Types types = read_types(module);
  if (types.matrices.empty() || lies_in_a_buffer(module, types)) return;
  SpirvModule result(module.begin(), module.begin() + spirv::header_words);
  std::map<std::uint32_t, std::uint32_t> sizes;  // the constant of each count
  const auto declare_sizes = [&] {
    if (types.unsigned_type == 0) types.unsigned_type = result[3]++;
    append(result, spv::OpTypeInt, {types.unsigned_type, 32, 0});
    for (const std::uint32_t count : types.counts) {
      sizes[count] = result[3]++;
      append(result, spv::OpConstant, {types.unsigned_type, sizes[count], count});
    }
  };
  spirv::for_each_instruction(module, [&](spirv::Words words) {
    if (sizes.empty() && begins_types(spirv::opcode(words))) declare_sizes();
    if (spirv::opcode(words) == spv::OpTypeInt && words[1] == types.unsigned_type)
      return;  // it is moved to the front
    if (spirv::opcode(words) == spv::OpTypeMatrix && types.matrices.contains(words[1])) {
      append(result, spv::OpTypeArray, {words[1], words[2], sizes.at(words[3])});
    } else {
      result.insert(result.end(), words.begin(), words.end());
    }
  });
  module = std::move(result);
}

}  // namespace penumbra::shaders
