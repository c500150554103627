#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

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
        at = behind_label(at, close);
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
    if (is_empty && label != npos)
      text_.note(label, hlsl::Severity::error, "the last case of a switch is empty: write break");
  }

  // Refuses a `continue` of a loop around the switch. Nested loops and switches have their own.
  void refuse_continues(std::size_t open, std::size_t close) {
    for (std::size_t at = open + 1; at < close; ++at) {
      if (is_loop(at) || (text_.is(at, "switch") && text_.is(at + 1, "("))) {
        at = statement_end(at, close, 0) - 1;
      } else if (text_.is(at, "continue")) {
        text_.note(at, hlsl::Severity::error,
                   "HLSL has no continue in a switch: set a variable, and continue after the switch");
      }
    }
  }

  bool is_loop(std::size_t at) const {
    return text_.is(at, "for") || text_.is(at, "while") || text_.is(at, "do");
  }

  void report(std::size_t label) {
    if (label == npos) return;
    text_.note(label, hlsl::Severity::error,
               "this case has code and ends without break or return, and HLSL does not fall through: end it "
               "with break, or repeat the code of the next one");
  }

  // Returns the token after the ':' of a label, not of `a ? b : c` and `A::b`.
  std::size_t behind_label(std::size_t at, std::size_t close) const {
    std::size_t choices = 0;
    for (++at; at < close; ++at) {
      if (text_.is(at, "?")) ++choices;
      if (text_.is(at, "(") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at);
      if (text_.is(at, "{") || text_.is(at, ";")) return at;
      if (!text_.is(at, ":")) continue;
      if (text_.is(at + 1, ":")) {
        ++at;
      } else if (choices == 0) {
        return at + 1;
      } else {
        --choices;
      }
    }
    return close;
  }

  // Returns one past the statement's last token.
  std::size_t statement_end(std::size_t at, std::size_t close, int depth) const {
    if (depth > deepest_statement) return close;
    while (text_.is(at, "[") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at) + 1;
    if (text_.is(at, "{")) return text_.matching_bracket(at) == npos ? close : text_.matching_bracket(at) + 1;
    while (text_.is(at, "if")) {
      at = statement_end(behind_condition(at), close, depth + 1);
      if (!text_.is(at, "else")) return at;
      ++at;
      while (text_.is(at, "[") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at) + 1;
      if (!text_.is(at, "if")) return statement_end(at, close, depth + 1);
    }
    if (text_.is(at, "for") || text_.is(at, "while") || text_.is(at, "switch"))
      return statement_end(behind_condition(at), close, depth + 1);
    for (; at < close && !text_.is(at, ";"); ++at)
      if ((text_.is(at, "(") || text_.is(at, "{") || text_.is(at, "[")) && text_.matching_bracket(at) != npos)
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
    if (text_.is(at, "break") || text_.is(at, "return") || text_.is(at, "continue")) return true;
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
      if (text_.is_identifier(at) && !text_.is(at, "true") && !text_.is(at, "false")) return false;
    return true;
  }

  bool has_return(std::size_t first, std::size_t end) const {
    for (std::size_t at = first; at < end; ++at)
      if (text_.is(at, "return")) return true;
    return false;
  }

  TokenText& text_;
};

}  // namespace

void check_switch_cases(TokenText& text) {
  SwitchCases(text).run();
}

}  // namespace penumbra::preparation
