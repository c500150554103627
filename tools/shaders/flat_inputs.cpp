#include "shaders/flat_inputs.h"

#include <unordered_set>

namespace penumbra::shaders {

namespace {

// SPIR-V specification 1.3, section 3.
constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_entry_point = 15;  // model, function, name..., interface...
constexpr std::uint32_t op_type_void = 19;
constexpr std::uint32_t op_type_int = 21;
constexpr std::uint32_t op_type_vector = 23;   // result, element, count
constexpr std::uint32_t op_type_array = 28;    // result, element, length
constexpr std::uint32_t op_type_pointer = 32;  // result, storage class, type
constexpr std::uint32_t op_variable = 59;      // type, result, storage class
constexpr std::uint32_t op_decorate = 71;      // target, decoration
constexpr std::uint32_t op_type_last = 39;
constexpr std::uint32_t input_class = 1;
constexpr std::uint32_t fragment_model = 4;
constexpr std::uint32_t flat = 14;

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
  if (opcode >= op_type_void && opcode <= op_type_last && inputs.first_type == 0) inputs.first_type = at;
  switch (opcode) {
    case op_entry_point:
      inputs.fragment = inputs.fragment || word(1) == fragment_model;
      break;
    case op_decorate:
      if (word(2) == flat) inputs.flat_ids.insert(word(1));
      break;
    case op_type_int:
      inputs.integers.insert(word(1));
      break;
    case op_type_vector:
    case op_type_array:
      if (inputs.integers.count(word(2)) != 0) inputs.integers.insert(word(1));
      break;
    case op_type_pointer:
      if (word(2) == input_class && inputs.integers.count(word(3)) != 0) inputs.pointers.insert(word(1));
      break;
    case op_variable:
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
    decorations.insert(decorations.end(), {(3U << 16U) | op_decorate, id, flat});
  const auto place = module.begin() + static_cast<std::ptrdiff_t>(inputs.first_type);
  module.insert(place, decorations.begin(), decorations.end());
}

}  // namespace penumbra::shaders
