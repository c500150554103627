#include <string>
#include <string_view>

#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

constexpr std::size_t deepest = 1000;
constexpr std::size_t most_operators =
    8000;  // each is a level of the syntax tree, which is traversed recursively

class Nesting {
 public:
  explicit Nesting(TokenText& text) : text_(text) {}

  bool run() {
    for (std::size_t at = 0; at < text_.size(); ++at) {
      count(at);
      const bool deep = brackets_ > deepest || prefixes_ > deepest || in_statement_ > deepest;
      if (!deep && operators_ <= most_operators) continue;
      text_.note(
          at, hlsl::Severity::error,
          deep ? "more than " + std::to_string(deepest) + " levels of nesting: split it"
               : "more than " + std::to_string(most_operators) + " operators in one expression: split it");
      return false;
    }
    return true;
  }

 private:
  void count(std::size_t at) {
    const char lead = text_.lead(at);
    if (lead == '(' || lead == '[' || lead == '{') ++brackets_;
    if ((lead == ')' || lead == ']' || lead == '}') && brackets_ > 0) --brackets_;
    if (lead == ';' || lead == '{' || lead == '}') in_statement_ = 0;
    if (lead == ';' || lead == '{' || lead == '}' || lead == ',') operators_ = 0;
    if (lead != '\0' && std::string_view("+-*/%&|^<>=.").find(lead) != std::string_view::npos) ++operators_;
    if (lead == '?' || text_.is(at, "if") || text_.is(at, "for") || text_.is(at, "while")) ++in_statement_;
    prefixes_ = lead == '-' || lead == '+' || lead == '!' || lead == '~' || in_cast(at) ? prefixes_ + 1 : 0;
  }

  // Returns whether it is a token of `(name)`: a run of casts has three tokens each.
  bool in_cast(std::size_t at) const {
    const auto is_cast = [&](std::size_t open) {
      return text_.is(open, "(") && text_.is_identifier(open + 1) && text_.is(open + 2, ")");
    };
    return is_cast(at) || (at > 0 && is_cast(at - 1)) || (at > 1 && is_cast(at - 2));
  }

  TokenText& text_;
  std::size_t brackets_ = 0;
  std::size_t prefixes_ = 0;
  std::size_t operators_ = 0;     // number since the last ',' or end of a statement
  std::size_t in_statement_ = 0;  // conditions without a ';' or a brace between them
};

}  // namespace

bool check_nesting(TokenText& text) {
  return Nesting(text).run();
}

}  // namespace penumbra::preparation
