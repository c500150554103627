#include "hlsl/token_place.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "hlsl/identifier.h"

namespace penumbra::hlsl {

namespace {

constexpr std::array<std::string_view, 22> operators{
    "<<=", ">>=", "...", "==", "<=", ">=", "!=", "&&", "||", "++", "--",
    "+=",  "-=",  "*=",  "/=", "%=", "&=", "|=", "^=", "<<", ">>", "::"};

std::size_t offset_in(std::string_view text, const Token& token) {
  return static_cast<std::size_t>(token.spelling.data() - text.data());
}

// The lexer returns single punctuation characters; a compiler must read "==" as one token.
std::vector<Token> with_operators_joined(const std::vector<Token>& marks, std::string_view text) {
  std::vector<Token> joined;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    Token token = marks[i];
    if (token.kind == Token::Kind::punctuation) {
      for (const std::string_view candidate : operators) {
        const std::string_view here = text.substr(offset_in(text, token), candidate.size());
        if (here != candidate) continue;
        token.spelling = here;
        i += candidate.size() - 1;
        break;
      }
    }
    joined.push_back(token);
  }
  return joined;
}

// Comments become white space, so that columns are preserved.
std::string without_comments(std::string_view line) {
  std::string code(line);
  for (std::size_t i = 0; i + 1 < code.size(); ++i) {
    const std::string_view two = std::string_view(code).substr(i, 2);
    if (two != "//" && two != "/*") continue;
    const std::size_t close = two == "/*" ? code.find("*/", i + 2) : std::string::npos;
    const std::size_t end = close == std::string::npos ? code.size() : close + 2;
    std::fill(code.begin() + static_cast<std::ptrdiff_t>(i), code.begin() + static_cast<std::ptrdiff_t>(end),
              ' ');
    i = end - 1;
  }
  return code;
}

// Returns the only name of the source line that the expanded line lacks, if there is exactly one: the macro
// that was called.
int column_of_macro(std::string_view source_line, const std::set<std::string_view>& expanded) {
  const std::string code = without_comments(source_line);
  int column = 0;
  for (const Token& token : lex(code)) {
    if (token.kind != Token::Kind::identifier || expanded.count(token.spelling) != 0) continue;
    if (column != 0) return 0;
    column = static_cast<int>(offset_in(code, token)) + 1;
  }
  return column;
}

}  // namespace

int column_in(std::string_view source_line, std::string_view spelling, std::size_t rank, std::size_t count) {
  const std::string code = without_comments(source_line);
  std::vector<int> columns;
  for (const Token& token : with_operators_joined(lex(code), code))
    if (token.spelling == spelling) columns.push_back(static_cast<int>(offset_in(code, token)) + 1);
  return columns.size() == count && rank < count ? columns[rank] : 0;
}

bool is_whole_word(std::string_view text, std::size_t at, std::size_t length) {
  const std::string_view word = text.substr(at, length);
  const std::string_view behind = text.substr(at + word.size());
  const bool joined_before =
      at > 0 && !word.empty() && continues_identifier(text[at - 1]) && continues_identifier(word.front());
  const bool joined_behind = !behind.empty() && !word.empty() && continues_identifier(behind.front()) &&
                             continues_identifier(word.back());
  return !joined_before && !joined_behind;
}

int column_of_word(std::string_view word, std::string_view line) {
  if (word.empty()) return 0;
  int column = 0;
  for (std::size_t at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
    if (!is_whole_word(line, at, word.size())) continue;
    if (column != 0) return 0;
    column = static_cast<int>(at) + 1;
  }
  return column;
}

int column_after_code(std::string_view source_line) {
  const std::string code = without_comments(source_line);
  const std::size_t last = code.find_last_not_of(" \t");
  return last == std::string::npos ? 1 : static_cast<int>(last) + 2;
}

TokenPlaces::TokenPlaces(const std::string& preprocessed, std::string main_file)
    : tokens_(with_operators_joined(lex(preprocessed), preprocessed)), main_file_(std::move(main_file)) {}

std::string TokenPlaces::one_per_line() const {
  std::string text;
  for (const Token& token : tokens_) text.append(token.spelling).append("\n");
  return text;
}

std::string TokenPlaces::file_of(const Token& token) const {
  return token.file.empty() ? main_file_ : std::string(token.file);
}

bool TokenPlaces::same_line(std::size_t a, std::size_t b) const {
  return tokens_[a].line == tokens_[b].line && tokens_[a].file == tokens_[b].file;
}

TokenPlace TokenPlaces::at(std::size_t index, const SourceFiles& sources) const {
  std::size_t first = index;
  while (first > 0 && same_line(first - 1, index)) --first;
  std::set<std::string_view> expanded;
  std::size_t rank = 0;
  std::size_t count = 0;
  for (std::size_t i = first; i < tokens_.size() && same_line(i, index); ++i) {
    expanded.insert(tokens_[i].spelling);
    if (tokens_[i].spelling != tokens_[index].spelling) continue;
    if (i < index) ++rank;
    ++count;
  }
  TokenPlace place{file_of(tokens_[index]), tokens_[index].line, 0};
  const std::string source_line = sources.line(place.file, place.line);
  place.column = column_in(source_line, tokens_[index].spelling, rank, count);
  if (place.column == 0) place.column = column_of_macro(source_line, expanded);
  return place;
}

TokenPlace TokenPlaces::after(std::size_t index, const SourceFiles& sources) const {
  TokenPlace place = at(index, sources);
  const bool last_of_line = index + 1 == tokens_.size() || !same_line(index, index + 1);
  if (last_of_line) {
    place.column = column_after_code(sources.line(place.file, place.line));
  } else if (place.column != 0) {
    place.column += static_cast<int>(tokens_[index].spelling.size());
  }
  return place;
}

// The declaration begins `float name(`.
bool TokenPlaces::declares(std::size_t index, std::string_view name) const {
  return tokens_[index].spelling == name && tokens_[index + 1].spelling == "(" &&
         tokens_[index - 1].kind == Token::Kind::identifier && tokens_[index - 1].spelling != "return";
}

std::size_t TokenPlaces::function(std::string_view name) const {
  std::size_t declared = size();
  for (std::size_t i = 1; i + 1 < size(); ++i) {
    if (!declares(i, name)) continue;
    if (declared == size()) declared = i;
    std::size_t end = i + 1;
    while (end < size() && tokens_[end].spelling != "{" && tokens_[end].spelling != ";") ++end;
    if (end < size() && tokens_[end].spelling == "{") return i;
  }
  return declared;
}

}  // namespace penumbra::hlsl
