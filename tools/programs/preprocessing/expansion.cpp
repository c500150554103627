#include "preprocessing/expansion.h"

#include <utility>

#include "preprocessing/token_scan.h"

namespace penumbra::preprocessing {

namespace {

constexpr std::size_t most_tokens = 4'000'000;  // tokens of one run; URP's lighting has some ten thousand
constexpr int deepest_call = 1000;              // nested calls in arguments

constexpr std::size_t longest_token = std::size_t{64} << 10U;  // that ## makes

bool may_be_joined(const Token& token) {
  return token.kind == Kind::identifier || token.kind == Kind::integer || token.kind == Kind::number;
}

bool are_identical(const Definition& a, const Definition& b) {
  if (a.has_list != b.has_list || a.parameters != b.parameters || a.body.size() != b.body.size())
    return false;
  for (std::size_t i = 0; i < a.body.size(); ++i)
    if (a.body[i].kind != b.body[i].kind || a.body[i].spelling != b.body[i].spelling) return false;
  return true;
}

// The closing bracket, which follows the opening one in `known`; 0 for other tokens.
Spelling closing(const Token& token) {
  const bool opens = token.is(known::open) || token.is(known::open_square) || token.is(known::open_brace);
  return opens ? token.spelling + 1 : 0;
}

// Splits a list at the commas that are in no brackets.
std::vector<std::vector<Token>> split(const std::vector<Token>& list) {
  std::vector<std::vector<Token>> parts(1);
  std::vector<Spelling> open;
  for (const Token& token : list) {
    if (open.empty() && token.is(known::comma)) {
      parts.emplace_back();
      continue;
    }
    if (const Spelling close = closing(token); close != 0)
      open.push_back(close);
    else if (!open.empty() && token.is(open.back()))
      open.pop_back();
    parts.back().push_back(token);
  }
  return parts;
}

std::vector<Token> with_commas(const std::vector<std::vector<Token>>& parts) {
  std::vector<Token> list;
  for (const std::vector<Token>& part : parts) {
    if (&part != &parts.front()) {
      list.emplace_back().kind = Kind::punctuation;
      list.back().spelling = known::comma;
    }
    list.insert(list.end(), part.begin(), part.end());
  }
  return list;
}

}  // namespace

void Expansion::read_text(const Token* first, const Token* last, const Place* places) {
  at_ = first;
  last_ = last;
  places_ = places;
}

Token Expansion::scan() {
  if (++scanned_ > most_tokens) throw Problem("a macro expansion that is too large");
  Token token;
  while (inputs_.size() > floor_ && inputs_.back().at == inputs_.back().last) pop();
  if (inputs_.size() > floor_) {
    token = *inputs_.back().at++;
  } else if (depth_ == 0) {
    if (at_ == last_ && in_call_ && continuation_ != nullptr && !continuation_->go_on()) return token;
    if (at_ == last_) return token;
    token = *at_++;
    place_ = *places_++;
  }
  if (token.kind == Kind::bad || token.is(known::hash))
    throw Problem(message_for_bad(spellings_.text(token.spelling)));
  return token;
}

void Expansion::pop() {
  if (inputs_.back().macro != nullptr) macros_.set_busy(inputs_.back().macro->name, false);
  inputs_.pop_back();
}

bool Expansion::at_bottom() {
  while (!inputs_.empty() && inputs_.back().at == inputs_.back().last) pop();
  return inputs_.empty();
}

void Expansion::clear() {
  while (!inputs_.empty()) pop();
  floor_ = 0;
  depth_ = 0;
  in_call_ = false;
}

void Expansion::restart() {
  clear();
  scanned_ = 0;
}

bool Expansion::open_follows() const {
  for (std::size_t i = inputs_.size(); i > floor_; --i)
    if (inputs_[i - 1].at != inputs_[i - 1].last) return inputs_[i - 1].at->is(known::open);
  return depth_ == 0 && at_ != last_ && at_->is(known::open);
}

Token Expansion::integer(int value) {
  Token token;
  token.kind = Kind::integer;
  token.spelling = spellings_.number(std::to_string(value));
  return token;
}

bool Expansion::expand(Token& name) {
  if (names_ != nullptr) names_->insert(name.spelling);
  if (name.spelling == known::word_line) {
    name = integer(place_.line);
    return false;
  }
  const Definition* const macro = name.final ? nullptr : macros_.definition(name.spelling);
  if (macro == nullptr) return false;
  if (macros_.is_busy(name.spelling)) {
    name.final = true;
    return false;
  }
  if (macro->has_list && !open_follows()) return false;
  const Place begin = place_;
  Input input;
  input.macro = macro;
  if (macro->has_list) {
    Arguments arguments = read_arguments(*macro, begin);
    Arguments expansions;
    for (const std::vector<Token>& argument : arguments)
      expansions.push_back(expanded(argument.data(), argument.data() + argument.size(), false));
    if (arguments.size() < macro->parameters.size()) {
      arguments = expansions = split(with_commas(expansions));
    }
    check_count(*macro, arguments.size(), begin);
    input.tokens = substituted(*macro, arguments, expansions);
  } else if (macro->pastes) {
    input.tokens = substituted(*macro, {}, {});
  }
  const std::vector<Token>& body = macro->has_list || macro->pastes ? input.tokens : macro->body;
  input.at = body.data();
  input.last = input.at + body.size();
  inputs_.push_back(std::move(input));
  macros_.set_busy(macro->name, true);
  return true;
}

// A call without anything between its brackets has one argument, which is empty.
void Expansion::check_count(const Definition& macro, std::size_t count, const Place& call) const {
  const std::size_t wanted = macro.parameters.size();
  if (count == wanted) return;
  throw Problem((count < wanted ? "too few arguments for macro '" : "too many arguments for macro '") +
                    spellings_.text(macro.name) + "'",
                call);
}

// Reads from the '(' to the ')'.
Expansion::Arguments Expansion::read_arguments(const Definition& macro, const Place& call) {
  scan();
  const bool was_in_call = std::exchange(in_call_, true);
  std::vector<Token> list;
  std::size_t depth = 0;  // of round brackets
  for (;;) {
    const Token token = scan();
    if (token.kind == Kind::end)
      throw Problem("the call of macro '" + spellings_.text(macro.name) + "' is never closed", call);
    if (token.is(known::close) && depth-- == 0) break;
    if (token.is(known::open)) ++depth;
    list.push_back(token);
  }
  in_call_ = was_in_call;
  if (macro.parameters.empty() && list.empty()) return {};
  return split(list);
}

std::vector<Token> Expansion::expanded(const Token* first, const Token* last, bool condition) {
  if (++depth_ > deepest_call) throw Problem("macro calls nested too deeply");
  const std::size_t floor = std::exchange(floor_, inputs_.size());
  const bool in_call = std::exchange(in_call_, false);
  Input input;
  input.at = first;
  input.last = last;
  inputs_.push_back(std::move(input));
  std::vector<Token> tokens;
  for (Token token = scan(); token.kind != Kind::end; token = scan()) {
    if (token.kind == Kind::identifier) {
      if (condition && token.spelling == known::word_defined)
        token = is_defined();
      else if (expand(token))
        continue;
    }
    tokens.push_back(token);
  }
  floor_ = floor;
  in_call_ = in_call;
  --depth_;
  return tokens;
}

// Reads what follows `defined`.
Token Expansion::is_defined() {
  Token name = scan();
  const bool bracket = name.is(known::open);
  if (bracket) name = scan();
  if (name.kind != Kind::identifier) throw Problem("'defined' takes the name of a macro");
  if (names_ != nullptr) names_->insert(name.spelling);
  if (bracket && !scan().is(known::close)) throw Problem("'(' after 'defined' is never closed");
  return integer(macros_.is_defined(name.spelling) ? 1 : 0);
}

std::vector<Token> Expansion::substituted(const Definition& macro, const Arguments& arguments,
                                          const Arguments& expanded) {
  std::vector<Token> tokens;
  bool pastes = false;
  bool any_before = false;  // the operand before has tokens
  for (auto token = macro.body.begin(); token != macro.body.end(); ++token) {
    if (token->kind == Kind::paste) {
      pastes = true;
      continue;
    }
    const bool text = macro.has_list && token->is(known::hash) && token + 1 != macro.body.end() &&
                      token[1].parameter != no_parameter;
    Token one = *token;
    if (text) one = as_text(arguments[static_cast<std::size_t>((++token)->parameter)]);
    const Token* first = &one;
    const Token* last = first + 1;
    if (!text && token->parameter != no_parameter) {
      const std::vector<Token>& argument = expanded[static_cast<std::size_t>(token->parameter)];
      first = argument.data();
      last = first + argument.size();
    }
    if (pastes && any_before && first != last)
      join(tokens, first, last);
    else
      tokens.insert(tokens.end(), first, last);
    any_before = first != last || (pastes && any_before);
    pastes = false;
  }
  for (Token& token : tokens) token.parameter = no_parameter;
  scanned_ += tokens.size();
  return tokens;
}

// Joins the last token and the first of these, with what follows it without white space: 2D is two tokens.
// Tokens that do not form one stay two.
void Expansion::join(std::vector<Token>& left, const Token* right, const Token* last) {
  const std::string text = spellings_.text(left.back().spelling) + spellings_.text(right->spelling);
  if (text.size() > longest_token) throw Problem("## makes a name of more than 64 KiB");
  TokenScan scan(text, spellings_);
  Token joined = scan.next();
  if (scan.next().kind == Kind::end) {
    joined.space = left.back().space;
    left.back() = joined;
    for (++right; right != last && joined.kind == Kind::identifier && !right->space && may_be_joined(*right);
         ++right) {
      const std::string more = spellings_.text(left.back().spelling) + spellings_.text(right->spelling);
      left.back().spelling = spellings_.number(more);
    }
  }
  left.insert(left.end(), right, last);
}

Token Expansion::as_text(const std::vector<Token>& argument) {
  std::string text = "\"";
  for (const Token& token : argument)
    text.append(token.space && text.size() > 1 ? " " : "").append(spellings_.text(token.spelling));
  Token token;
  token.kind = Kind::string;
  token.spelling = spellings_.number(text + '"');
  return token;
}

Macros::Known Macros::define(const Definition& definition, const std::string& file) {
  if (definition.name >= entries_.size()) {
    entries_.resize(definition.name + 1);
    defined_.resize(definition.name + 1);
  }
  Entry& entry = entries_[definition.name];
  Known replaced;
  if (defined_[definition.name] != 0 && !are_identical(*entry.definition, definition)) replaced = entry;
  entry.definition = &definition;
  entry.file = &file;
  defined_[definition.name] = 1;
  names_.push_back(definition.name);
  return replaced;
}

void Macros::clear() {
  for (const Spelling name : names_) {
    entries_[name] = {};
    defined_[name] = 0;
  }
  names_.clear();
}

}  // namespace penumbra::preprocessing
