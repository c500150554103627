#include "shaders/block_types.h"

#include <algorithm>

namespace penumbra::shaders {

namespace {

constexpr std::uint32_t scalar_size = 4;
constexpr std::uint32_t vec4_size = 16;

std::uint32_t rounded_up(std::uint32_t value, std::uint32_t to) {
  return (value + to - 1) / to * to;
}

std::uint32_t vector_alignment(std::uint32_t components) {
  return scalar_size * (components == 3 ? 4 : components);
}

}  // namespace

BlockTypes::BlockTypes(const SpirvModule& module) {
  spirv::for_each_instruction(module, [this](spirv::Words instruction) { read(instruction); });
}

void BlockTypes::read(spirv::Words instruction) {
  const auto word = [&](std::size_t i) { return i < instruction.size() ? instruction[i] : 0; };
  BlockType type{spirv::opcode(instruction), word(2), word(3), 0, {}};
  switch (type.op) {
    case spv::OpDecorate:
      if (word(2) == spv::DecorationArrayStride) array_strides_[word(1)] = word(3);
      return;
    case spv::OpMemberDecorate:
      return decorate_member(instruction);
    case spv::OpConstant:
      if (instruction.size() == 4) constants_[word(2)] = word(3);
      return;
    case spv::OpTypeInt:
    case spv::OpTypeFloat:
      type.count = word(2);
      type.element = 0;
      break;
    case spv::OpTypeVector:
    case spv::OpTypeMatrix:
      break;
    case spv::OpTypeArray:
      type.count = constant(word(3)).value_or(0);
      type.array_stride = array_strides_[word(1)];
      break;
    case spv::OpTypeRuntimeArray:
      type.count = 0;
      type.array_stride = array_strides_[word(1)];
      break;
    case spv::OpTypeStruct:
      type.members = places_[word(1)];
      type.members.resize(instruction.size() - 2);
      for (std::size_t i = 0; i < type.members.size(); ++i) type.members[i].type = word(i + 2);
      break;
    default:
      return;
  }
  types_[word(1)] = std::move(type);
}

void BlockTypes::decorate_member(spirv::Words instruction) {
  if (instruction.size() < 4) return;
  std::vector<BlockMember>& members = places_[instruction[1]];
  constexpr std::uint32_t most_members = 1U << 16U;  // limit for a struct (SPIR-V specification, 2.17)
  if (instruction[2] >= most_members) return;
  if (members.size() <= instruction[2]) members.resize(instruction[2] + std::size_t{1});
  BlockMember& member = members[instruction[2]];
  if (instruction[3] == spv::DecorationRowMajor) member.row_major = true;
  if (instruction.size() < 5) return;
  if (instruction[3] == spv::DecorationOffset) member.offset = instruction[4];
  if (instruction[3] == spv::DecorationMatrixStride) member.matrix_stride = instruction[4];
}

const BlockType* BlockTypes::find(std::uint32_t id) const {
  const auto found = types_.find(id);
  return found == types_.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> BlockTypes::constant(std::uint32_t id) const {
  const auto found = constants_.find(id);
  return found == constants_.end() ? std::nullopt : std::optional(found->second);
}

bool BlockTypes::fits(std::uint32_t id, BlockRule rule) const {
  return structure(id, rule).fits;
}

bool BlockTypes::fills_tails(std::uint32_t id, bool of_rows) const {
  std::uint32_t end = 0;  // end of the last array, struct or matrix, including its padding
  for (const BlockMember& member : find(id)->members) {
    if (member.offset < end) return true;
    const BlockType* type = find(member.type);
    const bool has_tail =
        type != nullptr && (type->op == spv::OpTypeArray || type->op == spv::OpTypeStruct ||
                            (type->op == spv::OpTypeMatrix && (of_rows || !member.row_major)));
    if (has_tail) end = member.offset + extent(member, BlockRule::std140).size;
  }
  return false;
}

std::uint32_t BlockTypes::registers(std::uint32_t id) const {
  return structure(id, BlockRule::std140).size / vec4_size;
}

BlockTypes::Extent BlockTypes::structure(std::uint32_t id, BlockRule rule) const {
  Extent all;
  for (const BlockMember& member : find(id)->members) {
    const Extent one = extent(member, rule);
    all.fits = all.fits && one.fits && member.offset == rounded_up(all.size, one.alignment);
    all.alignment = std::max(all.alignment, one.alignment);
    all.size = std::max(all.size, member.offset + one.size);
  }
  if (rule == BlockRule::std140) all.alignment = rounded_up(all.alignment, vec4_size);
  all.size = rounded_up(all.size, all.alignment);
  return all;
}

// Columns or rows of a matrix are laid out like the elements of an array.
BlockTypes::Extent BlockTypes::vectors(const BlockMember& member, std::uint32_t components,
                                       std::uint32_t count, BlockRule rule) const {
  Extent all;
  all.alignment = vector_alignment(components);
  if (rule == BlockRule::std140) all.alignment = vec4_size;
  all.fits = member.matrix_stride == all.alignment;
  all.size = member.matrix_stride * count;
  return all;
}

BlockTypes::Extent BlockTypes::extent(const BlockMember& member, BlockRule rule) const {
  const BlockType* type = find(member.type);
  if (type == nullptr) return {1, 0, false};
  switch (type->op) {
    case spv::OpTypeInt:
    case spv::OpTypeFloat:
      return {type->count / 8, type->count / 8, true};
    case spv::OpTypeVector: {
      const std::uint32_t scale = find(type->element)->count / 32;
      return {vector_alignment(type->count) * scale, scalar_size * type->count * scale, scale != 0};
    }
    case spv::OpTypeMatrix: {
      const std::uint32_t rows = find(type->element)->count;
      return member.row_major ? vectors(member, type->count, rows, rule)
                              : vectors(member, rows, type->count, rule);
    }
    case spv::OpTypeArray:
    case spv::OpTypeRuntimeArray: {
      BlockMember element = member;
      element.type = type->element;
      Extent all = extent(element, rule);
      if (rule == BlockRule::std140) all.alignment = rounded_up(all.alignment, vec4_size);
      all.fits = all.fits && type->array_stride == rounded_up(all.size, all.alignment);
      all.size = type->array_stride * type->count;
      return all;
    }
    case spv::OpTypeStruct:
      return structure(member.type, rule);
    default:
      return {1, 0, false};
  }
}

}  // namespace penumbra::shaders
