// Values and variables as flat lists of scalar components, for data-flow analysis of assignments. Internal to
// this folder.
//
// float4 has 4 components, a struct those of its members in order, an array those of its elements. A type of
// more than `most_components` counts as one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
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

}  // namespace penumbra::lint
