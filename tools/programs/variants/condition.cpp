#include "variants/condition.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hlsl/identifier.h"

namespace penumbra::variants {
namespace {

constexpr std::size_t most_tokens = 4096;
constexpr int deepest_nesting = 200;
constexpr int deepest_macro = 64;

// The macros from whose expansion a token comes, innermost first: none of them is expanded again.
struct Origin {
  std::string macro;
  std::shared_ptr<const Origin> outer;
  int depth = 1;
};

bool came_from(const std::shared_ptr<const Origin>& origin, const std::string& macro) {
  for (const Origin* level = origin.get(); level != nullptr; level = level->outer.get())
    if (level->macro == macro) return true;
  return false;
}

struct ConditionToken {
  enum class Kind { name, number, punctuation };
  Kind kind = Kind::punctuation;
  std::string text;
  std::shared_ptr<const Origin> origin;
};
using Tokens = std::vector<ConditionToken>;

Tokens split(std::string_view text, const std::shared_ptr<const Origin>& origin) {
  static constexpr std::string_view pairs[] = {"&&", "||", "==", "!=", "<=", ">=", "<<", ">>"};
  Tokens tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t end = at + 1;
    ConditionToken::Kind kind = ConditionToken::Kind::punctuation;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
      continue;
    }
    if (hlsl::continues_identifier(c)) {
      kind = hlsl::begins_identifier(c) ? ConditionToken::Kind::name : ConditionToken::Kind::number;
      while (end < text.size() && hlsl::continues_identifier(text[end])) ++end;
    } else if (std::find(std::begin(pairs), std::end(pairs), text.substr(at, 2)) != std::end(pairs)) {
      end = at + 2;
    }
    tokens.push_back({kind, std::string(text.substr(at, end - at)), origin});
    at = end;
  }
  return tokens;
}

// Expands macros, and replaces defined(X) by 1 or 0.
class Expansion {
 public:
  Expansion(const Macros& macros, std::size_t& budget, Condition& result)
      : macros_(macros), budget_(budget), result_(result) {}

  Tokens expand(Tokens waiting) {
    std::reverse(waiting.begin(), waiting.end());
    Tokens done;
    std::size_t work = 0;
    while (!waiting.empty()) {
      if (++work + waiting.size() > most_tokens || budget_ == 0) {
        result_.problem = "the condition is too long once its macros are replaced";
        return {};
      }
      --budget_;
      ConditionToken token = std::move(waiting.back());
      waiting.pop_back();
      if (token.kind != ConditionToken::Kind::name) {
        done.push_back(std::move(token));
      } else if (token.text == "defined") {
        done.push_back(number(asks_defined(waiting)));
      } else {
        replace(token, waiting, done);
      }
    }
    return done;
  }

 private:
  static ConditionToken number(bool value) { return {ConditionToken::Kind::number, value ? "1" : "0", {}}; }

  bool asks_defined(Tokens& waiting) {
    const auto take = [&](std::string_view mark) {
      if (waiting.empty() || waiting.back().text != mark) return false;
      waiting.pop_back();
      return true;
    };
    const bool open = take("(");
    if (waiting.empty() || waiting.back().kind != ConditionToken::Kind::name) {
      result_.problem = "'defined' must be followed by a name";
      return false;
    }
    const std::string name = waiting.back().text;
    waiting.pop_back();
    if (open && !take(")")) result_.problem = "')' is missing after 'defined(" + name + "'";
    result_.consulted.insert(name);
    return macros_.find(name) != macros_.end();
  }

  void replace(const ConditionToken& token, Tokens& waiting, Tokens& done) {
    result_.consulted.insert(token.text);
    const auto macro = macros_.find(token.text);
    const bool used = macro != macros_.end() && !came_from(token.origin, token.text);
    const bool called = !waiting.empty() && waiting.back().text == "(";
    if (!used || (macro->second.has_parameters && !called)) {
      done.push_back(number(false));
      return;
    }
    const int depth = token.origin == nullptr ? 1 : token.origin->depth + 1;
    if (depth > deepest_macro) {
      result_.problem = "macros are nested more than " + std::to_string(deepest_macro) + " deep";
      done.push_back(number(false));
      return;
    }
    Tokens replacement = split(macro->second.replacement,
                               std::make_shared<const Origin>(Origin{token.text, token.origin, depth}));
    if (macro->second.has_parameters) replacement = with_arguments(token.text, replacement, waiting);
    waiting.insert(waiting.end(), std::make_move_iterator(replacement.rbegin()),
                   std::make_move_iterator(replacement.rend()));
  }

