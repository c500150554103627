// Reads the tokens of a .shader file and reports errors. Internal to this folder.
#pragma once

#include "hlsl/diagnostic.h"
#include "shaderlab/lexer.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

// Ends the parse; only parse_shader() catches it.
struct SyntaxError {
  Place place;
  std::string message;
};

class Cursor {
 public:
  Cursor(std::string file, std::string_view text, const Lexed& lexed);

  const Token& peek() const { return lexed_.tokens[at_]; }
  const Token& take();  // does not advance at the end of the file

  bool at(Token::Kind kind) const { return peek().kind == kind; }
  bool at_punctuation(char mark) const;
  bool at_word(std::string_view keyword) const;  // ignores case
  bool take_punctuation(char mark);
  bool take_word(std::string_view keyword);
  bool at_end() const { return at(Token::Kind::end); }
  const CodeBlock& take_program() { return lexed_.programs[take().program]; }

  // `what` completes "expected ...": "'{' after the name of the shader".
  void expect_mark(char mark, std::string_view what);
  Name expect_text(std::string_view what);
  Name expect_word(std::string_view what);
  double expect_number(std::string_view what);

  // Reports "expected <what>, found <token>" at the next token.
  [[noreturn]] void fail(std::string_view what) const;
  [[noreturn]] void fail_at(const Place& place, const std::string& message) const;
  // These three record a message, and the parse continues.
  void warn(const Place& place, const std::string& message);
  void error(const Place& place, const std::string& message);
  void say(const Place& place, hlsl::Severity severity, const std::string& message);
  bool warns() const;  // false once there are so many messages that further ones are only counted

  hlsl::Diagnostic diagnostic(const Place& place, hlsl::Severity severity, const std::string& message) const;
  std::vector<hlsl::Diagnostic> take_diagnostics();

 private:
  std::string file_;
  std::string_view text_;
  const Lexed& lexed_;
  std::size_t at_ = 0;
  std::size_t left_out_ = 0;
  bool left_out_errors_ = false;
  std::vector<hlsl::Diagnostic> diagnostics_;
};

Name name_of(const Token& token);

// Returns "did you mean 'Cull'?", or nothing when no known name is near or the given one is too long to be a
// typing error.
std::string near_name_hint(std::string_view given, const std::vector<std::string>& known);

// A Diagnostic at a location in a text.
//
// Lines that are too long for a screen are omitted.
hlsl::Diagnostic diagnostic_at(const std::string& file, std::string_view text, const Place& place,
                               hlsl::Severity severity, const std::string& message);

}  // namespace penumbra::shaderlab
