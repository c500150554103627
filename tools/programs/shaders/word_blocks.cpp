#include "shaders/word_blocks.h"

#include <unordered_set>
#include <utility>

#include "hlsl/name_set.h"
#include "shaders/block_types.h"
#include "shaders/module_rewrite.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

// The part of a block that a pointer refers to, in words of 32 bits.

constexpr std::uint32_t word_bytes = 4;

struct BlockPlace {
  struct Term {
    std::uint32_t index;  // the id of a value known only at run time
    std::uint32_t words;
  };
  std::uint32_t variable = 0;  // the block's variable
  BlockMember value;           // its offset is not used
  std::uint32_t word = 0;
  std::uint32_t component_words = 1;  // words from one component of a vector to the next
  std::vector<Term> terms;            // index times words are added to `word`
};

// The components of a column in a row-major matrix are one row stride apart.
void move_to_part(BlockPlace& place, const BlockType& type) {
  if (type.op == spv::OpTypeMatrix)
    place.component_words = place.value.row_major ? place.value.matrix_stride / word_bytes : 1;
  place.value.type = type.element;
}

// Returns the stride from one part of a value to the next, in words; not for structs.
std::uint32_t part_stride(const BlockPlace& place, const BlockTypes& types) {
  const BlockType& type = *types.find(place.value.type);
  if (type.op == spv::OpTypeVector) return place.component_words;
  if (type.op == spv::OpTypeMatrix) return place.value.row_major ? 1 : place.value.matrix_stride / word_bytes;
  return type.array_stride / word_bytes;
}

// Selects part `number` of the value; returns false if it has no such part or one that is not aligned to a
// word.
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

// Selects the same for a dynamic index.
bool enter_part_at(BlockPlace& place, const BlockTypes& types, std::uint32_t index) {
  const BlockType* type = types.find(place.value.type);
  if (type == nullptr || type->element == 0 || type->op == spv::OpTypeStruct) return false;
  place.terms.push_back({index, part_stride(place, types)});
  move_to_part(place, *type);
  return true;
}

// Returns the number of components, columns, elements or members.
std::uint32_t part_count(const BlockType& type) {
  return type.op == spv::OpTypeStruct ? static_cast<std::uint32_t>(type.members.size()) : type.count;
}

// Returns the number of words of a value that consists of 32-bit numbers, if it is at most `most`; else more
// than `most`.
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

constexpr std::uint32_t register_words = 4;
constexpr std::uint32_t most_words = 4096;  // limit for a value that is read or written whole

using Words = ModuleRewrite::Words;

bool is_chain(spirv::Words one) {
  return spirv::opcode(one) == spv::OpAccessChain || spirv::opcode(one) == spv::OpInBoundsAccessChain;
}

// Returns whether the instruction takes a pointer and is not one that reads and writes.
bool passes_pointers(spv::Op op) {
  return (op >= spv::OpAtomicLoad && op <= spv::OpAtomicXor) ||
         hlsl::is_one_of(op, {spv::OpCopyMemory, spv::OpCopyObject, spv::OpFunctionCall, spv::OpPhi,
                              spv::OpSelect, spv::OpPtrAccessChain});
}

struct Block {
  std::uint32_t structure = 0;
  std::uint32_t storage = spv::StorageClassUniform;
  bool uniform = true;
};

class WordBlocks {
 public:
  WordBlocks(const SpirvModule& module, BlocksAsWords which)
      : module_(module), which_(which), types_(module), to_(module) {}

  std::optional<SpirvModule> run() {
    spirv::for_each_instruction(module_, [this](spirv::Words one) { find_block(one); });
    spirv::for_each_instruction(module_, [this](spirv::Words one) { check_use(one); });
    if (blocks_.empty() || refused_) return std::nullopt;
    spirv::for_each_instruction(module_, [this](spirv::Words one) { rewrite(one); });
    for (const auto& [variable, block] : blocks_) declare(variable, block);
    return to_.finished();
  }

