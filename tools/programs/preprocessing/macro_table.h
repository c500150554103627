// Macros and the conditions of #if that a reader of directives alone asks for.
#pragma once

#include <deque>
#include <set>
#include <string>
#include <string_view>

#include "preprocessing/expansion.h"

namespace penumbra::preprocessing {

struct Condition {
  bool holds = false;
  std::string problem;              // empty if the whole condition was evaluated
  std::set<std::string> consulted;  // every identifier that was looked up, defined or not
};

class MacroTable {
 public:
  MacroTable();
  MacroTable(const MacroTable&) = delete;
  MacroTable& operator=(const MacroTable&) = delete;

  // `definition` follows #define: "NAME 1", "NAME(x) x". One that is no definition is ignored.
  void define(std::string_view definition);
  void undefine(std::string_view name) { macros_.undefine(spellings_.number(name)); }
  bool is_defined(std::string_view name) { return macros_.is_defined(spellings_.number(name)); }

  // Evaluates the text that follows #if. The work of all conditions of one table is limited.
  Condition evaluate(std::string_view condition);

 private:
  Spellings spellings_;
  Macros macros_;
  Expansion expansion_{spellings_, macros_};
  std::deque<CutSource> definitions_;  // elements never move: macros_ refers to them
  std::set<Spelling> consulted_;
};

}  // namespace penumbra::preprocessing
