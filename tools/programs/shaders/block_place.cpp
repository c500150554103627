#include "shaders/block_place.h"

namespace penumbra::shaders {

namespace {

// The components of a column in a row-major matrix are one row stride apart.
void move_to_part(BlockPlace& place, const BlockType& type) {
  if (type.op == spv::OpTypeMatrix)
    place.component_words = place.value.row_major ? place.value.matrix_stride / word_bytes : 1;
  place.value.type = type.element;
}

}  // namespace

std::uint32_t part_stride(const BlockPlace& place, const BlockTypes& types) {
  const BlockType& type = *types.find(place.value.type);
  if (type.op == spv::OpTypeVector) return place.component_words;
  if (type.op == spv::OpTypeMatrix) return place.value.row_major ? 1 : place.value.matrix_stride / word_bytes;
  return type.array_stride / word_bytes;
}

bool enter_part(BlockPlace& place, const BlockTypes& types, std::uint32_t number) {
  const BlockType* type = types.find(place.value.type);
  if (type == nullptr) return false;
  if (type->op == spv::OpTypeStruct) {
    if (number >= type->members.size()) return false;
    place.value = type->members[number];
    place.word += place.value.offset / word_bytes;
    return place.value.offset % word_bytes == 0;
  }
  if (type->element == 0) return false;
  place.word += number * part_stride(place, types);
  move_to_part(place, *type);
  return true;
}

bool enter_part_at(BlockPlace& place, const BlockTypes& types, std::uint32_t index) {
  const BlockType* type = types.find(place.value.type);
  if (type == nullptr || type->element == 0 || type->op == spv::OpTypeStruct) return false;
  place.terms.push_back({index, part_stride(place, types)});
  move_to_part(place, *type);
  return true;
}

std::uint32_t part_count(const BlockType& type) {
  return type.op == spv::OpTypeStruct ? static_cast<std::uint32_t>(type.members.size()) : type.count;
}

std::uint32_t word_count(const BlockPlace& place, const BlockTypes& types, std::uint32_t most) {
  const BlockType* type = types.find(place.value.type);
  if (type == nullptr || type->op == spv::OpTypeRuntimeArray) return most + 1;
  if (type->op == spv::OpTypeInt || type->op == spv::OpTypeFloat)
    return type->count == word_bytes * 8 ? 1 : most + 1;
  std::uint32_t words = 0;
  for (std::uint32_t i = 0; i < part_count(*type) && words <= most; ++i) {
    BlockPlace part = place;
    words += enter_part(part, types, i) ? word_count(part, types, most) : most + 1;
  }
  return words;
}

}  // namespace penumbra::shaders
