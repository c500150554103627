#include "preparation/written_values.h"

#include "hlsl/declarations.h"
#include "preparation/postfix_expression.h"

namespace penumbra::preparation {

namespace {

bool writes_a_parameter(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.parameters_open; at < function.parameters_close; ++at)
    if (text.is_any(at, "out", "inout")) return true;
  return false;
}

}  // namespace

WrittenValues::WrittenValues(const TokenText& text) : text_(text) {
  for (const hlsl::Declaration& declaration : text_.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function &&
        declaration.kind != hlsl::Declaration::Kind::prototype)
      continue;
    if (!writes_a_parameter(text_, declaration)) continue;
    const std::vector<std::string> types = hlsl::parameter_types(text_.tokens(), declaration);
    for (std::size_t i = 0; i < types.size(); ++i)
      if (types[i].rfind("out ", 0) == 0 || types[i].rfind("inout ", 0) == 0)
        out_parameters_[text_.word(declaration.name)].insert(i);
  }
}

bool WrittenValues::writes(std::size_t at) const {
  const std::size_t end = end_of_value(at);
  return assignment_length(text_, end) != 0 || stepped(at, end) || passed_out(at, end);
}

// The value includes its elements and members, but not a call.
std::size_t WrittenValues::end_of_value(std::size_t at) const {
  std::size_t end = at + 1;
  while ((text_.is(end, "[") && text_.matching_bracket(end) != npos) ||
         (text_.is(end, ".") && text_.is_identifier(end + 1)))
    end = text_.is(end, "[") ? text_.matching_bracket(end) + 1 : end + 2;
  return end;
}

bool WrittenValues::stepped(std::size_t begin, std::size_t end) const {
  const auto twice = [&](std::size_t at, std::string_view mark) {
    return text_.is(at, mark) && text_.is(at + 1, mark);
  };
  return twice(end, "+") || twice(end, "-") ||
         (begin >= 2 && (twice(begin - 2, "+") || twice(begin - 2, "-")));
}

bool WrittenValues::passed_out(std::size_t begin, std::size_t end) const {
  const bool whole_argument = (text_.is_any(begin - 1, "(", ",")) && (text_.is_any(end, ")", ","));
  if (!whole_argument) return false;
  std::size_t index = 0;
  std::size_t at = begin;
  while (at-- > 0) {
    if (text_.is(at, ",")) {
      ++index;
    } else if (text_.is_any(at, ")", "]", "}")) {
      if (text_.matching_bracket(at) == npos) return false;
      at = text_.matching_bracket(at);
    } else if (text_.is(at, "(")) {
      break;
    } else if (text_.is_any(at, ";", "{")) {
      return false;
    }
  }
  const auto function = at > 0 && text_.is_identifier(at - 1) ? out_parameters_.find(text_.word(at - 1))
                                                              : out_parameters_.end();
  return function != out_parameters_.end() && function->second.count(index) != 0;
}

}  // namespace penumbra::preparation
