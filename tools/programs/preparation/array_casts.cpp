#include "preparation/array_casts.h"

#include <map>
#include <string>

#include "hlsl/declarations.h"

namespace penumbra::preparation {

namespace {

bool is_zero(const TokenText& text, std::size_t at) {
  return at < text.size() && text[at].kind == hlsl::Token::Kind::number &&
         text[at].spelling.find_first_not_of("0.fFhHuU") == std::string_view::npos;
}

// Returns the '0' of `(type[2][3])0` if such a cast begins at this '('; else npos.
std::size_t cast_zero(const TokenText& text, std::size_t open) {
  if (!text.is(open, "(") || !text.is_identifier(open + 1) || !text.is(open + 2, "[")) return npos;
  std::size_t at = open + 2;
  while (text.is(at, "[") && text.matching_bracket(at) != npos && !text.is(at + 1, "]"))
    at = text.matching_bracket(at) + 1;
  return text.is(at, ")") && is_zero(text, at + 1) ? at + 1 : npos;
}

class ArrayCasts {
 public:
  explicit ArrayCasts(TokenText& text) : text_(text) {}

  void run() {
    for (const hlsl::Declaration& declaration : text_.declarations())
      for (std::size_t at = declaration.first; at <= declaration.last; ++at) rewrite(at, declaration.first);
    text_.apply();
  }

 private:
  void rewrite(std::size_t open, std::size_t before) {
    const std::size_t zero = cast_zero(text_, open);
    if (zero == npos) return;
    const std::string type(text_[open + 1].spelling);
    const std::string sizes = text_.spelled(open + 2, zero - open - 3);
    const auto [known, added] = structs_.emplace(type + " " + sizes, std::string{});
    if (added) {
      known->second = text_.free_name("penumbra_zeroes" + std::to_string(structs_.size() - 1));
      text_.insert(before, "struct " + known->second + " { " + type + " value" + sizes + "; }; ");
    }
    text_.replace(open, zero - open + 1, "((" + known->second + ")0).value");
  }

  TokenText& text_;
  std::map<std::string, std::string> structs_;  // by type and sizes
};

}  // namespace

void cast_zero_to_structs(TokenText& text) {
  ArrayCasts(text).run();
}

}  // namespace penumbra::preparation
