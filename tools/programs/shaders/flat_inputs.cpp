#include "shaders/flat_inputs.h"

#include <unordered_set>

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

}  // namespace penumbra::shaders
