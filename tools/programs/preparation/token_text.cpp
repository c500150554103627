#include "preparation/token_text.h"

#include <algorithm>
#include <utility>

#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using hlsl::StringInterner;
using hlsl::Token;

constexpr int longest_run_of_newlines = 8;  // beyond that, a #line directive is shorter

// Returns whether two tokens have no white space between them in the original text: "+=" is two tokens.
bool glued(const Token& left, const Token& right) {
  return left.spelling.data() + left.spelling.size() == right.spelling.data();
}

// Nearly all tokens of a file share one view of its name.
bool same_file(std::string_view a, std::string_view b) {
  return (a.data() == b.data() && a.size() == b.size()) || a == b;
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
  if (same_file(token.file, file) && ahead >= 0 && ahead <= longest_run_of_newlines) {
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
  numbers_.reserve(tokens_.size());
  leads_.reserve(tokens_.size());
  for (const Token& token : tokens_) {
    numbers_.push_back(number_of(token));
    leads_.push_back(token.spelling[0]);
  }
  match_brackets();
}

std::uint32_t TokenText::number_of(const Token& token) {
  return token.kind == Token::Kind::identifier ? words_.add(token.spelling) : StringInterner::none;
}

void TokenText::match_brackets() {
  matching_brackets_.assign(tokens_.size(), alone);
  std::vector<std::uint32_t> open;
  for (std::uint32_t at = 0; at < leads_.size(); ++at) {
    const char lead = leads_[at];
    if (lead == '(' || lead == '[' || lead == '{') {
      open.push_back(at);
    } else if (lead == ')' || lead == ']' || lead == '}') {
      if (open.empty() || leads_[open.back()] != opener_of(lead)) return;  // the rest has none
      matching_brackets_[at] = open.back();
      matching_brackets_[open.back()] = at;
      open.pop_back();
    }
  }
}

bool TokenText::has(std::size_t first, std::size_t end, std::string_view spelling) const {
  for (std::size_t at = first; at < end; ++at)
    if (is(at, spelling)) return true;
  return false;
}

std::string TokenText::spelled(std::size_t first, std::size_t count) const {
  std::string text;
  for (std::size_t at = first; at < std::min(first + count, tokens_.size()); ++at) {
    if (at > first && !glued(tokens_[at - 1], tokens_[at])) text += ' ';
    text += tokens_[at].spelling;
  }
  return text;
}

const std::vector<hlsl::Declaration>& TokenText::declarations() const {
  if (!declarations_) declarations_ = hlsl::read_declarations(tokens_);
  return *declarations_;
}

const ValueTypes& TokenText::types() const {
  if (types_ == nullptr) types_ = std::make_shared<const ValueTypes>(*this);
  return *types_;
}

std::string TokenText::free_name(std::string wanted) const {
  if (known_words_.empty()) {
    known_words_.assign(words_.size(), false);
    for (const std::uint32_t number : numbers_)
      if (number != StringInterner::none) known_words_[number] = true;
  }
  const auto known = [&](std::uint32_t number) {
    return number != StringInterner::none && known_words_[number];
  };
  while (known(words_.find(wanted))) wanted += "_";
  return wanted;
}

void TokenText::replace(std::size_t first, std::size_t count, std::string_view hlsl) {
  if (count > 0 || !hlsl.empty()) edits_.push_back({first, count, std::string(hlsl)});
}

void TokenText::insert_from(std::size_t place, std::size_t before, std::string_view hlsl) {
  if (!hlsl.empty()) edits_.push_back({before, 0, std::string(hlsl), place});
}

void TokenText::insert_without_line(std::size_t before, std::string_view hlsl) {
  if (!hlsl.empty()) edits_.push_back({before, 0, std::string(hlsl), npos, false});
}

void TokenText::append_kept(std::size_t first, std::size_t end) {
  if (first >= end) return;
  edited_.insert(edited_.end(), tokens_.data() + first, tokens_.data() + end);
  edited_numbers_.insert(edited_numbers_.end(), numbers_.data() + first, numbers_.data() + end);
  edited_leads_.append(leads_, first, end - first);
}

void TokenText::append_made(const Edit& edit) {
  if (edit.text.empty()) return;
  made_.push_back(edit.text);
  const bool replaces = edit.count > 0 || edited_.empty();
  const Token* place = edit.place < tokens_.size()               ? &tokens_[edit.place]
                       : replaces && edit.first < tokens_.size() ? &tokens_[edit.first]
                       : !edited_.empty()                        ? &edited_.back()
                                                                 : nullptr;
  const std::string_view file = place == nullptr ? std::string_view(main_file_) : place->file;
  const int line = !edit.has_line ? 0 : place == nullptr ? 1 : place->line;
  for (Token token : hlsl::lex(made_.back())) {
    token.file = file;
    token.line = line;
    edited_.push_back(token);
    edited_numbers_.push_back(number_of(token));
    edited_leads_.push_back(token.spelling[0]);
  }
}

void TokenText::apply() {
  if (edits_.empty()) return;
  std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
    return a.first != b.first ? a.first < b.first
                              : a.count == 0 && b.count > 0;  // text that goes before comes first
  });
  edited_.clear();
  edited_.reserve(tokens_.size() + 16 * edits_.size());
  edited_numbers_.clear();
  edited_numbers_.reserve(edited_.capacity());
  edited_leads_.clear();
  std::size_t at = 0;
  for (const Edit& edit : edits_) {
    append_kept(at, std::min(edit.first, tokens_.size()));
    append_made(edit);
    at = std::max(at, edit.first + edit.count);
  }
  append_kept(at, tokens_.size());
  tokens_.swap(edited_);
  numbers_.swap(edited_numbers_);
  leads_.swap(edited_leads_);
  edits_.clear();
  declarations_.reset();
  types_.reset();
  known_words_.clear();
  match_brackets();
}

