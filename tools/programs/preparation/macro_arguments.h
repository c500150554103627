// Macro arguments that are written as one and expand to several.
//
// C counts the arguments of a macro call before expansion; Unity's preprocessor accepts `SAMPLE(map, UV)` if
// UV expands to `uv, slice` and SAMPLE has three parameters. Such calls are rewritten to two steps, which
// every preprocessor expands alike: with
//     #define penumbra_spread_SAMPLE(arguments) SAMPLE arguments
// `SAMPLE(map, UV)` becomes `penumbra_spread_SAMPLE((map, UV))`: its single argument is expanded first, then
// SAMPLE is called with the result.
//
// Only calls with too few arguments are rewritten, of macros for which the preprocessor has reported an error
// and of their aliases (`#define SAMPLE_LIGHTMAP SAMPLE`), including calls in the bodies of other macros.
// Line numbers do not change. A call with enough arguments keeps its meaning in C.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace penumbra::preparation {

class MacroArguments {
 public:
  // Records a text's definitions, whatever the conditions around them.
  void read(const std::string& text);
  // The macro was called with too few arguments.
  void spread(const std::string& macro) { spread_.insert(macro); }
  // Called after either: finds the calls to rewrite. Returns false if they are the same as before.
  bool settle();

  // Returns the names whose calls are rewritten, each with its largest number of parameters.
  const std::map<std::string, std::size_t>& names() const { return names_; }
  std::string definitions() const;  // text to put before any other
  std::string rewritten(const std::string& text) const;

 private:
  std::map<std::string, std::size_t> parameters_;         // function-like macros
  std::map<std::string, std::set<std::string>> aliases_;  // the aliases of a name
  std::set<std::string> spread_;
  std::map<std::string, std::size_t> names_;
};

// Macros that refer to themselves: `#define _Color ACCESS(Props, _Color)`.
//
// A name in the expansion of its own macro is not expanded again (C standard 6.10.3.4). glslang forgets this
// once the expansion has passed through the argument of another macro, and silently expands it again for each
// one. So the name is marked in its macro's body; a marked name is not a macro's name. The marks are removed
// from the preprocessor's output.
//
// A name beside ## is not marked, because it becomes part of another one. Line numbers do not change.
std::string with_own_names_marked(std::string text);  // called for a source, before preprocessing
std::string without_marks(std::string text);          // called for the preprocessor's output

}  // namespace penumbra::preparation
