#include <regex>

#include "architecture/rules.h"
#include "architecture/source_lines.h"

namespace penumbra::architecture {
namespace {

Violations lines_with(const Tree& tree, const std::regex& pattern, const std::string& why) {
  Violations found;
  for (const auto& [path, text] : tree) {
    for_each_line(text, [&, &file = path](int number, const std::string& line) {
      std::smatch match;
      if (std::regex_search(line, match, pattern))
        found.push_back(violation(file, number, why + ": " + match.str()));
    });
  }
  return found;
}

}  // namespace

// The patterns are written so that they do not match themselves: this file is in the tree, too.

Violations nothing_is_unfinished(const Tree& tree) {
  static const std::regex words("\\b(TO[D]O|FIX[M]E|X[X]X|HA[C]K)\\b");
  return lines_with(tree, words, "unfinished");
}

Violations nothing_names_a_machine(const Tree& tree) {
  static const std::regex places(
      "(^|[^\\w.~}])/(wor[k]|hom[e]|roo[t]|Use[r]s)/|[A-Z]:\\\\+User[s]|"
      "registry\\.npm[j]s|pyp[i]\\.org|pythonho[s]ted|proxy\\.go[l]ang|crate[s]\\.io|artifa[c]tory");
  return lines_with(tree, places, "names a machine");
}

}  // namespace penumbra::architecture
