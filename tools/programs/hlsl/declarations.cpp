#include "hlsl/declarations.h"

#include <span>

#include "hlsl/name_set.h"

namespace penumbra::hlsl {

namespace {

using Tokens = std::span<const Token>;

bool is(const Token& token, std::string_view spelling) {
  return token.spelling == spelling;
}

bool opens(const Token& token) {
  if (token.kind != Token::Kind::punctuation) return false;
  const char lead = token.spelling[0];
  return lead == '(' || lead == '[' || lead == '{';
}
bool closes(const Token& token) {
  if (token.kind != Token::Kind::punctuation) return false;
  const char lead = token.spelling[0];
  return lead == ')' || lead == ']' || lead == '}';
}
bool match(const Token& open, const Token& close) {
  const char lead = open.spelling[0];
  return close.spelling[0] == (lead == '(' ? ')' : lead == '[' ? ']' : '}');
}

// Returns for every opening bracket the index of its match; 0 if there is none, and for all after an
// unmatched closing bracket.
std::vector<std::uint32_t> closing_brackets(Tokens tokens) {
  std::vector<std::uint32_t> closing(tokens.size(), 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t at = 0; at < tokens.size(); ++at) {
    if (opens(tokens[at])) {
      open.push_back(at);
    } else if (closes(tokens[at])) {
      if (open.empty() || !match(tokens[open.back()], tokens[at])) break;
      closing[open.back()] = at;
      open.pop_back();
    }
  }
  return closing;
}

// These keywords may precede a parameter's type without being part of it. `in` is the default.
bool is_modifier(const Token& token) {
  static constexpr NameSet modifiers("in", "const", "uniform", "precise", "static", "linear", "centroid",
                                     "nointerpolation", "noperspective", "sample", "row_major",
                                     "column_major", "snorm", "unorm", "volatile");
  return modifiers.contains(token.spelling);
}

// Returns one parameter without its name, default value and semantic.
std::string parameter_type(Tokens tokens) {
  std::string type;
  std::size_t i = 0;
  for (; i < tokens.size() && (is_modifier(tokens[i]) || is(tokens[i], "out") || is(tokens[i], "inout"));
       ++i) {
    if (!is_modifier(tokens[i])) type += std::string(tokens[i].spelling) + " ";
  }
  if (i < tokens.size()) type += tokens[i++].spelling;
  for (; i + 1 < tokens.size() && is(tokens[i], ":") && is(tokens[i + 1], ":"); i += 3)
    type += "::" + std::string(i + 2 < tokens.size() ? tokens[i + 2].spelling : "");
  for (int depth = 0; i < tokens.size() && (depth > 0 || is(tokens[i], "<")); ++i) {
    depth += is(tokens[i], "<") ? 1 : is(tokens[i], ">") ? -1 : 0;
    type += tokens[i].spelling;
  }
  if (i < tokens.size() && tokens[i].kind == Token::Kind::identifier) ++i;  // its name
  for (; i < tokens.size() && !is(tokens[i], "=") && !is(tokens[i], ":"); ++i) type += tokens[i].spelling;
  return type;
}

std::vector<std::string> types_of(Tokens tokens) {
  std::vector<std::string> types;
  std::size_t begin = 0;
  int brackets = 0;
  int angles = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    const bool end = i == tokens.size();
    if (end || (brackets == 0 && angles == 0 && is(tokens[i], ","))) {
      if (i > begin) types.push_back(parameter_type(tokens.subspan(begin, i - begin)));
      begin = i + 1;
      continue;
    }
    brackets += opens(tokens[i]) ? 1 : closes(tokens[i]) ? -1 : 0;
    angles += is(tokens[i], "<") ? 1 : is(tokens[i], ">") ? -1 : 0;
  }
  if (types.size() == 1 && types[0] == "void") types.clear();
  return types;
}

class Reader {
 public:
  explicit Reader(Tokens tokens) : tokens_(tokens), closing_(closing_brackets(tokens)) {}

  std::vector<Declaration> run() {
    while (at_ < tokens_.size()) declaration();
    return std::move(found_);
  }

 private:
  using Kind = Declaration::Kind;

  bool at(std::string_view spelling) const { return at_ < tokens_.size() && is(tokens_[at_], spelling); }
  bool at_word() const { return at_ < tokens_.size() && tokens_[at_].kind == Token::Kind::identifier; }

  // Skips the brackets that open here, up to the end of the text if they are not closed.
  std::size_t skip_brackets() {
    const std::size_t close = closing_[at_];
    at_ = close == 0 ? tokens_.size() : close + 1;
    return close;
  }

