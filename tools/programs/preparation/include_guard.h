// The macro that keeps a file from being read twice: `#ifndef G`, `#define G`, ..., `#endif` around all of
// it.
//
// A preprocessor that knows it need not read the file again, as long as G is defined (GCC's manual of its
// preprocessor, "Once-Only Headers"). URP's headers come to each other by so many ways that most of what its
// preprocessor reads is such a file's second time.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace penumbra::preparation {

// Of a source without comments (bare_source.h); empty when there is none.
std::string include_guard(std::string_view bare);

// The macros that it undefines somewhere, whatever the conditions.
std::set<std::string> undefined_macros(std::string_view bare);

}  // namespace penumbra::preparation
