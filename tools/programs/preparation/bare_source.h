// A source without what a preprocessor reads in vain: comments, and the blanks that lines begin with.
//
// Every line keeps its number; columns change. A comment that begins in a directive and goes on over lines
// stays (the directive does not end with its line then), and so do `#include`, `#error`, `#pragma` and
// `#line`, whose text is their own.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::preparation {

std::string bare_source(std::string_view text);

}  // namespace penumbra::preparation