  void declaration() {
    if (at("}")) {
      if (!namespaces_.empty()) namespaces_.pop_back();
      ++at_;
      return;
    }
    if (at("namespace") && at_ + 2 < tokens_.size() && is(tokens_[at_ + 2], "{")) {
      namespaces_.emplace_back(tokens_[at_ + 1].spelling);
      at_ += 3;
      return;
    }
    current_ = {};
    current_.first = at_;
    for (const std::string& name : namespaces_) current_.scope += name + "::";
    while (at("[")) skip_brackets();
    current_.type = at_;
    whole();
    if (at_ > tokens_.size() || incomplete_) return;
    current_.last = at_ - 1;
    found_.push_back(current_);
  }

  void whole() {
    if (at(";")) {
      current_.kind = Kind::empty;
      ++at_;
    } else if (at("struct") || at("class") || at("interface")) {
      structure();
    } else if (at("cbuffer") || at("tbuffer")) {
      buffer();
    } else if (at("typedef")) {
      current_.kind = Kind::alias;
      to_semicolon();
    } else {
      function_or_variable();
    }
  }

  // Skips to the ';' that ends the declaration, over brackets; an unmatched '}' ends it as well.
  void to_semicolon() {
    while (at_ < tokens_.size() && !at(";") && !at("}")) {
      if (opens(tokens_[at_])) {
        incomplete_ = skip_brackets() == 0;
      } else {
        ++at_;
      }
    }
    incomplete_ = incomplete_ || at_ >= tokens_.size();
    if (at(";")) ++at_;
  }

  void braces() {
    current_.open = at_;
    current_.close = skip_brackets();
    incomplete_ = current_.close == 0;
  }

  void structure() {
    current_.kind = Kind::structure;
    ++at_;
    if (at_word()) current_.name = at_;
    while (at_ < tokens_.size() && !at("{") && !at(";") && !at("(") && !at("=")) ++at_;
    if (!at("{")) {  // `struct S f(...)`, `struct S v;`
      at_ = current_.type + 1;
      current_.name = Declaration::none;
      function_or_variable();
      return;
    }
    braces();
    to_semicolon();
  }

  void buffer() {
    current_.kind = Kind::buffer;
    ++at_;
    if (at_word()) current_.name = at_;
    while (at_ < tokens_.size() && !at("{") && !at(";")) ++at_;
    if (!at("{")) {
      current_.kind = Kind::other;
      to_semicolon();
      return;
    }
    braces();
  }

  // `type name(` is a function; anything else that ends with ';' is a variable.
  void function_or_variable() {
    current_.kind = Kind::variable;
    int angles = 0;
    for (std::size_t previous = Declaration::none; at_ < tokens_.size(); previous = at_++) {
      const bool named = previous != Declaration::none && previous > current_.type &&
                         tokens_[previous].kind == Token::Kind::identifier;
      if (at("<")) ++angles;
      if (at(">")) --angles;
      if (angles > 0) continue;
      if (at("(") && named) return function(previous);
      const bool ends_name = at(";") || at("=") || at("[") || at(":") || at(",") || at("{") || at("}");
      if (!ends_name || (at(":") && at_ + 1 < tokens_.size() && is(tokens_[at_ + 1], ":")) ||
          (at(":") && previous != Declaration::none && is(tokens_[previous], ":")))
        continue;
      if (named) current_.name = previous;
      if (at("{")) {
        if (previous == Declaration::none || !named) current_.kind = Kind::other;
        braces();
      }
      return to_semicolon();
    }
    incomplete_ = true;
  }

  void function(std::size_t name) {
    current_.name = name;
    current_.parameters_open = at_;
    current_.parameters_close = skip_brackets();
    while (at_ < tokens_.size() && !at("{") && !at(";") && !at("}")) {
      if (opens(tokens_[at_])) {
        skip_brackets();
      } else {
        ++at_;
      }
    }
    current_.kind = at("{") ? Kind::function : Kind::prototype;
    incomplete_ = current_.parameters_close == 0 || at_ >= tokens_.size();
    if (at("{")) {
      braces();
    } else if (at(";")) {
      ++at_;
    }
  }

  Tokens tokens_;
  std::vector<std::uint32_t> closing_;
  std::size_t at_ = 0;
  bool incomplete_ = false;  // true if a bracket is not closed: nothing after it is parsed
  Declaration current_;
  std::vector<std::string> namespaces_;
  std::vector<Declaration> found_;
};

}  // namespace

std::vector<Declaration> read_declarations(const std::vector<Token>& tokens) {
  return Reader(tokens).run();
}

std::vector<std::string> parameter_types(const std::vector<Token>& tokens, const Declaration& function) {
  const std::size_t begin = function.parameters_open + 1;
  return types_of(Tokens(tokens).subspan(begin, function.parameters_close - begin));
}

}  // namespace penumbra::hlsl
