// A module that is written anew, instruction by instruction, with types, constants, decorations and code that
// were not in it. Each goes where SPIR-V wants it (specification, 2.4). Internal to this room.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <vector>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

class ModuleRewrite {
 public:
  using Words = std::vector<std::uint32_t>;

  explicit ModuleRewrite(const SpirvModule& module);

  std::uint32_t new_id() { return next_++; }

  // As it stands, in the order of the module.
  void keep(spirv::Words instruction);

  // Code, at the end of what is there so far; the id of its result, which is a new one unless one is wanted.
  std::uint32_t result(spv::Op op, std::uint32_t type, const Words& operands, std::uint32_t wanted = 0);
  void code(spv::Op op, const Words& operands);

  // A type that a module has once: the one that is there, or a new one.
  std::uint32_t type(spv::Op op, const Words& operands);
  // A type of its own.
  std::uint32_t new_type(spv::Op op, const Words& operands);
  std::uint32_t uint_type();
  std::uint32_t uint_constant(std::uint32_t value);
  std::uint32_t constant(spv::Op op, std::uint32_t type, const Words& operands);  // a new one

  void global(spv::Op op, const Words& operands);
  void decoration(spv::Op op, const Words& operands);
  void name(spv::Op op, const Words& operands);

  SpirvModule finished() const;

 private:
  const SpirvModule& module_;
  std::uint32_t next_;  // id that is free
  bool types_begun_ = false;
  bool functions_begun_ = false;
  std::map<Words, std::uint32_t> types_;  // by opcode and operands
  std::map<std::uint32_t, std::uint32_t> constants_;
  SpirvModule head_, names_, annotations_, decorations_, globals_, functions_;
};

}  // namespace penumbra::shaders
