// Reads small programs for the tests of this room as one file "a.shader".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "variants/keyword_space.h"
#include "variants/pragmas.h"

namespace penumbra::variants {

using Files = std::map<std::string, std::string>;

inline FindIncluded find_in(const Files& files) {
  return [files](const std::string& name, const std::string&) -> std::optional<IncludedText> {
    const auto found = files.find(name);
    if (found == files.end()) return std::nullopt;
    return IncludedText{found->first, found->second};
  };
}

inline Pragmas pragmas_of(const std::string& text, const Files& files = {},
                          const std::map<std::string, std::string>& defines = {}) {
  return read_pragmas({"a.shader", text, defines, find_in(files)});
}

// The messages as "a.shader:1:9: warning: ..." without the source line.
inline std::vector<std::string> messages_of(const Pragmas& pragmas) {
  std::vector<std::string> messages;
  for (hlsl::Diagnostic diagnostic : pragmas.diagnostics) {
    diagnostic.source_line.clear();
    messages.push_back(hlsl::format(diagnostic));
  }
  return messages;
}

// The sets as labels such as "_ A B".
inline std::vector<std::string> labels_of(const Pragmas& pragmas) {
  std::vector<std::string> labels;
  for (const KeywordSet& set : pragmas.keyword_sets) labels.push_back(label_of(set));
  return labels;
}

// The variants as texts such as "A C"; "-" is the one without keywords.
inline std::vector<std::string> texts_of(const VariantList& variants) {
  std::vector<std::string> texts;
  for (const Keywords& variant : variants) {
    std::string text;
    for (const std::string& keyword : variant) text += (text.empty() ? "" : " ") + keyword;
    texts.push_back(text.empty() ? "-" : text);
  }
  return texts;
}

}  // namespace penumbra::variants
