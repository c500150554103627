#include "shaders/flat_inputs.h"

#include <unordered_set>

#include "shaders/spirv_words.h"

namespace penumbra::shaders {

namespace {

// What the module declares, read in the order that SPIR-V prescribes.
struct Inputs {
  bool fragment = false;
  std::size_t first_type = 0;  // where the decorations end
  std::unordered_set<std::uint32_t> flat_ids;
  std::unordered_set<std::uint32_t> integers;  // types: int, and vectors and arrays of it
  std::unordered_set<std::uint32_t> pointers;  // to such inputs
  std::vector<std::uint32_t> missing;
};

void read(const SpirvModule& module, std::size_t at, Inputs& inputs) {
  const std::uint32_t opcode = module[at] & 0xFFFFU;
  const std::size_t length = module[at] >> 16U;
  const auto word = [&](std::size_t i) { return i < length ? module[at + i] : 0; };
  if (opcode >= spv::OpTypeVoid && opcode <= spv::OpTypeForwardPointer && inputs.first_type == 0)
    inputs.first_type = at;
  switch (opcode) {
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
  for (std::size_t at = header_words; at < module.size();) {
    const std::size_t length = module[at] >> 16U;
    if (length == 0 || at + length > module.size()) return;  // no module; left to the validator
    read(module, at, inputs);
    at += length;
  }
  if (!inputs.fragment) return;
  SpirvModule decorations;
  for (const std::uint32_t id : inputs.missing)
    decorations.insert(decorations.end(), {(3U << 16U) | spv::OpDecorate, id, spv::DecorationFlat});
  const auto place = module.begin() + static_cast<std::ptrdiff_t>(inputs.first_type);
  module.insert(place, decorations.begin(), decorations.end());
}

}  // namespace penumbra::shaders