  // `definition` begins with the parameters in parentheses; the arguments are taken from `waiting`. Arguments
  // are not expanded before they are put in: their macros are replaced with the rest, which differs for # and
  // ## alone.
  Tokens with_arguments(const std::string& name, const Tokens& definition, Tokens& waiting) {
    const auto refuse = [&](const std::string& problem) {
      result_.problem = "'" + name + "' " + problem;
      return Tokens{number(false)};
    };
    std::optional<std::vector<Tokens>> given = arguments(waiting);
    if (!given) return refuse("has no ')' after its arguments");
    std::vector<std::string> parameters;
    std::size_t at = 1;
    for (; at < definition.size() && definition[at].text != ")"; ++at)
      if (definition[at].text != ",") parameters.push_back(definition[at].text);
    if (given->size() == 1 && given->front().empty() && parameters.empty()) given->clear();
    if (given->size() != parameters.size())
      return refuse("takes " + std::to_string(parameters.size()) +
                    (parameters.size() == 1 ? " argument" : " arguments") + " and has " +
                    std::to_string(given->size()));
    Tokens replaced;
    for (++at; at < definition.size(); ++at) {
      if (definition[at].text == "#") return refuse("uses # or ## in its replacement list");
      const auto parameter = std::find(parameters.begin(), parameters.end(), definition[at].text);
      if (parameter == parameters.end()) {
        replaced.push_back(definition[at]);
      } else {
        const Tokens& argument = (*given)[static_cast<std::size_t>(parameter - parameters.begin())];
        replaced.insert(replaced.end(), argument.begin(), argument.end());
      }
      if (replaced.size() > most_tokens) return replaced;  // the result is too long, which expand() reports
    }
    return replaced;
  }

  // Returns the arguments of a call whose '(' is next; nothing if its ')' is missing.
  static std::optional<std::vector<Tokens>> arguments(Tokens& waiting) {
    std::vector<Tokens> found(1);
    waiting.pop_back();
    for (int depth = 1; !waiting.empty();) {
      ConditionToken token = std::move(waiting.back());
      waiting.pop_back();
      depth += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
      if (depth == 0) return found;
      if (depth == 1 && token.text == ",") {
        found.emplace_back();
      } else {
        found.back().push_back(std::move(token));
      }
    }
    return std::nullopt;
  }

  const Macros& macros_;
  std::size_t& budget_;
  Condition& result_;
};

class Evaluation {
 public:
  Evaluation(const Tokens& tokens, std::string& problem) : tokens_(tokens), problem_(problem) {}

  std::int64_t value() {
    const std::int64_t result = choice();
    if (at_ < tokens_.size()) fail("'" + tokens_[at_].text + "' is not expected here");
    return result;
  }

 private:
  struct Operator {
    std::string_view mark;
    int precedence;
  };

