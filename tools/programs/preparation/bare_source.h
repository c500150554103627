// A source without comments and indentation, which cost the preprocessor time and have no effect.
//
// Every line keeps its number; columns change. A comment that begins in a directive and continues on further
// lines is kept (it extends the directive), and so are `#include`, `#error`, `#pragma` and `#line`, whose
// text matters.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace penumbra::preparation {

std::string bare_source(std::string_view text);

// The include guard of a file: `#ifndef G`, `#define G`, ..., `#endif` around all of it.
//
// A preprocessor that knows it need not read the file again while G is defined (GCC's preprocessor manual,
// "Once-Only Headers"). URP's headers include each other so often that most files are read repeatedly.
//
// Returns the guard of a source without comments (bare_source.h); empty if there is none.
std::string include_guard(std::string_view bare);

// Returns the macros that the source undefines anywhere, whatever the conditions.
std::set<std::string> undefined_macros(std::string_view bare);

}  // namespace penumbra::preparation
