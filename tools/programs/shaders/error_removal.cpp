#include "shaders/error_removal.h"

#include <optional>

#include "hlsl/declarations.h"
#include "hlsl/name_set.h"
#include "hlsl/tokens.h"

namespace penumbra::shaders {

namespace {

struct Range {  // a range of tokens, inclusive
  std::size_t first;
  std::size_t last;
};

// Replaces text by white space, except newlines and directives, so that every other token keeps its location.
void blank(std::string& text, std::size_t begin, std::size_t end) {
  bool directive = false;
  bool line_start = begin == 0 || text[begin - 1] == '\n';
  for (std::size_t i = begin; i < end; ++i) {
    if (text[i] == '\n') {
      line_start = true;
      directive = false;
      continue;
    }
    if (line_start && text[i] == '#') directive = true;
    line_start = line_start && (text[i] == ' ' || text[i] == '\t');
    if (!directive) text[i] = ' ';
  }
}

// A text and the code that can be removed around a token of it.
class Remedy {
 public:
  explicit Remedy(std::string& text) : text_(text), tokens_(hlsl::lex(text)) {}

  // Returns the last token that begins there or before; for an operator of two characters, its first.
  std::size_t token_at(std::size_t place) const {
    const auto after = std::upper_bound(
        tokens_.begin(), tokens_.end(), place, [this](std::size_t wanted, const hlsl::Token& token) {
          return wanted < static_cast<std::size_t>(token.spelling.data() - text_.data());
        });
    return after == tokens_.begin() ? 0 : static_cast<std::size_t>(after - tokens_.begin()) - 1;
  }

  // Returns false if the token is in no function's body, or its function was already emptied.
  // `lacks_semicolon` means that the token is the first one after the statement.
  bool apply(std::size_t token, bool lacks_semicolon, std::set<std::string>& emptied) {
    const std::optional<hlsl::Declaration> function = function_around(token);
    if (!function) return false;
    if (const std::optional<Range> range = part_around(*function, token, lacks_semicolon)) {
      const std::size_t end = offset(range->last) + tokens_[range->last].spelling.size();
      blank(text_, offset(range->first), end);
      if (lacks_semicolon) text_[end - 1] = ';';
      return true;
    }
    return empty_around(token, emptied);
  }

  // Removes the whole body of its function.
  bool empty_around(std::size_t token, std::set<std::string>& emptied) {
    const std::optional<hlsl::Declaration> function = function_around(token);
    if (!function) return false;
    const std::string name =
        std::string(tokens_[function->name].spelling) + " " + std::to_string(offset(function->open));
    return emptied.insert(name).second && empty(*function);
  }

 private:
  bool is(std::size_t at, std::string_view spelling) const { return tokens_[at].spelling == spelling; }

  std::size_t offset(std::size_t token) const {
    return static_cast<std::size_t>(tokens_[token].spelling.data() - text_.data());
  }

  std::optional<hlsl::Declaration> function_around(std::size_t token) const {
    for (const hlsl::Declaration& declaration : hlsl::read_declarations(tokens_))
      if (declaration.kind == hlsl::Declaration::Kind::function && declaration.open < token &&
          token <= declaration.close)
        return declaration;
    return std::nullopt;
  }

  // Returns the statement of that token without its ';', or a declaration from its '=' on; nothing if the
  // rest would not be valid HLSL.
  std::optional<Range> part_around(const hlsl::Declaration& function, std::size_t token,
                                   bool lacks_semicolon) const {
    const std::optional<Range> statement = statement_around(function, token);
    if (!statement || statement->first == statement->last) return std::nullopt;
    const std::size_t first = statement->first;
    const std::size_t last = lacks_semicolon ? token : statement->last;
    if (first == last) return std::nullopt;
    static constexpr hlsl::NameSet structure("if", "else", "for", "while", "do", "switch", "case", "default",
                                             "return", "break", "continue", "discard", "const", "static",
                                             "struct");
    if (structure.contains(tokens_[first].spelling) || is(first, "[")) return std::nullopt;
    const bool declares = tokens_[first].kind == hlsl::Token::Kind::identifier &&
                          tokens_[first + 1].kind == hlsl::Token::Kind::identifier;
    if (!declares) return Range{first, last - 1};
    std::size_t equals = first;
    while (equals < last && !is(equals, "=")) ++equals;
    for (std::size_t i = first, depth = 0; i < last; ++i) {
      if (is(i, "(") || is(i, "[") || is(i, "{")) ++depth;
      if ((is(i, ")") || is(i, "]") || is(i, "}")) && depth > 0) --depth;
      if (depth == 0 && is(i, ",")) return std::nullopt;  // the other names would be unknown
    }
    if (equals == last || token < equals) return std::nullopt;
    return Range{equals, last - 1};
  }

  // The statement extends from after the ';' or brace before the token to its own ';'.
  std::optional<Range> statement_around(const hlsl::Declaration& function, std::size_t token) const {
    std::size_t first = function.open + 1;
    std::size_t depth = 0;  // depth of ( and [
    for (std::size_t i = first; i < function.close; ++i) {
      if (is(i, "(") || is(i, "[")) ++depth;
      if ((is(i, ")") || is(i, "]")) && depth > 0) --depth;
      if (depth > 0) continue;
      const bool ends = is(i, ";");
      if (ends && token >= first && token <= i) return Range{first, i};
      if (!ends && !is(i, "}") && (!is(i, "{") || is(i - 1, "="))) continue;
      if (i > token) return std::nullopt;
      first = i + 1;
    }
    return std::nullopt;
  }

  bool empty(const hlsl::Declaration& function) {
    static constexpr hlsl::NameSet modifiers("static", "inline", "precise", "export", "const");
    std::string type;
    for (std::size_t i = function.type; i < function.name; ++i)
      if (!modifiers.contains(tokens_[i].spelling)) type += std::string(tokens_[i].spelling) + " ";
    const std::size_t open = offset(function.open);
    const std::size_t close = offset(function.close);
    blank(text_, open + 1, close);
    // The value, of any type, is on the line of the '}': without it the missing return would be an error.
    if (type != "void ") text_.insert(close, type + "penumbra_unset; return penumbra_unset; ");
    return true;
  }

  std::string& text_;
  std::vector<hlsl::Token> tokens_;
};

}  // namespace

ErrorRemoval::ErrorRemoval(std::string text) : text_(std::move(text)) {}

bool ErrorRemoval::remove_part(std::size_t offset, bool lacks_semicolon) {
  Remedy remedy(text_);
  return remedy.apply(remedy.token_at(offset), lacks_semicolon, emptied_);
}

bool ErrorRemoval::remove_body(std::size_t offset) {
  Remedy remedy(text_);
  return remedy.empty_around(remedy.token_at(offset), emptied_);
}

}  // namespace penumbra::shaders