  static int precedence_of(const std::string& mark) {
    static constexpr Operator operators[] = {{"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4},  {"&", 5},  {"==", 6},
                                             {"!=", 6}, {"<", 7},  {">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8},
                                             {">>", 8}, {"+", 9},  {"-", 9}, {"*", 10}, {"/", 10}, {"%", 10}};
    for (const Operator& known : operators)
      if (known.mark == mark) return known.precedence;
    return 0;
  }

  void fail(const std::string& problem) {
    if (problem_.empty()) problem_ = problem;
    at_ = tokens_.size();
  }

  bool take(std::string_view mark) {
    if (at_ >= tokens_.size() || tokens_[at_].text != mark) return false;
    ++at_;
    return true;
  }

  // The operand is not evaluated, so a division by zero in it is not an error.
  template <typename Read>
  std::int64_t unless(bool unused, Read read) {
    unused_ += unused ? 1 : 0;
    const std::int64_t result = at_ < tokens_.size() ? read() : 0;
    unused_ -= unused ? 1 : 0;
    return result;
  }

  std::int64_t choice() {
    const std::int64_t condition = binary(1);
    if (!take("?")) return condition;
    if (++depth_ > deepest_nesting) fail("the condition is nested too deeply");
    const std::int64_t yes = unless(condition == 0, [this] { return choice(); });
    if (!take(":")) fail("':' is missing after '?'");
    const std::int64_t no = unless(condition != 0, [this] { return choice(); });
    --depth_;
    return condition != 0 ? yes : no;
  }

  std::int64_t binary(int weakest) {
    std::int64_t left = unary();
    while (at_ < tokens_.size()) {
      const std::string& mark = tokens_[at_].text;
      const int precedence = precedence_of(mark);
      if (precedence == 0 || precedence < weakest) break;
      ++at_;
      const bool settled = (mark == "&&" && left == 0) || (mark == "||" && left != 0);
      if (at_ == tokens_.size()) fail("a value is missing after '" + mark + "'");
      left = combine(mark, left, unless(settled, [&] { return binary(precedence + 1); }));
    }
    return left;
  }

  std::int64_t unary() {
    if (at_ >= tokens_.size()) {
      fail("a value is missing");
      return 0;
    }
    const ConditionToken& token = tokens_[at_];
    if (token.kind == ConditionToken::Kind::number) {
      ++at_;
      return integer(token.text);
    }
    if (++depth_ > deepest_nesting) {
      fail("the condition is nested too deeply");
      return 0;
    }
    const std::int64_t result = signed_or_bracketed(token.text);
    --depth_;
    return result;
  }

  std::int64_t signed_or_bracketed(const std::string& mark) {
    ++at_;
    if (mark == "!") return unary() == 0 ? 1 : 0;
    if (mark == "~") return ~unary();
    if (mark == "+") return unary();
    if (mark == "-") return static_cast<std::int64_t>(0 - static_cast<std::uint64_t>(unary()));
    if (mark == "(") {
      const std::int64_t result = choice();
      if (!take(")")) fail("')' is missing");
      return result;
    }
    fail("'" + mark + "' is not expected here");
    return 0;
  }

  std::int64_t integer(const std::string& text) {
    const bool hexadecimal = text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const std::uint64_t base = hexadecimal ? 16 : (text[0] == '0' ? 8 : 10);
    std::uint64_t value = 0;
    std::size_t at = hexadecimal ? 2 : 0;
    for (; at < text.size(); ++at) {
      const int c = std::tolower(static_cast<unsigned char>(text[at]));
      const int digit = c >= 'a' ? c - 'a' + 10 : c - '0';
      if (digit < 0 || static_cast<std::uint64_t>(digit) >= base) break;
      value = value * base + static_cast<std::uint64_t>(digit);
    }
    if (text.find_first_not_of("uUlL", at) != std::string::npos) fail("'" + text + "' is not an integer");
    return static_cast<std::int64_t>(value);
  }

  std::int64_t combine(const std::string& mark, std::int64_t left, std::int64_t right) {
    const auto a = static_cast<std::uint64_t>(left);
    const auto b = static_cast<std::uint64_t>(right);
    const auto wrap = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
    if (mark == "||") return left != 0 || right != 0 ? 1 : 0;
    if (mark == "&&") return left != 0 && right != 0 ? 1 : 0;
    if (mark == "|") return wrap(a | b);
    if (mark == "^") return wrap(a ^ b);
    if (mark == "&") return wrap(a & b);
    if (mark == "==") return left == right ? 1 : 0;
    if (mark == "!=") return left != right ? 1 : 0;
    if (mark == "<") return left < right ? 1 : 0;
    if (mark == ">") return left > right ? 1 : 0;
    if (mark == "<=") return left <= right ? 1 : 0;
    if (mark == ">=") return left >= right ? 1 : 0;
    if (mark == "<<") return b < 64 ? wrap(a << b) : 0;
    if (mark == ">>") return b < 64 ? left >> b : (left < 0 ? -1 : 0);
    if (mark == "+") return wrap(a + b);
    if (mark == "-") return wrap(a - b);
    if (mark == "*") return wrap(a * b);
    if (right == 0) {
      if (unused_ == 0) fail("division by zero");
      return 0;
    }
    if (right == -1) return mark == "/" ? wrap(0 - a) : 0;
    return mark == "/" ? left / right : left % right;
  }

  const Tokens& tokens_;
  std::string& problem_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int unused_ = 0;
};

}  // namespace

Condition evaluate(std::string_view condition, const Macros& macros, std::size_t& budget) {
  Condition result;
  const Tokens tokens = Expansion(macros, budget, result).expand(split(condition, nullptr));
  if (!result.problem.empty() && tokens.empty()) return result;
  if (tokens.empty()) {
    result.problem = "the condition is empty";
    return result;
  }
  result.holds = Evaluation(tokens, result.problem).value() != 0;
  return result;
}

}  // namespace penumbra::variants
