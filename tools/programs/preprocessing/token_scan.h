// Splits a text into tokens as glslang's preprocessor does (its PpScanner.cpp). Internal to this folder.
#pragma once

#include "preprocessing/spellings.h"
#include "preprocessing/token.h"

namespace penumbra::preprocessing {

// Returns whether the name is a macro that glslang predefines, or exceeds its length limit.
bool is_left_to_glslang(std::string_view name);

class TokenScan {
 public:
  TokenScan(std::string_view text, Spellings& spellings) : text_(text), spellings_(spellings) {}

  Token next();
  const Place& place() const { return place_; }  // place of the token that next() returned last
  int line() const { return line_; }
  std::string_view rest() const { return text_.substr(at_); }

  // Returns whether something was read that glslang always reports, or splits into tokens differently.
  bool unusual() const { return unusual_; }
  // glslang rejects "1f" outside of all conditions. Returns true if one was read since the last call.
  bool take_whole_float();

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool at_join() const { return peek() == '\\' && peek(1) == '\n'; }
  void newline();
  bool skip_joins();
  bool skip_gap();
  void line_comment();
  void block_comment();
  void word();
  Kind number();
  Kind real(bool fraction);
  Kind integer(std::size_t begin, int base);
  void digits(std::string_view allowed);
  Kind string();
  Kind punctuation();
  Token finish(Token token, std::size_t begin);
  bool goes_on(Kind kind) const;

  std::string_view text_;
  Spellings& spellings_;
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  int line_ = 1;
  Place place_;
  bool looked_ahead_ = false;  // glslang's scanner reads one character more and puts it back
  bool unusual_ = false;
  bool whole_float_ = false;
};

}  // namespace penumbra::preprocessing
