#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/declarators.h"
#include "preparation/number_shape.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr int deepest_constant = 200;

struct OpenSwitch {
  std::size_t close = npos;
  std::map<std::int64_t, std::size_t> labels;  // labels that are literals, by value
};

// Returns the integer of 12, 12u, 0xC.
std::optional<std::int64_t> integer_of(std::string_view number) {
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  const bool octal = !hexadecimal && number.size() > 1 && number[0] == '0';
  if (hexadecimal) number.remove_prefix(2);
  std::int64_t value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value,
                                    hexadecimal ? 16
                                    : octal     ? 8
                                                : 10);
  if (read.ec != std::errc()) return std::nullopt;
  const std::string_view rest(read.ptr, static_cast<std::size_t>(number.data() + number.size() - read.ptr));
  return rest.find_first_not_of("uUlL") == std::string_view::npos ? std::optional(value) : std::nullopt;
}

class CaseLabels {
 public:
  explicit CaseLabels(TokenText& text) : text_(text), types_(text.types()) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos) functions_.push_back(text_[function.name].spelling);
    std::sort(functions_.begin(), functions_.end());
  }

  void run() {
    for (std::size_t at = 0; at + 2 < text_.size(); ++at) {
      while (!open_.empty() && at >= open_.back().close) open_.pop_back();
      if (text_.is(at, "switch")) enter(at);
      if (text_.is(at, "case") && !open_.empty()) check(at);
      if (open_.empty()) refuse_outside(at);
    }
    text_.apply();
  }

 private:
  void enter(std::size_t at) {
    const std::size_t condition = text_.matching_bracket(at + 1);
    if (!text_.is(at + 1, "(") || condition == npos || !text_.is(condition + 1, "{")) return;
    const std::size_t close = text_.matching_bracket(condition + 1);
    if (close != npos) open_.push_back({close, {}});
  }

  // glslang crashes on a label that is in no switch: it is removed.
  void refuse_outside(std::size_t at) {
    const bool other = text_.is(at, "default") && text_.is(at + 1, ":");
    if (!other && !text_.is(at, "case")) return;
    const std::size_t end = label_end(at + 1, text_.size());
    if (end == npos) return;
    text_.note(
        at, hlsl::Severity::error,
        "'" + std::string(text_[at].spelling) + "' is in no switch: a label belongs in a switch's braces");
    text_.erase(at, end + 1 - at);
  }

  // Returns the ':' of the label, not one of `a ? b : c` or `A::b`.
  std::size_t label_end(std::size_t at, std::size_t close) const {
    std::size_t choices = 0;
    for (; at < close && !text_.is(at, ";") && !text_.is(at, "{"); ++at) {
      if (text_.is(at, "?")) ++choices;
      if (text_.is(at, "(") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at);
      if (!text_.is(at, ":")) continue;
      if (text_.is(at + 1, ":")) {
        ++at;
      } else if (choices-- == 0) {
        return at;
      }
    }
    return npos;
  }

  void check(std::size_t label) {
    const std::size_t first = label + 1;
    const std::size_t end = label_end(first, open_.back().close);
    if (end == npos || end == first) return;
    for (std::size_t at = first; at < end; ++at) {
      if (varies(at)) return refuse(label, first, end, "a case label must be a constant, and '", at);
      if (text_[at].kind == hlsl::Token::Kind::number && end == first + 1 &&
          shape_of_number(text_[at].spelling).base == NumberShape::Base::real)
        return refuse(label, first, end, "a case label must be an integer, and this is '", at);
    }
    repeat(label, first, end);
  }

  void refuse(std::size_t label, std::size_t first, std::size_t end, std::string_view what, std::size_t at) {
    const bool number = text_[at].kind == hlsl::Token::Kind::number;
    text_.note(label, hlsl::Severity::error,
               std::string(what) + std::string(text_[at].spelling) +
                   (number ? "'" : "' is not: use a number, a static const, or if and else"));
    replace(first, end);
  }

  bool varies(std::size_t at) {
    const bool scoped =
        (text_.is(at - 1, ":") && text_.is(at - 2, ":")) || (text_.is(at + 1, ":") && text_.is(at + 2, ":"));
    if (!text_.is_identifier(at) || text_.is(at - 1, ".") || scoped) return false;
    const std::string_view word = text_[at].spelling;
    if (text_.is(at + 1, "("))
      return !is_number_type(word) && std::binary_search(functions_.begin(), functions_.end(), word);
    const std::size_t named = types_.named(at);
    if (named == npos) return false;
    const DeclaredValue& value = types_.declared()[named];
    if (!value.type.constant || value.place == DeclaredValue::Place::parameter) return true;
    if (value.place == DeclaredValue::Place::global && !value.is_static) return true;
    if (const auto known = varying_.find(named); known != varying_.end()) return known->second;
    if (depth_ == deepest_constant) return false;
    varying_[named] = false;  // while its own value is examined
    ++depth_;
    bool any = false;
    for (std::size_t part = value.end; part < value.last && !any; ++part) any = varies(part);
    --depth_;
    return varying_[named] = any;
  }

  // Returns the value of a literal, or of a constant initialised with one.
  std::optional<std::int64_t> value_of(std::size_t first, std::size_t end) const {
    const bool negative = text_.is(first, "-");
    const std::size_t number = first + (negative ? 1 : 0);
    if (end != number + 1) return std::nullopt;
    if (const std::size_t named = types_.named(number); named != npos) {
      const DeclaredValue& value = types_.declared()[named];
      if (negative || value.last != value.end + 2 || text_[value.end + 1].kind != hlsl::Token::Kind::number)
        return std::nullopt;
      return integer_of(text_[value.end + 1].spelling);
    }
    const std::optional<std::int64_t> value =
        text_[number].kind == hlsl::Token::Kind::number ? integer_of(text_[number].spelling) : std::nullopt;
    return value && negative ? std::optional(-*value) : value;
  }

  void repeat(std::size_t label, std::size_t first, std::size_t end) {
    const std::optional<std::int64_t> value = value_of(first, end);
    if (!value) return;
    const auto [known, is_new] = open_.back().labels.emplace(*value, label);
    if (is_new) return;
    text_.note(label, hlsl::Severity::error,
               "the switch has case " + std::to_string(*value) + " already, in line " +
                   std::to_string(text_[known->second].line) + ": remove one of the two");
    replace(first, end);
  }

  // glslang crashes on labels that are not constant.
  void replace(std::size_t first, std::size_t end) {
    text_.replace(first, end - first, std::to_string(unused_label_--));
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<std::string_view> functions_;
  std::vector<OpenSwitch> open_;
  int unused_label_ = 2147480000;
  std::map<std::size_t, bool> varying_;  // for each declared value: true if it is no constant
  int depth_ = 0;                        // depth in constants that are made of others
};

}  // namespace

void check_case_labels(TokenText& text) {
  const auto& tokens = text.tokens();
  if (std::none_of(tokens.begin(), tokens.end(), [](const hlsl::Token& token) {
        return token.spelling == "switch" || token.spelling == "case" || token.spelling == "default";
      }))
    return;
  CaseLabels(text).run();
}

}  // namespace penumbra::preparation
