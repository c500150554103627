#include "hlsl/function_definitions.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace penumbra::hlsl {

namespace {

using Tokens = std::span<const Token>;

bool is(const Token& token, std::string_view spelling) {
  return token.spelling == spelling;
}

bool opens(const Token& token) {
  return token.kind == Token::Kind::mark &&
         std::string_view("([{").find(token.spelling[0]) != std::string_view::npos;
}
bool closes(const Token& token) {
  return token.kind == Token::Kind::mark &&
         std::string_view(")]}").find(token.spelling[0]) != std::string_view::npos;
}

// Index of the bracket that closes the one at `open`, or tokens.size().
std::size_t closing(Tokens tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    depth += opens(tokens[i]) ? 1 : closes(tokens[i]) ? -1 : 0;
    if (depth == 0) return i;
  }
  return tokens.size();
}

// What may stand before a parameter's type without being part of it. `in` is what a parameter is anyway.
bool is_modifier(const Token& token) {
  constexpr std::array<std::string_view, 15> modifiers{
      "in",        "const",        "uniform",         "precise",       "static",
      "linear",    "centroid",     "nointerpolation", "noperspective", "sample",
      "row_major", "column_major", "snorm",           "unorm",         "volatile"};
  return std::find(modifiers.begin(), modifiers.end(), token.spelling) != modifiers.end();
}

// One parameter without its name, default value and semantic.
std::string parameter_type(Tokens tokens) {
  std::string type;
  std::size_t i = 0;
  for (; i < tokens.size() && (is_modifier(tokens[i]) || is(tokens[i], "out") || is(tokens[i], "inout"));
       ++i) {
    if (!is_modifier(tokens[i])) type += std::string(tokens[i].spelling) + " ";
  }
  if (i < tokens.size()) type += tokens[i++].spelling;
  for (; i + 1 < tokens.size() && is(tokens[i], ":") && is(tokens[i + 1], ":"); i += 3) {
    type += "::" + std::string(i + 2 < tokens.size() ? tokens[i + 2].spelling : "");
  }
  for (int depth = 0; i < tokens.size() && (depth > 0 || is(tokens[i], "<")); ++i) {
    depth += is(tokens[i], "<") ? 1 : is(tokens[i], ">") ? -1 : 0;
    type += tokens[i].spelling;
  }
  if (i < tokens.size() && tokens[i].kind == Token::Kind::word) ++i;  // its name
  for (; i < tokens.size() && !is(tokens[i], "=") && !is(tokens[i], ":"); ++i) type += tokens[i].spelling;
  return type;
}

std::vector<std::string> parameter_types(Tokens tokens) {
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

class Declarations {
 public:
  explicit Declarations(Tokens tokens) : tokens_(tokens) {}

  std::vector<FunctionDefinition> run() {
    while (at_ < tokens_.size()) step();
    return std::move(found_);
  }

 private:
  void step() {
    const Token& token = tokens_[at_];
    if (is(token, ";")) {
      start_anew(at_ + 1);
    } else if (is(token, "}")) {
      if (!namespaces_.empty()) namespaces_.pop_back();
      start_anew(at_ + 1);
    } else if (is(token, "{")) {
      brace();
    } else if (is(token, "(") || is(token, "[")) {
      bracket();
    } else {
      has_value_ = has_value_ || is(token, "=");
      ++at_;
    }
  }

  // A function's name and parameters are the first word before '(' that a type precedes.
  void bracket() {
    const std::size_t end = closing(tokens_, at_);
    const bool named = at_ > statement_ + 1 && tokens_[at_ - 1].kind == Token::Kind::word &&
                       !is(tokens_[at_ - 2], ":");  // : register(t0)
    if (is(tokens_[at_], "(") && named && parameters_ == 0 && !has_value_) {
      parameters_ = at_;
      parameters_end_ = end;
    }
    at_ = end + 1;
  }

  void brace() {
    if (is(tokens_[statement_], "namespace") && at_ == statement_ + 2) {
      namespaces_.emplace_back(tokens_[statement_ + 1].spelling);
      start_anew(at_ + 1);
      return;
    }
    const std::size_t end = closing(tokens_, at_);
    const bool is_function = parameters_ != 0 && !has_value_ && end < tokens_.size();
    if (is_function) add(end);
    at_ = end + 1;
    if (is_function) start_anew(at_);
  }

  void add(std::size_t end) {
    FunctionDefinition function;
    for (const std::string& name : namespaces_) function.name += name + "::";
    function.name += tokens_[parameters_ - 1].spelling;
    function.parameters =
        parameter_types(tokens_.subspan(parameters_ + 1, parameters_end_ - parameters_ - 1));
    function.name_token = &tokens_[parameters_ - 1];
    function.body_begin = &tokens_[at_];
    function.body_end = &tokens_[end];
    found_.push_back(std::move(function));
  }

  void start_anew(std::size_t at) {
    at_ = at;
    statement_ = at;
    parameters_ = 0;
    has_value_ = false;
  }

  Tokens tokens_;
  std::size_t at_ = 0;
  std::size_t statement_ = 0;   // first token of the declaration being read
  std::size_t parameters_ = 0;  // the '(' of its parameters, 0 before it is seen
  std::size_t parameters_end_ = 0;
  bool has_value_ = false;  // an '=' was seen: what follows is an expression
  std::vector<std::string> namespaces_;
  std::vector<FunctionDefinition> found_;
};

}  // namespace

std::vector<FunctionDefinition> function_definitions(const std::vector<Token>& tokens) {
  return Declarations(tokens).run();
}

}  // namespace penumbra::hlsl
