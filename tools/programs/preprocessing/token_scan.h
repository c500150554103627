// Splits a text into preprocessing tokens. Internal to this folder.
//
// As in FXC, a token ends at a line's end, whether or not '\' joins the next line to it, and a number ends
// before letters that are no part of it: "2D" is 2 and D.
#pragma once

#include "preprocessing/spellings.h"
#include "preprocessing/token.h"

namespace penumbra::preprocessing {

class TokenScan {
 public:
  TokenScan(std::string_view text, Spellings& spellings) : text_(text), spellings_(spellings) {}

  Token next();
  const Place& place() const { return place_; }  // place of the token that next() returned last
  std::string_view rest() const { return text_.substr(at_); }
  const Place& open_comment() const { return open_comment_; }  // line 0 if every comment is closed

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  Place here() const { return {line_, static_cast<int>(at_ - line_begin_) + 1}; }
  void newline();
  bool skip_joins();
  bool skip_gap();
  void line_comment();
  void block_comment();
  Kind number();
  void digits(std::string_view allowed);
  Kind string();
  Kind punctuation();

  std::string_view text_;
  Spellings& spellings_;
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  int line_ = 1;
  Place place_;
  Place open_comment_;
};

}  // namespace penumbra::preprocessing