std::string TokenText::file_of(std::size_t at) const {
  return at < tokens_.size() ? std::string(tokens_[at].file) : main_file_;
}

std::size_t TokenText::original(std::size_t at) {
  if (at >= tokens_.size()) return npos;
  if (original_.empty()) original_ = hlsl::lex(text_);
  const char* const place = tokens_[at].spelling.data();
  const auto found = std::lower_bound(
      original_.begin(), original_.end(), place,
      [](const Token& token, const char* other) { return std::less<>()(token.spelling.data(), other); });
  const bool is_there = found != original_.end() && found->spelling.data() == place;
  return is_there ? static_cast<std::size_t>(found - original_.begin()) : npos;
}

void TokenText::note(std::size_t at, hlsl::Severity severity, std::string message) {
  Note note{{file_of(at), at < tokens_.size() ? tokens_[at].line : 0, 0, severity, std::move(message), {}}};
  if (const std::size_t given = original(at); given != npos) {
    const Token& token = original_[given];
    note.spelling = token.spelling;
    const auto same_line = [&](std::size_t other) {
      return original_[other].line == token.line && same_file(original_[other].file, token.file);
    };
    const auto counted = [&](std::size_t other) { return original_[other].spelling == token.spelling; };
    for (std::size_t before = given; before > 0 && same_line(before - 1); --before)
      note.rank += counted(before - 1) ? 1 : 0;
    note.count = note.rank + 1;
    for (std::size_t after = given + 1; after < original_.size() && same_line(after); ++after)
      note.count += counted(after) ? 1 : 0;
  }
  notes_.push_back(std::move(note));
}

std::string TokenText::print() const {
  std::string out;
  out.reserve(text_.size());
  std::string_view file;
  int line = 1;
  for (std::size_t at = 0; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (token.line != line || !same_file(token.file, file)) {
      move_to_line(out, token, file, line);
    } else if (at > 0 && !glued(tokens_[at - 1], token)) {
      out += ' ';
    }
    out += token.spelling;
  }
  return out += '\n';
}

}  // namespace penumbra::preparation
