// A condition that every compiled variant satisfies: the one form that all narrowing of a keyword space
// takes.
//
//   never K            {when: K, any_of: {}}       no variant has K
//   K needs A or B     {when: K, any_of: {A, B}}   a variant with K has A or B
//   always K           {when: "", any_of: {K}}     every variant of a program that declares K has it
//   one of A, B        {when: "", any_of: {A, B}}  of a program that declares A or B (with whole: both) every
//                                                  variant has one of them
//   only A and B       the same, of_their_sets     the sets that hold A or B keep only A and B, and with
//                                                  or_none the empty keyword, too
#pragma once

#include <string>

#include "variants/keyword_set.h"

namespace penumbra::variants {

struct Clause {
  std::string when;
  Keywords any_of;
  bool whole = false;          // applies only to programs that declare every keyword of any_of
  bool of_their_sets = false;  // narrows each set on its own instead of the whole variant
  bool or_none = false;        // used with of_their_sets
  std::string said_by;         // its origin, for messages: "--keywords -A", "rules.json:3:5"
};

inline Clause never(const std::string& keyword, const std::string& said_by) {
  return {keyword, {}, false, false, false, said_by};
}
inline Clause always(const std::string& keyword, const std::string& said_by) {
  return {"", {keyword}, false, false, false, said_by};
}
inline Clause needs(const std::string& keyword, const Keywords& any_of, const std::string& said_by) {
  return {keyword, any_of, false, false, false, said_by};
}

}  // namespace penumbra::variants
