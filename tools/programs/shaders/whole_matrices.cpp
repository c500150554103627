#include "shaders/whole_matrices.h"

#include <map>
#include <set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

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