 private:
  // The first pass finds the blocks that do not fit.
  void find_block(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (op == spv::OpDecorate && spirv::operand(one, 2) == spv::DecorationBlock)
      block_types_.insert(spirv::operand(one, 1));
    if (op == spv::OpDecorate && spirv::operand(one, 2) == spv::DecorationBufferBlock)
      buffer_types_.insert(spirv::operand(one, 1));
    if (op == spv::OpTypePointer)
      pointers_[spirv::operand(one, 1)] = {spirv::operand(one, 2), spirv::operand(one, 3)};
    if (op == spv::OpVariable) add_block(one);
  }

  void add_block(spirv::Words variable) {
    const auto pointer = pointers_.find(spirv::operand(variable, 1));
    if (pointer == pointers_.end()) return;
    const auto [storage, structure] = pointer->second;
    if (storage != spv::StorageClassUniform && storage != spv::StorageClassStorageBuffer) return;
    const bool buffer = storage == spv::StorageClassStorageBuffer || buffer_types_.count(structure) != 0;
    const BlockType* type = types_.find(structure);
    if (type == nullptr || type->op != spv::OpTypeStruct) return;
    if (!buffer && block_types_.count(structure) == 0) return;
    if (fits(structure, buffer)) return;
    const std::uint32_t id = spirv::operand(variable, 2);
    blocks_[id] = {structure, storage, !buffer};
    places_[id] = {id, {structure, 0, 0, false}, 0, 1, {}};
  }

  bool fits(std::uint32_t structure, bool buffer) const {
    switch (which_) {
      case BlocksAsWords::not_for_gl:
        return types_.fits(structure, buffer ? BlockRule::std430 : BlockRule::std140);
      case BlocksAsWords::overlapping_in_gl:
        return buffer || !types_.fills_tails(structure, true);
      case BlocksAsWords::not_for_vulkan:
        break;
    }
    return buffer ? types_.fits(structure, BlockRule::std430) : !types_.fills_tails(structure, false);
  }

  // The second pass checks how the pointers into them are used.
  void check_use(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (is_chain(one)) {
      follow(one);
    } else if (op == spv::OpLoad || op == spv::OpStore) {
      const auto place = places_.find(spirv::operand(one, op == spv::OpLoad ? 3 : 1));
      refused_ =
          refused_ || (place != places_.end() && word_count(place->second, types_, most_words) > most_words);
    } else if (passes_pointers(op)) {
      for (const std::uint32_t word : one.subspan(1)) refused_ = refused_ || places_.count(word) != 0;
    }
  }

  void follow(spirv::Words chain) {
    const auto base = places_.find(spirv::operand(chain, 3));
    if (base == places_.end()) return;
    BlockPlace place = base->second;
    for (std::size_t i = 4; i < chain.size() && !refused_; ++i) {
      const std::optional<std::uint32_t> number = types_.constant(chain[i]);
      refused_ = !(number ? enter_part(place, types_, *number) : enter_part_at(place, types_, chain[i]));
    }
    places_[spirv::operand(chain, 2)] = std::move(place);
  }

  // The third pass rewrites the accesses.
  void rewrite(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (op == spv::OpName || op == spv::OpMemberName) return keep_name(one);
    if (op == spv::OpVariable && blocks_.count(spirv::operand(one, 2)) != 0) return;
    if (is_chain(one) && places_.count(spirv::operand(one, 2)) != 0) return;
    if (op == spv::OpLoad && places_.count(spirv::operand(one, 3)) != 0) {
      const BlockPlace& place = places_.at(spirv::operand(one, 3));
      load(place, moved(place), spirv::operand(one, 2));
    } else if (op == spv::OpStore && places_.count(spirv::operand(one, 1)) != 0) {
      const BlockPlace& place = places_.at(spirv::operand(one, 1));
      store(place, moved(place), spirv::operand(one, 2));
    } else if (op == spv::OpArrayLength && blocks_.count(spirv::operand(one, 3)) != 0) {
      length(one);
    } else {
      to_.keep(one);
    }
  }

