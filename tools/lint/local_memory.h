// The function-local variables and pointer parameters of one function, and which of them a pointer means.
// Internal to this room.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "lint/components.h"
#include "lint/spirv_code.h"

namespace penumbra::lint {

struct LocalVariable {
  Id id = 0;
  Id type = 0;            // of what it holds
  std::size_t first = 0;  // its components in a row of all of them
  std::size_t count = 0;
  int parameter = -1;  // its position when it is one
  bool initialised = false;
  bool copy_for_call = false;  // glslang's "param": holds one argument for the length of a call
  Components stored;           // components that something in the function stores to
};

struct LocalPointer {
  std::size_t variable = 0;  // index
  Part part;                 // counted from the variable's first component
};

class LocalMemory {
 public:
  LocalMemory(const SpirvCode& code, const Function& function, ComponentLayout& layout);

  const std::vector<LocalVariable>& variables() const { return variables_; }
  std::size_t components() const { return components_; }
  const LocalPointer* pointer(Id id) const;

  // Instructions of the function that use a value, by its id.
  const std::vector<const Instruction*>& uses(Id value) const;

 private:
  void add(Id id, Id pointer_type, int parameter, bool initialised);
  void note_store(Id target);
  void follow(const Instruction& chain, ComponentLayout& layout);

  const SpirvCode& code_;
  ComponentLayout& layout_;
  std::vector<LocalVariable> variables_;
  std::map<Id, LocalPointer> pointers_;
  std::map<Id, std::vector<const Instruction*>> uses_;
  std::size_t components_ = 0;
};

}  // namespace penumbra::lint
