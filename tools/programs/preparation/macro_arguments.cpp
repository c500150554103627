#include "preparation/macro_arguments.h"

#include <algorithm>
#include <utility>

#include "preparation/macro_text.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view prefix = "penumbra_spread_";

bool opens(std::string_view token) {
  return token == "(" || token == "[" || token == "{";
}

bool closes(std::string_view token) {
  return token == ")" || token == "]" || token == "}";
}

struct Call {
  std::size_t close = 0;  // the token that ends it
  std::size_t arguments = 1;
};

// Returns for each '(' of the text the call that it would open; `close` is 0 if it is not closed within its
// region.
std::vector<Call> read_calls(const std::vector<MacroToken>& tokens) {
  std::vector<Call> calls(tokens.size());
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (at > 0 && tokens[at].region != tokens[at - 1].region) open.clear();
    const std::string_view token = tokens[at].spelling;
    if (opens(token)) {
      open.push_back(at);
    } else if (token == "," && !open.empty()) {
      ++calls[open.back()].arguments;
    } else if (closes(token) && !open.empty()) {
      calls[open.back()].close = at;
      open.pop_back();
    }
  }
  return calls;
}

constexpr std::string_view mark = "penumbra_own_";

bool beside_paste(const std::vector<MacroToken>& tokens, std::size_t at, const MacroDefinition& of) {
  const bool before = at > of.body_begin && tokens[at - 1].spelling == "#";
  const bool after = at + 1 < of.body_end && tokens[at + 1].spelling == "#";
  return before || after;
}

}  // namespace

void MacroArguments::read(const std::string& text) {
  const MacroText macros = read_macro_text(text);
  for (const MacroDefinition& definition : macros.definitions) {
    const std::string name(definition.name);
    if (definition.parameters) {
      std::size_t& most = parameters_[name];
      most = std::max(most, *definition.parameters);
    } else if (definition.body_end > definition.body_begin) {
      aliases_[std::string(macros.tokens[definition.body_end - 1].spelling)].insert(name);
    }
  }
}

// Each macro is followed by its aliases, their aliases, and so on.
bool MacroArguments::settle() {
  std::map<std::string, std::size_t> names;
  for (const std::string& macro : spread_) {
    const auto parameters = parameters_.find(macro);
    if (parameters == parameters_.end()) continue;
    std::vector<std::string> waiting{macro};
    while (!waiting.empty()) {
      const std::string name = std::move(waiting.back());
      waiting.pop_back();
      std::size_t& most = names[name];
      if (most >= parameters->second) continue;
      most = parameters->second;
      const auto aliases = aliases_.find(name);
      if (aliases != aliases_.end())
        waiting.insert(waiting.end(), aliases->second.begin(), aliases->second.end());
    }
  }
  const bool changed = names != names_;
  names_ = std::move(names);
  return changed;
}

std::string MacroArguments::definitions() const {
  std::string text;
  for (const auto& [name, parameters] : names_)
    text.append("#define ")
        .append(prefix)
        .append(name)
        .append("(arguments) ")
        .append(name)
        .append(" arguments\n");
  return text;
}

std::string MacroArguments::rewritten(const std::string& text) const {
  if (names_.empty()) return text;
  const std::vector<MacroToken> tokens = read_macro_text(text).tokens;
  const std::vector<Call> calls = read_calls(tokens);
  std::vector<std::pair<std::size_t, std::string_view>> inserts;
  for (std::size_t at = 0; at + 1 < tokens.size(); ++at) {
    const Call& call = calls[at + 1];
    const bool is_call = tokens[at + 1].spelling == "(" && tokens[at].region == tokens[at + 1].region;
    if (!is_call || call.close == 0) continue;
    const auto name = names_.find(std::string(tokens[at].spelling));
    if (name == names_.end() || call.arguments >= name->second) continue;
    inserts.emplace_back(tokens[at].offset, prefix);
    inserts.emplace_back(tokens[at + 1].offset, "(");
    inserts.emplace_back(tokens[call.close].offset, ")");
  }
  std::sort(inserts.begin(), inserts.end());
  std::string out;
  std::size_t from = 0;
  for (const auto& [offset, inserted] : inserts) {
    out.append(text, from, offset - from).append(inserted);
    from = offset;
  }
  return out.append(text, from, std::string::npos);
}

std::string with_own_names_marked(std::string text) {
  const MacroText read = read_macro_text(text);
  std::string out;
  std::size_t from = 0;
  for (const MacroDefinition& definition : read.definitions) {
    for (std::size_t at = definition.body_begin; at < definition.body_end; ++at) {
      const MacroToken& token = read.tokens[at];
      if (token.spelling != definition.name || beside_paste(read.tokens, at, definition)) continue;
      out.append(text, from, token.offset - from).append(mark);
      from = token.offset;
    }
  }
  if (from == 0) return text;
  return out.append(text, from, std::string::npos);
}

std::string without_marks(std::string text) {
  std::size_t at = text.find(mark);
  if (at == std::string::npos) return text;
  std::string out;
  std::size_t from = 0;
  for (; at != std::string::npos; at = text.find(mark, from)) {
    out.append(text, from, at - from);
    from = at + mark.size();
  }
  return out.append(text, from, std::string::npos);
}

}  // namespace penumbra::preparation