  // The new struct of a block has the old one's name; pointers into the old one are removed.
  void keep_name(spirv::Words one) {
    const std::uint32_t id = spirv::operand(one, 1);
    const bool structure = std::any_of(blocks_.begin(), blocks_.end(),
                                       [id](const auto& block) { return block.second.structure == id; });
    if (structure && spirv::opcode(one) == spv::OpName) names_[id].assign(one.begin() + 2, one.end());
    if (!structure && (places_.count(id) == 0 || blocks_.count(id) != 0)) to_.keep(one);
  }

  // The dynamic part of an offset, as an id; 0 for none.
  struct Moved {
    std::uint32_t registers = 0;
    std::uint32_t words = 0;
  };

  Moved moved(const BlockPlace& place) {
    const bool whole = blocks_.at(place.variable).uniform &&
                       std::all_of(place.terms.begin(), place.terms.end(), [](const BlockPlace::Term& term) {
                         return term.words % register_words == 0;
                       });
    std::uint32_t sum = 0;
    for (const BlockPlace::Term& term : place.terms) {
      const std::uint32_t factor = whole ? term.words / register_words : term.words;
      const std::uint32_t one =
          factor == 1 ? term.index : made(spv::OpIMul, {term.index, to_.uint_constant(factor)});
      sum = sum == 0 ? one : made(spv::OpIAdd, {sum, one});
    }
    return whole ? Moved{sum, 0} : Moved{0, sum};
  }

  std::uint32_t plus(std::uint32_t id, std::uint32_t number) {
    if (id == 0) return to_.uint_constant(number);
    return number == 0 ? id : made(spv::OpIAdd, {id, to_.uint_constant(number)});
  }

  std::uint32_t pointer(const BlockPlace& place, const Moved& by) {
    const Block& block = blocks_.at(place.variable);
    Words operands{place.variable, to_.uint_constant(0)};
    if (!block.uniform) {
      operands.push_back(plus(by.words, place.word));
    } else if (by.words == 0) {
      operands.push_back(plus(by.registers, place.word / register_words));
      operands.push_back(to_.uint_constant(place.word % register_words));
    } else {
      const std::uint32_t word = plus(by.words, place.word);
      operands.push_back(made(spv::OpShiftRightLogical, {word, to_.uint_constant(2)}));
      operands.push_back(made(spv::OpBitwiseAnd, {word, to_.uint_constant(register_words - 1)}));
    }
    return to_.result(spv::OpAccessChain, to_.type(spv::OpTypePointer, {block.storage, to_.uint_type()}),
                      operands);
  }

  std::uint32_t load(const BlockPlace& place, const Moved& by, std::uint32_t wanted = 0) {
    const BlockType& type = *types_.find(place.value.type);
    if (type.op == spv::OpTypeInt || type.op == spv::OpTypeFloat) {
      const std::uint32_t from = pointer(place, by);
      if (place.value.type == to_.uint_type())
        return to_.result(spv::OpLoad, to_.uint_type(), {from}, wanted);
      return to_.result(spv::OpBitcast, place.value.type, {made(spv::OpLoad, {from})}, wanted);
    }
    Words parts;
    for (std::uint32_t i = 0; i < part_count(type); ++i) {
      BlockPlace part = place;
      enter_part(part, types_, i);
      parts.push_back(load(part, by));
    }
    return to_.result(spv::OpCompositeConstruct, place.value.type, parts, wanted);
  }

  void store(const BlockPlace& place, const Moved& by, std::uint32_t value) {
    const BlockType& type = *types_.find(place.value.type);
    if (type.op == spv::OpTypeInt || type.op == spv::OpTypeFloat) {
      const bool plain = place.value.type == to_.uint_type();
      const std::uint32_t word = plain ? value : made(spv::OpBitcast, {value});
      return to_.code(spv::OpStore, {pointer(place, by), word});
    }
    for (std::uint32_t i = 0; i < part_count(type); ++i) {
      BlockPlace part = place;
      enter_part(part, types_, i);
      store(part, by, to_.result(spv::OpCompositeExtract, part.value.type, {value, i}));
    }
  }

