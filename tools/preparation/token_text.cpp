#include "preparation/token_text.h"

#include <algorithm>
#include <utility>

#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using hlsl::Token;

constexpr int longest_run_of_newlines = 8;  // further on, a #line directive is shorter

// Two tokens without anything between them in the text they were lexed from: "+=" is two marks.
bool glued(const Token& left, const Token& right) {
  return left.spelling.data() + left.spelling.size() == right.spelling.data();
}

char opener_of(char closer) {
  switch (closer) {
    case ')':
      return '(';
    case ']':
      return '[';
    default:
      return '{';
  }
}

// Moves the end of `out` to the line of `token`.
void move_to_line(std::string& out, const Token& token, std::string_view& file, int& line) {
  const int ahead = token.line - line;
  if (token.file == file && ahead >= 0 && ahead <= longest_run_of_newlines) {
    out.append(static_cast<std::size_t>(ahead), '\n');
  } else {
    if (!out.empty()) out += '\n';
    out += "#line " + std::to_string(token.line);
    if (token.file != file) out.append(" \"").append(token.file).append("\"");
    out += '\n';
  }
  file = token.file;
  line = token.line;
}

}  // namespace

TokenText::TokenText(std::string preprocessed, std::string main_file)
    : text_(std::move(preprocessed)), main_file_(std::move(main_file)), tokens_(hlsl::lex(text_)) {
  for (Token& token : tokens_)
    if (token.file.empty()) token.file = main_file_;
  find_partners();
}

void TokenText::find_partners() {
  partners_.assign(tokens_.size(), npos);
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < tokens_.size(); ++at) {
    if (tokens_[at].kind != Token::Kind::mark) continue;
    const char mark = tokens_[at].spelling[0];
    if (mark == '(' || mark == '[' || mark == '{') {
      open.push_back(at);
    } else if (mark == ')' || mark == ']' || mark == '}') {
      if (open.empty() || tokens_[open.back()].spelling[0] != opener_of(mark)) return;  // the rest has none
      partners_[at] = open.back();
      partners_[open.back()] = at;
      open.pop_back();
    }
  }
}

std::string TokenText::spelled(std::size_t first, std::size_t count) const {
  std::string text;
  for (std::size_t at = first; at < std::min(first + count, tokens_.size()); ++at) {
    if (at > first && !glued(tokens_[at - 1], tokens_[at])) text += ' ';
    text += tokens_[at].spelling;
  }
  return text;
}

const ValueTypes& TokenText::types() const {
  if (types_ == nullptr) types_ = std::make_shared<const ValueTypes>(*this);
  return *types_;
}

std::string TokenText::free_name(std::string wanted) const {
  if (known_words_.empty())
    for (const Token& token : tokens_)
      if (token.kind == Token::Kind::word) known_words_.insert(token.spelling);
  while (known_words_.count(wanted) != 0) wanted += "_";
  return wanted;
}

void TokenText::replace(std::size_t first, std::size_t count, std::string_view hlsl) {
  edits_.push_back({first, count, std::string(hlsl)});
}

void TokenText::insert_from(std::size_t place, std::size_t before, std::string_view hlsl) {
  edits_.push_back({before, 0, std::string(hlsl), place});
}

void TokenText::append_made(std::vector<Token>& to, const Edit& edit) {
  if (edit.text.empty()) return;
  made_.push_back(edit.text);
  const bool replaces = edit.count > 0 || to.empty();
  const Token* place = edit.place < tokens_.size()               ? &tokens_[edit.place]
                       : replaces && edit.first < tokens_.size() ? &tokens_[edit.first]
                       : !to.empty()                             ? &to.back()
                                                                 : nullptr;
  const std::string_view file = place == nullptr ? std::string_view(main_file_) : place->file;
  const int line = place == nullptr ? 1 : place->line;
  for (Token token : hlsl::lex(made_.back())) {
    token.file = file;
    token.line = line;
    to.push_back(token);
  }
}

void TokenText::apply() {
  if (edits_.empty()) return;
  std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
    return a.first != b.first ? a.first < b.first
                              : a.count == 0 && b.count > 0;  // what goes before comes first
  });
  std::vector<Token> tokens;
  tokens.reserve(tokens_.size() + 16 * edits_.size());
  std::size_t at = 0;
  for (const Edit& edit : edits_) {
    for (; at < std::min(edit.first, tokens_.size()); ++at) tokens.push_back(tokens_[at]);
    append_made(tokens, edit);
    at = std::max(at, edit.first + edit.count);
  }
  for (; at < tokens_.size(); ++at) tokens.push_back(tokens_[at]);
  tokens_ = std::move(tokens);
  edits_.clear();
  types_.reset();
  known_words_.clear();
  find_partners();
}

std::string TokenText::file_of(std::size_t at) const {
  return at < tokens_.size() ? std::string(tokens_[at].file) : main_file_;
}

void TokenText::note(std::size_t at, hlsl::Severity severity, std::string message) {
  const int line = at < tokens_.size() ? tokens_[at].line : 0;
  notes_.push_back({file_of(at), line, 0, severity, std::move(message), {}});
}

std::string TokenText::print() const {
  std::string out;
  out.reserve(text_.size());
  std::string_view file;
  int line = 1;
  for (std::size_t at = 0; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (token.line != line || token.file != file) {
      move_to_line(out, token, file, line);
    } else if (at > 0 && !glued(tokens_[at - 1], token)) {
      out += ' ';
    }
    out += token.spelling;
  }
  return out += '\n';
}

}  // namespace penumbra::preparation
