// Values and variables as flat lists of scalar components, for data-flow analysis of assignments. Internal to
// this folder.
//
// float4 has 4 components, a struct those of its members in order, an array those of its elements. A type of
// more than `most_components` counts as one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "spirv/code.h"

namespace penumbra::lint {

constexpr std::size_t most_components = 256;

// A set of components.
using Components = std::vector<bool>;

bool all(const Components& set);
bool none(const Components& set);
void intersect(Components& into, const Components& other);

// Part of a variable or value: `count` components from `first`. Not exact for a dynamic index; then it spans
// every element that the index may select.
struct Part {
  std::size_t first = 0;
  std::size_t count = 0;
  spirv::Id type = 0;
  bool exact = true;
};

class ComponentLayout {
 public:
  explicit ComponentLayout(const spirv::Code& code) : code_(code) {}

  std::size_t count(spirv::Id type);

  // Returns the part of `whole` that one more index selects.
  Part select(const Part& whole, spirv::Id index_constant);
  Part select_literal(const Part& whole, std::uint32_t index);

  // The largest part that is missing as a whole, the first of several. Its path is ".uv.x" or "[2].color",
  // and empty when it is all of the type.
  struct Missing {
    std::string path;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  Missing first_missing(spirv::Id type, const Components& set);

 private:
  std::size_t uncapped(spirv::Id type);
  struct Parts {
    std::size_t number = 0;
    spirv::Id type = 0;  // type of every part; for structs see `member`
  };
  Parts parts(spirv::Id type) const;
  std::string step(spirv::Id type, std::size_t index) const;

  const spirv::Code& code_;
  std::map<spirv::Id, std::size_t> counts_;
};

// The function-local variables and pointer parameters of one function, and pointer analysis for them.
//
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