  // Returns the number of elements of the array at a buffer's end.
  void length(spirv::Words one) {
    BlockPlace array = places_.at(spirv::operand(one, 3));
    enter_part(array, types_, spirv::operand(one, 4));
    const std::uint32_t words = made(spv::OpArrayLength, {spirv::operand(one, 3), 0});
    const std::uint32_t behind = made(spv::OpISub, {words, to_.uint_constant(array.word)});
    const std::uint32_t stride = to_.uint_constant(std::max(part_stride(array, types_), 1U));
    to_.result(spv::OpUDiv, to_.uint_type(), {behind, stride}, spirv::operand(one, 2));
  }

  std::uint32_t made(spv::Op op, const Words& operands) { return to_.result(op, to_.uint_type(), operands); }

  void declare(std::uint32_t variable, const Block& block) {
    const std::uint32_t element =
        block.uniform ? to_.type(spv::OpTypeVector, {to_.uint_type(), register_words}) : to_.uint_type();
    const std::uint32_t array =
        block.uniform
            ? to_.new_type(spv::OpTypeArray, {element, to_.uint_constant(types_.registers(block.structure))})
            : to_.new_type(spv::OpTypeRuntimeArray, {element});
    const std::uint32_t structure = to_.new_type(spv::OpTypeStruct, {array});
    const std::uint32_t pointer = to_.new_type(spv::OpTypePointer, {block.storage, structure});
    to_.global(spv::OpVariable, {pointer, variable, block.storage});
    to_.decoration(spv::OpDecorate,
                   {array, spv::DecorationArrayStride, word_bytes * (block.uniform ? register_words : 1)});
    to_.decoration(spv::OpMemberDecorate, {structure, 0, spv::DecorationOffset, 0});
    const bool old_buffer = buffer_types_.count(block.structure) != 0;
    to_.decoration(spv::OpDecorate,
                   {structure, old_buffer ? spv::DecorationBufferBlock : spv::DecorationBlock});
    copy_access(block.structure, structure);
    name(block.structure, structure);
  }

  // Copies NonWritable and similar decorations.
  void copy_access(std::uint32_t from, std::uint32_t to) {
    spirv::for_each_instruction(module_, [&](spirv::Words one) {
      if (spirv::opcode(one) != spv::OpMemberDecorate || one.size() != 4 || one[1] != from || one[2] != 0)
        return;
      const bool access = one[3] == spv::DecorationNonWritable || one[3] == spv::DecorationNonReadable ||
                          one[3] == spv::DecorationCoherent || one[3] == spv::DecorationVolatile;
      if (access) to_.decoration(spv::OpMemberDecorate, {to, 0, one[3]});
    });
  }

  void name(std::uint32_t from, std::uint32_t to) {
    Words operands{to};
    const Words& own = names_[from];
    operands.insert(operands.end(), own.begin(), own.end());
    if (!own.empty()) to_.name(spv::OpName, operands);
    constexpr std::uint32_t letters_word = 0x64726F77;
    to_.name(spv::OpMemberName, {to, 0, letters_word, 's'});
  }

  const SpirvModule& module_;
  BlocksAsWords which_;
  const BlockTypes types_;
  ModuleRewrite to_;
  bool refused_ = false;
  std::unordered_set<std::uint32_t> block_types_;
  std::unordered_set<std::uint32_t> buffer_types_;
  // The storage class and the pointee of each pointer type.
  std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> pointers_;
  std::map<std::uint32_t, Block> blocks_;                 // by variable
  std::unordered_map<std::uint32_t, BlockPlace> places_;  // by pointer
  std::unordered_map<std::uint32_t, Words> names_;        // names of the blocks' structs
};

}  // namespace

std::optional<SpirvModule> with_word_blocks(const SpirvModule& module, BlocksAsWords which) {
  if (module.size() < spirv::header_words) return std::nullopt;
  return WordBlocks(module, which).run();
}

}  // namespace penumbra::shaders
