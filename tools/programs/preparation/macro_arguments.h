// Macro arguments that are written as one and expand to several.
//
// The preprocessor of C counts the arguments of a call as they are written; Unity's lets `SAMPLE(map, UV)`
// pass where UV stands for `uv, slice` and SAMPLE has three parameters. Such calls are said in two steps,
// which every preprocessor takes alike: with
//     #define penumbra_spread_SAMPLE(arguments) SAMPLE arguments
// `SAMPLE(map, UV)` is written `penumbra_spread_SAMPLE((map, UV))`: its one argument is expanded first, and
// SAMPLE is called with what came of it.
//
// Only calls that have too few arguments as they stand are written so, of macros that a preprocessor has
// complained of and of names that stand for them (`#define SAMPLE_LIGHTMAP SAMPLE`); those in the bodies of
// other macros are among them. No line moves. A call that has enough keeps C's meaning.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace penumbra::preparation {

class MacroArguments {
 public:
  // Takes in what a text defines, whatever the conditions around it.
  void read(const std::string& text);
  // The macro was called with too few arguments.
  void spread(const std::string& macro) { spread_.insert(macro); }
  // After either: finds the calls that are to be written in two steps. False when they are those of before.
  bool settle();

  // The names whose calls are written in two steps, each with the most parameters it may have.
  const std::map<std::string, std::size_t>& names() const { return names_; }
  std::string definitions() const;  // what has to stand before any text
  std::string rewritten(const std::string& text) const;

 private:
  std::map<std::string, std::size_t> parameters_;         // of macros that have a list of them
  std::map<std::string, std::set<std::string>> aliases_;  // what stands for a name
  std::set<std::string> spread_;
  std::map<std::string, std::size_t> names_;
};

}  // namespace penumbra::preparation
