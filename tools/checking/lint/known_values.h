// A test whether a compiler that inlines functions and unrolls loops knows a value. Internal to this folder.
//
// Such a compiler knows values that are computed from constants alone, loop counters among them. It decides
// what FXC makes of conditions: FXC removes those that it knows. Only data flow is followed, so "known" may
// be wrong where a branch on something unknown chooses among constants.
#pragma once

#include <map>
#include <vector>

#include "spirv/code.h"

namespace penumbra::lint {

// Returns the variable or parameter that a pointer points into.
spirv::Id base_of(const spirv::Code& code, spirv::Id pointer);

class KnownValues {
 public:
  // `code` is a module before inlining, which must outlive this object.
  explicit KnownValues(const spirv::Code& code);

  bool known(spirv::Id value) const;

 private:
  bool comes_from_outside(const spirv::Instruction& definition) const;

  const spirv::Code& code_;
  // The values that are stored to each variable or parameter, and the arguments of calls.
  std::map<spirv::Id, std::vector<spirv::Id>> stored_;
  std::map<spirv::Id, std::vector<spirv::Id>> given_;
};

}  // namespace penumbra::lint
