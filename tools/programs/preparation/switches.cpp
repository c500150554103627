#include <algorithm>
#include <charconv>
#include <map>

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

// Returns the ':' of the label that goes on here, not one of `a ? b : c` or `A::b`; the ';', '{' or `close`
// that comes before it otherwise.
std::size_t label_end(const TokenText& text, std::size_t at, std::size_t close) {
  std::size_t choices = 0;
  for (; at < close && !text.is_any(at, ";", "{"); ++at) {
    if (text.is(at, "?")) ++choices;
    if (text.is(at, "(") && text.matching_bracket(at) != npos) at = text.matching_bracket(at);
    if (!text.is(at, ":")) continue;
    if (text.is(at + 1, ":")) {
      ++at;
    } else if (choices-- == 0) {
      return at;
    }
  }
  return std::min(at, close);
}

class CaseLabels {
 public:
  explicit CaseLabels(TokenText& text) : text_(text), types_(text.types()) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos) functions_.push_back(text_.word(function.name));
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
    const std::size_t end = label_end(text_, at + 1, text_.size());
    if (!text_.is(end, ":")) return;
    text_.error(at, "'" + text_.name(at) + "' is in no switch: a label belongs in a switch's braces");
    text_.erase(at, end + 1 - at);
  }

  void check(std::size_t label) {
    const std::size_t first = label + 1;
    const std::size_t end = label_end(text_, first, open_.back().close);
    if (!text_.is(end, ":") || end == first) return;
    for (std::size_t at = first; at < end; ++at) {
      if (varies(at)) return refuse(label, first, end, "a case label must be a constant, and '", at);
      if (text_.is_number(at) && end == first + 1 &&
          shape_of_number(text_.word(at)).base == NumberShape::Base::real)
        return refuse(label, first, end, "a case label must be an integer, and this is '", at);
    }
    repeat(label, first, end);
  }

  void refuse(std::size_t label, std::size_t first, std::size_t end, std::string_view what, std::size_t at) {
    const bool number = text_.is_number(at);
    text_.error(label, std::string(what) + text_.name(at) +
                           (number ? "'" : "' is not: use a number, a static const, or if and else"));
    replace(first, end);
  }

  bool varies(std::size_t at) {
    const bool scoped =
        (text_.is(at - 1, ":") && text_.is(at - 2, ":")) || (text_.is(at + 1, ":") && text_.is(at + 2, ":"));
    if (!text_.is_identifier(at) || text_.is(at - 1, ".") || scoped) return false;
    const std::string_view word = text_.word(at);
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
      if (negative || value.last != value.end + 2 || !text_.is_number(value.end + 1)) return std::nullopt;
      return integer_of(text_.word(value.end + 1));
    }
    const std::optional<std::int64_t> value =
        text_.is_number(number) ? integer_of(text_.word(number)) : std::nullopt;
    return value && negative ? std::optional(-*value) : value;
  }

  void repeat(std::size_t label, std::size_t first, std::size_t end) {
    const std::optional<std::int64_t> value = value_of(first, end);
    if (!value) return;
    const auto [known, is_new] = open_.back().labels.emplace(*value, label);
    if (is_new) return;
    text_.error(label, "the switch has case " + std::to_string(*value) + " already, in line " +
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

constexpr int deepest_statement = 200;  // deeper statements are not checked

class SwitchCases {
 public:
  explicit SwitchCases(TokenText& text) : text_(text) {}

  void run() {
    for (std::size_t at = 0; at + 2 < text_.size(); ++at) {
      if (!text_.is(at, "switch") || !text_.is(at + 1, "(")) continue;
      const std::size_t condition = text_.matching_bracket(at + 1);
      if (condition == npos || !text_.is(condition + 1, "{") || text_.matching_bracket(condition + 1) == npos)
        continue;
      check(condition + 1, text_.matching_bracket(condition + 1));
    }
  }

 private:
  bool is_label(std::size_t at) const {
    return text_.is(at, "case") || (text_.is(at, "default") && text_.is(at + 1, ":"));
  }

  void check(std::size_t open, std::size_t close) {
    std::size_t label = npos;
    bool is_empty = true;
    bool has_code = false;
    bool ended = false;
    refuse_continues(open, close);
    for (std::size_t at = open + 1; at < close;) {
      if (is_label(at)) {
        if (has_code && !ended) report(label);
        label = at;
        is_empty = true;
        has_code = ended = false;
        at = label_end(text_, at + 1, close);
        if (text_.is(at, ":")) ++at;
        continue;
      }
      is_empty = false;
      const bool lone = text_.is(at, ";");
      const std::size_t end = statement_end(at, close, 0);
      has_code = has_code || !lone;
      ended = ended || ends(at, end, 0);
      at = end;
    }
    if (has_code && !ended) report(label);
    if (is_empty && label != npos) text_.error(label, "the last case of a switch is empty: write break");
  }

  // Refuses a `continue` of a loop around the switch. Nested loops and switches have their own.
  void refuse_continues(std::size_t open, std::size_t close) {
    for (std::size_t at = open + 1; at < close; ++at) {
      if (is_loop(at) || (text_.is(at, "switch") && text_.is(at + 1, "("))) {
        at = statement_end(at, close, 0) - 1;
      } else if (text_.is(at, "continue")) {
        text_.error(at, "HLSL has no continue in a switch: set a variable, and continue after the switch");
      }
    }
  }

  bool is_loop(std::size_t at) const { return text_.is_any(at, "for", "while", "do"); }

  void report(std::size_t label) {
    if (label == npos) return;
    text_.error(label,
                "this case has code and ends without break or return, and HLSL does not fall through: end it "
                "with break, or repeat the code of the next one");
  }

  // Returns one past the statement's last token.
  std::size_t statement_end(std::size_t at, std::size_t close, int depth) const {
    if (depth > deepest_statement) return close;
    at = text_.after_subscripts(at);
    if (text_.is(at, "{")) return text_.matching_bracket(at) == npos ? close : text_.matching_bracket(at) + 1;
    while (text_.is(at, "if")) {
      at = statement_end(behind_condition(at), close, depth + 1);
      if (!text_.is(at, "else")) return at;
      ++at;
      at = text_.after_subscripts(at);
      if (!text_.is(at, "if")) return statement_end(at, close, depth + 1);
    }
    if (text_.is_any(at, "for", "while", "switch"))
      return statement_end(behind_condition(at), close, depth + 1);
    for (; at < close && !text_.is(at, ";"); ++at)
      if ((text_.is_any(at, "(", "{", "[")) && text_.matching_bracket(at) != npos)
        at = text_.matching_bracket(at);
    return at < close ? at + 1 : close;
  }

  std::size_t behind_condition(std::size_t keyword) const {
    const bool has_condition = text_.is(keyword + 1, "(") && text_.matching_bracket(keyword + 1) != npos;
    return has_condition ? text_.matching_bracket(keyword + 1) + 1 : keyword + 1;
  }

  // Returns whether no path leads past the statement. Loops and conditions without variables are assumed to
  // be constant, and a nested switch to be exhaustive, if they contain a return or break.
  bool ends(std::size_t at, std::size_t end, int depth) const {
    if (depth > deepest_statement) return true;
    while (at < end && text_.is(at, "[") && text_.matching_bracket(at) != npos)
      at = text_.matching_bracket(at) + 1;
    if (text_.is_any(at, "break", "return", "continue")) return true;
    if (text_.is(at, "{")) return block_ends(at, depth);
    if (text_.is(at, "if")) return condition_ends(at, end, depth);
    if (is_loop(at) || text_.is(at, "switch")) return has_return(at, end);
    return false;
  }

  bool block_ends(std::size_t open, int depth) const {
    const std::size_t close = text_.matching_bracket(open);
    for (std::size_t at = open + 1; close != npos && at < close;) {
      const std::size_t next = statement_end(at, close, depth + 1);
      if (ends(at, next, depth + 1)) return true;
      at = next;
    }
    return close == npos;
  }

  bool condition_ends(std::size_t at, std::size_t end, int depth) const {
    const std::size_t then = behind_condition(at);
    const std::size_t then_end = statement_end(then, end, depth + 1);
    if (!ends(then, then_end, depth + 1)) return false;
    if (is_constant(at + 1, then)) return true;
    return text_.is(then_end, "else") && ends(then_end + 1, end, depth + 1);
  }

  bool is_constant(std::size_t first, std::size_t end) const {
    for (std::size_t at = first; at < end; ++at)
      if (text_.is_identifier(at) && !text_.is_any(at, "true", "false")) return false;
    return true;
  }

  bool has_return(std::size_t first, std::size_t end) const { return text_.has(first, end, "return"); }

  TokenText& text_;
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

void check_switch_cases(TokenText& text) {
  SwitchCases(text).run();
}

}  // namespace penumbra::preparation
