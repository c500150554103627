// Rewrites a module instruction by instruction, adding types, constants, decorations and code. Each is placed
// in the section that SPIR-V requires (specification, 2.4). Internal to this folder.
#pragma once

#include <map>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

class ModuleRewrite {
 public:
  using Words = std::vector<std::uint32_t>;

  explicit ModuleRewrite(const SpirvModule& module);

  std::uint32_t new_id() { return next_++; }

  // Copies an instruction unchanged; called in the order of the module.
  void keep(spirv::Words instruction);

  // Appends an instruction; returns its result id, which is a new one unless one is given.
  std::uint32_t result(spv::Op op, std::uint32_t type, const Words& operands, std::uint32_t wanted = 0);
  void code(spv::Op op, const Words& operands);

  // Returns a type that must be unique: the existing one, or a new one.
  std::uint32_t type(spv::Op op, const Words& operands);
  // Adds a type that need not be unique.
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
  std::uint32_t next_;  // the next free id
  bool types_begun_ = false;
  bool functions_begun_ = false;
  std::map<Words, std::uint32_t> types_;  // by opcode and operands
  std::map<std::uint32_t, std::uint32_t> constants_;
  SpirvModule head_, names_, annotations_, decorations_, globals_, functions_;
};

}  // namespace penumbra::shaders
