// Matrix swizzles of two to four elements, `m._m03_m13_m23` and `m._11_22` (HLSL: docs "Matrix Ordering and
// swizzling"). glslang's SPIR-V back end does not support them: it crashes, prints "Missing functionality"
// and continues, or emits invalid SPIR-V.
//
// - Reads: the swizzled expression becomes the argument of a generated function, with an overload for every
//   shape of matrix that has the elements; so it is evaluated once, including calls.
// - Simple or compound assignments that are a statement of their own: a block that evaluates the right side
//   first and then assigns element by element. The matrix expression is repeated, so it must not contain a
//   call, ++ or --: such statements are not changed, and glslang reports an error.
//
// Single elements (`m._m00`) work and are not changed. If a struct of the text has a member of the same name,
// no swizzle of that name is changed.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>

#include "hlsl/declarations.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

struct Element {
  int row;
  int column;
};

// Returns the elements of "_m03_m13" (from 0) or "_14_24" (from 1); fewer than two if the identifier is not
// such a swizzle.
std::vector<Element> swizzle(std::string_view word) {
  std::vector<Element> elements;
  const bool from_zero = word.size() > 1 && word[1] == 'm';
  const std::size_t length = from_zero ? 4 : 3;
  const char first = from_zero ? '0' : '1';
  if (word.size() % length != 0 || word.size() > 4 * length) return {};
  for (std::size_t at = 0; at < word.size(); at += length) {
    const int row = word[at + length - 2] - first;
    const int column = word[at + length - 1] - first;
    const bool fits = word[at] == '_' && (!from_zero || word[at + 1] == 'm') && row >= 0 && row < 4 &&
                      column >= 0 && column < 4;
    if (!fits) return {};
    elements.push_back({row, column});
  }
  return elements;
}

std::string index(const Element& element) {
  return "[" + std::to_string(element.row) + "][" + std::to_string(element.column) + "]";
}

std::string swizzle_function(std::string_view word) {
  return "penumbra_swizzle" + std::string(word);
}

// There is one overload for every shape of matrix that has all the elements. Integer matrices are rare, but
// conversion to a float matrix would lose precision: they have overloads, too.
std::string function_definitions(std::string_view word) {
  const std::vector<Element> elements = swizzle(word);
  int rows = 1;
  int columns = 1;
  for (const Element& element : elements) {
    rows = std::max(rows, element.row + 1);
    columns = std::max(columns, element.column + 1);
  }
  std::string text;
  for (const std::string type : {"float", "int", "uint"}) {
    for (int r = rows; r <= 4; ++r) {
      for (int c = columns; c <= 4; ++c) {
        const std::string vector = type + std::to_string(elements.size());
        text.append(vector).append(" ").append(swizzle_function(word)).append("(").append(type);
        text.append(std::to_string(r)).append("x").append(std::to_string(c));
        text.append(" m) { return ").append(vector).append("(");
        for (std::size_t i = 0; i < elements.size(); ++i)
          text.append(i == 0 ? "m" : ", m").append(index(elements[i]));
        text += "); }\n";
      }
    }
  }
  return text;
}

// Returns names of struct members, which look like swizzles where they are used.
std::unordered_set<std::string_view> member_names(const TokenText& text) {
  std::unordered_set<std::string_view> names;
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::structure) continue;
    for (std::size_t at = declaration.open; at < declaration.close; ++at)
      if (text.is_identifier(at)) names.insert(text.word(at));
  }
  return names;
}

class Swizzles {
 public:
  explicit Swizzles(TokenText& text) : text_(text) {}

  void run() {
    for (std::size_t dot = 1; dot + 1 < text_.size(); ++dot) {
      if (!text_.is(dot, ".") || !text_.is_identifier(dot + 1)) continue;
      const std::string_view word = text_.word(dot + 1);
      if (word[0] != '_' || swizzle(word).size() < 2 || is_member(word)) continue;
      const std::size_t begin = postfix_begin(text_, dot - 1);
      if (begin == npos) continue;
      if (assignment_length(text_, dot + 2) != 0) {
        assign(begin, dot);
      } else {
        read(begin, dot);
      }
    }
    std::string functions;
    for (const std::string_view word : read_) functions += function_definitions(word);
    text_.insert(0, functions);
    text_.apply();
  }

 private:
  bool is_member(std::string_view word) {
    if (!members_) members_ = member_names(text_);
    return members_->count(word) != 0;
  }

  void read(std::size_t begin, std::size_t dot) {
    const std::string_view word = text_.word(dot + 1);
    read_.insert(word);
    text_.insert(begin, swizzle_function(word) + "(");
    text_.replace(dot, 2, ")");
  }

  // Turns m._11_22 += v; into { float2 penumbra_right = (float2)(v); m[0][0] += penumbra_right[0]; ... }
  void assign(std::size_t begin, std::size_t dot) {
    const std::size_t operation = dot + 2;
    const std::size_t length = assignment_length(text_, operation);
    const std::size_t end = expression_end(text_, operation + length);
    if (end == npos || !text_.is(end, ";") || !begins_statement(text_, begin) ||
        !may_be_repeated(text_, begin, dot))
      return;
    const std::vector<Element> elements = swizzle(text_.word(dot + 1));
    const std::string matrix = text_.spelled(begin, dot - begin);
    const std::string type = "float" + std::to_string(elements.size());
    const std::string sign = text_.spelled(operation, length);
    text_.replace(begin, operation + length - begin, "{ " + type + " penumbra_right = (" + type + ")(");
    std::string rest = ");";
    for (std::size_t i = 0; i < elements.size(); ++i)
      rest.append(" ")
          .append(matrix)
          .append(index(elements[i]))
          .append(" ")
          .append(sign)
          .append(" penumbra_right[")
          .append(std::to_string(i))
          .append("];");
    text_.replace(end, 1, rest + " }");
  }

  TokenText& text_;
  std::optional<std::unordered_set<std::string_view>> members_;  // built on the first candidate
  std::set<std::string_view> read_;
};

}  // namespace

void write_out_matrix_swizzles(TokenText& text) {
  Swizzles(text).run();
}

}  // namespace penumbra::preparation
