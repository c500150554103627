// The function-local variables and pointer parameters of one function, and pointer analysis for them.
// Internal to this folder.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "lint/components.h"
#include "spirv/code.h"

namespace penumbra::lint {

struct LocalVariable {
  spirv::Id id = 0;
  spirv::Id type = 0;     // type of its contents
  std::size_t first = 0;  // its first component in the list of all of them
  std::size_t count = 0;
  int parameter = -1;  // its position if it is a parameter
  bool initialised = false;
  bool copy_for_call = false;  // glslang's "param": a copy of an argument for the duration of a call
  Components stored;           // components that something in the function stores to
};

struct LocalPointer {
  std::size_t variable = 0;  // index
  Part part;                 // counted from the variable's first component
};

class LocalMemory {
 public:
  LocalMemory(const spirv::Code& code, const spirv::Function& function, ComponentLayout& layout);

  const std::vector<LocalVariable>& variables() const { return variables_; }
  std::size_t components() const { return components_; }
  const LocalPointer* pointer(spirv::Id id) const;

  // Returns the instructions of the function that use a value, by its id.
  const std::vector<const spirv::Instruction*>& uses(spirv::Id value) const;

 private:
  void add(spirv::Id id, spirv::Id pointer_type, int parameter, bool initialised);
  void note_store(spirv::Id target);
  void follow(const spirv::Instruction& chain, ComponentLayout& layout);

  const spirv::Code& code_;
  ComponentLayout& layout_;
  std::vector<LocalVariable> variables_;
  std::map<spirv::Id, LocalPointer> pointers_;
  std::map<spirv::Id, std::vector<const spirv::Instruction*>> uses_;
  std::size_t components_ = 0;
};

}  // namespace penumbra::lint
