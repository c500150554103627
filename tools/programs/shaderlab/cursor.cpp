#include "shaderlab/cursor.h"

#include <charconv>
#include <utility>

#include "input/nearest_name.h"
#include "shaderlab/characters.h"

namespace penumbra::shaderlab {

namespace {

constexpr std::size_t kMostMessages = 100;
constexpr std::size_t kLongestShown = 40;

std::string shown(const Token& token) {
  const std::string spelling = token.spelling.size() <= kLongestShown
                                   ? std::string(token.spelling)
                                   : std::string(token.spelling.substr(0, kLongestShown)) + "...";
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the file";
    case Token::Kind::string:
      return "\"" + spelling + "\"";
    case Token::Kind::bracket:
      return "[" + spelling + "]";
    default:
      return "'" + spelling + "'";
  }
}

constexpr std::size_t kLongestLine = 400;

}  // namespace

Cursor::Cursor(std::string file, std::string_view text, const Lexed& lexed)
    : file_(std::move(file)), text_(text), lexed_(lexed) {}

const Token& Cursor::take() {
  const Token& token = peek();
  if (token.kind == Token::Kind::broken) fail_at(token.place, lexed_.broken_message);
  if (token.kind != Token::Kind::end) ++at_;
  return token;
}

bool Cursor::at_punctuation(char mark) const {
  return at(Token::Kind::punctuation) && peek().spelling.front() == mark;
}

bool Cursor::at_word(std::string_view keyword) const {
  return at(Token::Kind::identifier) && same_keyword(peek().spelling, keyword);
}

bool Cursor::take_punctuation(char mark) {
  if (!at_punctuation(mark)) return false;
  take();
  return true;
}

bool Cursor::take_word(std::string_view keyword) {
  if (!at_word(keyword)) return false;
  take();
  return true;
}

void Cursor::expect_mark(char mark, std::string_view what) {
  if (!take_punctuation(mark)) fail(std::string("'") + mark + "' " + std::string(what));
}

Name Cursor::expect_text(std::string_view what) {
  if (!at(Token::Kind::string)) fail(std::string(what) + " in quotes");
  return name_of(take());
}

Name Cursor::expect_word(std::string_view what) {
  if (!at(Token::Kind::identifier)) fail(what);
  return name_of(take());
}

double Cursor::expect_number(std::string_view what) {
  if (!at(Token::Kind::number)) {
    const bool suffixed = at(Token::Kind::identifier) && is_digit(peek().spelling.front());
    fail(std::string(what) + (suffixed ? " without a suffix" : ""));
  }
  std::string_view spelling = take().spelling;
  if (spelling.front() == '+') spelling.remove_prefix(1);
  double value = 0;  // remains when the number is out of range
  std::from_chars(spelling.data(), spelling.data() + spelling.size(), value);
  return value;
}

void Cursor::fail(std::string_view what) const {
  const Token& token = peek();
  if (token.kind == Token::Kind::broken) fail_at(token.place, lexed_.broken_message);
  fail_at(token.place, "expected " + std::string(what) + ", found " + shown(token));
}

void Cursor::fail_at(const Place& place, const std::string& message) const {
  throw SyntaxError{place, message};
}

void Cursor::warn(const Place& place, const std::string& message) {
  say(place, hlsl::Severity::warning, message);
}

void Cursor::error(const Place& place, const std::string& message) {
  say(place, hlsl::Severity::error, message);
}

void Cursor::say(const Place& place, hlsl::Severity severity, const std::string& message) {
  if (warns()) {
    diagnostics_.push_back(diagnostic(place, severity, message));
  } else {
    ++left_out_;
    left_out_errors_ |= severity == hlsl::Severity::error;
  }
}

bool Cursor::warns() const {
  return diagnostics_.size() < kMostMessages;
}

hlsl::Diagnostic Cursor::diagnostic(const Place& place, hlsl::Severity severity,
                                    const std::string& message) const {
  return diagnostic_at(file_, text_, place, severity, message);
}

std::vector<hlsl::Diagnostic> Cursor::take_diagnostics() {
  if (left_out_ > 0) {
    // A file must fail even if all of its errors were omitted.
    diagnostics_.push_back({file_,
                            0,
                            0,
                            left_out_errors_ ? hlsl::Severity::error : hlsl::Severity::note,
                            std::to_string(left_out_) + " further messages are left out",
                            {}});
    left_out_ = 0;
  }
  return std::move(diagnostics_);
}

Name name_of(const Token& token) {
  return {std::string(token.spelling), token.place};
}

std::string near_name_hint(std::string_view given, const std::vector<std::string>& known) {
  if (given.size() > kLongestShown) return {};
  const std::string nearest = nearest_name(given, known);
  return nearest.empty() ? std::string() : "did you mean '" + nearest + "'?";
}

hlsl::Diagnostic diagnostic_at(const std::string& file, std::string_view text, const Place& place,
                               hlsl::Severity severity, const std::string& message) {
  const std::size_t begin = place.offset - static_cast<std::size_t>(place.column - 1);
  const std::string_view shown = text.substr(begin, kLongestLine + 1);
  const std::size_t length = std::min(shown.find('\n'), shown.size());
  return {file,     place.line, place.column,
          severity, message,    length > kLongestLine ? std::string() : std::string(shown.substr(0, length))};
}

}  // namespace penumbra::shaderlab
