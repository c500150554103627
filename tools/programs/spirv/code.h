// A SPIR-V module as the rules traverse it: instructions with their source lines, definitions by id,
// functions and their basic blocks.
//
// Read once in linear time by SPIRV-Tools' parser; OpLine sets the location of the instructions after it;
// nothing is interpreted beyond each instruction's layout in the specification
// (https://registry.khronos.org/SPIR-V/specs/unified1/SPIRV.html).
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "spirv/words.h"

namespace penumbra::spirv {

using Id = std::uint32_t;

// The source location that OpLine gives; line 0 means none.
struct Place {
  Id file = 0;  // an OpString
  int line = 0;
};

struct Instruction {
  spv::Op op = spv::OpNop;
  Id type = 0;
  Id result = 0;
  std::span<const std::uint32_t> operands;  // the operands after type and result
  Place place;
  std::size_t ids_begin = 0;  // see Code::ids
  std::size_t ids_end = 0;
};

struct Block {
  Id label = 0;
  std::size_t begin = 0;  // the first instruction after the label; indices into Code::instructions()
  std::size_t end = 0;    // the index after the terminator
};

struct Function {
  std::vector<Id> parameters;
  std::vector<Block> blocks;  // the first is the entry
};

class Code {
 public:
  // Throws std::invalid_argument if the words are not valid SPIR-V.
  explicit Code(std::vector<std::uint32_t> words);
  Code(const Code&) = delete;
  Code& operator=(const Code&) = delete;

  const std::vector<Instruction>& instructions() const { return instructions_; }
  const std::vector<Function>& functions() const { return functions_; }
  std::size_t id_bound() const { return definitions_.size(); }

  // Returns the operands that are ids, not literals.
  std::span<const Id> ids(const Instruction& instruction) const {
    return std::span(ids_).subspan(instruction.ids_begin, instruction.ids_end - instruction.ids_begin);
  }

  // Returns null if the id is not defined.
  const Instruction* definition(Id id) const;
  spv::Op op(Id id) const;  // OpNop for an unknown id
  const Function* function(Id id) const;

  std::string name(Id id) const;
  std::string member_name(Id type, std::uint32_t member) const;
  std::string file_name(Id file) const;
  // Returns the first literal of the decoration, 0 if it has none; nothing if the id does not have the
  // decoration.
  std::optional<std::uint32_t> decoration(Id id, spv::Decoration kind) const;
  std::optional<std::uint32_t> member_decoration(Id type, std::uint32_t member, spv::Decoration kind) const;

  // These return the type that a pointer points to, and its storage class.
  Id pointee(Id pointer_type) const;
  std::optional<spv::StorageClass> storage_class(Id pointer_type) const;
  // Returns the value of an integer OpConstant (sign extended), nothing for anything else.
  std::optional<std::int64_t> integer(Id id) const;

 private:
  friend struct SpirvReader;
  using DecorationKey = std::pair<std::uint64_t, std::uint32_t>;  // id << 32 | member + 1, kind

  std::vector<std::uint32_t> words_;
  std::vector<Instruction> instructions_;
  std::vector<Id> ids_;
  std::vector<std::uint32_t> definitions_;  // for each id: index into instructions_ + 1, 0 for none
  std::vector<Function> functions_;
  std::map<Id, std::size_t> function_index_;
  std::map<std::uint64_t, std::string> names_;  // id << 32 | member + 1, or id << 32 for the id itself
  std::map<Id, std::string> strings_;
  std::map<DecorationKey, std::uint32_t> decorations_;
};

}  // namespace penumbra::spirv
