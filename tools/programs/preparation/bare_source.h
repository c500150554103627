// A source without comments and indentation, which cost the preprocessor time and have no effect.
//
// Every line keeps its number; columns change. A comment that begins in a directive and continues on further
// lines is kept (it extends the directive), and so are `#include`, `#error`, `#pragma` and `#line`, whose
// text matters.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::preparation {

std::string bare_source(std::string_view text);

}  // namespace penumbra::preparation
