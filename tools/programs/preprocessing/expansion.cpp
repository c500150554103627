#include "preprocessing/expansion.h"

#include <utility>

#include "preprocessing/cut_source.h"
#include "preprocessing/token_scan.h"

namespace penumbra::preprocessing {

namespace {

constexpr std::size_t most_tokens = 4'000'000;  // tokens of one run; URP's lighting has some ten thousand
constexpr int deepest_call = 200;               // nested calls in arguments

bool may_be_joined(const Token& token) {
  return token.kind == Kind::identifier || token.kind == Kind::integer || token.kind == Kind::number;
}

}  // namespace

void Expansion::read_text(const Token* first, const Token* last, const Place* places) {
  at_ = first;
  last_ = last;
  places_ = places;
}

void Expansion::read_condition(const Token* first, const Token* last) {
  read_text(first, last, nullptr);
  line_ = column_ = 0;
  joined_ = false;
}

Read Expansion::scan_bottom() {
  Read read;
  if (at_ == last_) {
    if (places_ != nullptr) throw Unusual("a directive among a macro's arguments");
    read.token.kind = Kind::newline;
    return read;
  }
  read.token = *at_++;
  if (places_ == nullptr) return read;
  const Place& place = *places_++;
  read.line = line_ = place.line;
  read.column = place.column;
  column_ = place.after;
  joined_ = place.joined;
  return read;
}

// Reads the next token of the top input, which is not exhausted. Returns false if an argument was pushed
// instead.
bool Expansion::scan_input(Read& out) {
  Input& input = inputs_.back();
  if (input.source == Source::put_back) {
    out = input.read;
    ++input.at;
    return true;
  }
  if (joined_) throw Unusual("macro text without a known position");
  out = {*input.at++, line_, column_};
  if (input.source != Source::macro) return true;
  input.pasted_behind = input.at != input.last && input.at->kind == Kind::paste;
  if (out.token.parameter == no_parameter) return true;
  push_argument(input.call->expanded[static_cast<std::size_t>(out.token.parameter)], input.pasted_behind);
  return false;
}

Read Expansion::scan() {
  if (++scanned_ > most_tokens) throw Unusual("a macro expansion that is too large");
  Read read;
  while (!at_bottom() && !scan_input(read)) {
  }
  if (inputs_.empty()) read = scan_bottom();
  if (read.token.kind == Kind::unusual || read.token.is(known::hash)) throw Unusual("an unusual token");
  return read;
}

void Expansion::pop() {
  Input& input = inputs_.back();
  if (input.source == Source::macro) macros_.set_busy(input.macro, false);
  if (input.call) free_calls_.push_back(std::move(input.call));
  inputs_.pop_back();
}

bool Expansion::at_bottom() {
  while (!inputs_.empty() && inputs_.back().at == inputs_.back().last) pop();
  return inputs_.empty();
}

void Expansion::clear() {
  while (!inputs_.empty()) pop();
  depth_ = 0;
  scanned_ = 0;
}

bool Expansion::peek_paste() const {
  if (inputs_.empty()) return false;
  const Input& input = inputs_.back();
  if (input.source == Source::macro) return input.pasted_behind;
  if (input.source != Source::argument) return false;
  return input.at == input.last ? input.pasted_behind : input.at->kind == Kind::paste;
}

// glslang splits "3A" into two tokens, and pastes tokens without white space between them.
bool Expansion::peek_continued() const {
  if (inputs_.empty()) return false;
  const Input& input = inputs_.back();
  const bool stream = input.source == Source::macro || input.source == Source::argument;
  if (!stream || input.at == input.last || input.at->space) return false;
  return may_be_joined(*input.at) || input.at->kind == Kind::string;
}

void Expansion::paste(Read& left) {
  if (left.token.kind == Kind::paste) throw Unusual("## without a token before it");
  while (peek_paste()) {
    if (scan().token.kind != Kind::paste) throw Unusual("## after an expanded macro");
    const bool at_end = inputs_.empty() ||
                        (inputs_.back().source == Source::macro && inputs_.back().at == inputs_.back().last);
    if (at_end) throw Unusual("## without a token after it");
    do {
      const Read right = scan();
      if (inputs_.empty()) throw Unusual("## before an empty argument");
      if (left.token.kind != Kind::identifier || !may_be_joined(right.token))
        throw Unusual("## between tokens that do not form an identifier");
      const std::string name = spellings_.text(left.token.spelling) + spellings_.text(right.token.spelling);
      if (is_left_to_glslang(name)) throw Unusual("## forms an identifier that glslang treats specially");
      left.token.spelling = spellings_.number(name);
    } while (peek_continued());
  }
}

void Expansion::put_back(const Read& read) {
  static const Token one;
  Input input;
  input.source = Source::put_back;
  input.at = &one;
  input.last = &one + 1;
  input.read = read;
  inputs_.push_back(std::move(input));
}

void Expansion::push_argument(const std::vector<Token>& tokens, bool pasted_behind) {
  Input input;
  input.pasted_behind = pasted_behind;
  input.at = tokens.data();
  input.last = tokens.data() + tokens.size();
  inputs_.push_back(std::move(input));
}

bool Expansion::expand(Read& name, bool undefined_as_zero) {
  name.token.space = false;
  const Spelling spelling = name.token.spelling;
  const Definition* const macro = macros_.definition(spelling);
  if (macro == nullptr && !undefined_as_zero) return false;
  if (macro == nullptr) {
    Read zero;
    zero.token.kind = Kind::integer;
    zero.token.spelling = spellings_.number("0");
    put_back(zero);
    return true;
  }
  if (macros_.is_busy(spelling)) return false;
  std::unique_ptr<Call> call;
  if (macro->has_list) {
    Read open = scan();
    if (!open.token.is(known::open)) {
      put_back(open);
      return false;
    }
    call = read_arguments(*macro, open);
  }
  Input input;
  input.source = Source::macro;
  input.at = macro->body.data();
  input.last = macro->body.data() + macro->body.size();
  input.macro = spelling;
  input.call = std::move(call);
  inputs_.push_back(std::move(input));
  macros_.set_busy(spelling, true);
  return true;
}

std::unique_ptr<Expansion::Call> Expansion::new_call(std::size_t arguments) {
  std::unique_ptr<Call> call;
  if (free_calls_.empty()) {
    call = std::make_unique<Call>();
  } else {
    call = std::move(free_calls_.back());
    free_calls_.pop_back();
  }
  if (call->arguments.size() < arguments) {
    call->arguments.resize(arguments);
    call->expanded.resize(arguments);
  }
  for (std::size_t i = 0; i < arguments; ++i) {
    call->arguments[i].clear();
    call->expanded[i].clear();
  }
  return call;
}

// Reads from after the '(' to after the ')'.
std::unique_ptr<Expansion::Call> Expansion::read_arguments(const Definition& macro, Read& read) {
  const std::size_t count = macro.parameters.size();
  std::unique_ptr<Call> call = new_call(count);
  if (count == 0) {
    read = scan();
    if (!read.token.is(known::close)) throw Unusual("too many arguments");
    return call;
  }
  for (std::size_t i = 0; i < count; ++i) {
    read_argument(read, call->arguments[i]);
    const bool ends = read.token.is(known::close);
    if (ends != (i + 1 == count)) throw Unusual("too few or too many arguments");
  }
  if (count == 1 && call->arguments[0].empty()) throw Unusual("no argument");
  for (std::size_t i = 0; i < count; ++i) expand_argument(call->arguments[i], call->expanded[i]);
  return call;
}

// Reads to the comma or the ')' that ends it, which is left in `read`.
void Expansion::read_argument(Read& read, std::vector<Token>& argument) {
  std::vector<Spelling> open;  // the token that closes each bracket
  for (;;) {
    read = scan();
    const Token& token = read.token;
    if (token.kind == Kind::newline || token.kind == Kind::argument_end)
      throw Unusual("an unterminated macro call");
    if (open.empty() && (token.is(known::comma) || token.is(known::close))) return;
    if (token.is(known::open)) {
      open.push_back(known::close);
    } else if (token.is(known::open_brace)) {
      open.push_back(known::close_brace);
    } else if (!open.empty() && token.is(open.back())) {
      open.pop_back();
    }
    argument.push_back(token);
  }
}

// Returns the expansion of an argument's tokens.
void Expansion::expand_argument(const std::vector<Token>& argument, std::vector<Token>& expanded) {
  if (++depth_ > deepest_call) throw Unusual("macro calls nested too deeply");
  Read end;
  end.token.kind = Kind::argument_end;
  put_back(end);
  push_argument(argument, false);
  for (Read read = scan(); read.token.kind != Kind::argument_end; read = scan()) {
    paste(read);
    if (read.token.kind == Kind::identifier && expand(read, false)) continue;
    expanded.push_back(read.token);
  }
  --depth_;
}

void Macros::define(const Definition& definition) {
  if (definition.name >= entries_.size()) {
    entries_.resize(definition.name + 1);
    defined_.resize(definition.name + 1);
  }
  Entry& entry = entries_[definition.name];
  if (entry.definition != nullptr && entry.definition != &definition &&
      !are_identical(*entry.definition, definition))
    throw Unusual("a macro is redefined differently");
  entry.definition = &definition;
  defined_[definition.name] = 1;
  names_.push_back(definition.name);
}

void Macros::undefine(Spelling name) {
  if (!is_defined(name)) return;
  entries_[name].definition = nullptr;
  defined_[name] = 0;
}

void Macros::clear() {
  for (const Spelling name : names_) {
    entries_[name] = {};
    defined_[name] = 0;
  }
  names_.clear();
}

}  // namespace penumbra::preprocessing
