#include "preparation/static_initialisers.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/outline.h"
#include "preparation/declarators.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class StaticInitialisers {
 public:
  explicit StaticInitialisers(TokenText& text)
      : text_(text), types_(text.types()), functions_(text.word_numbers(), false) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos && text_.is_word(function.name))
        functions_[text_.word_number(function.name)] = true;
  }

  void run() {
    for (const hlsl::Declaration& declaration : types_.outline())
      if (declaration.kind == hlsl::Declaration::Kind::variable) move(declaration);
    if (moved_.empty()) return;
    for (const FunctionType& function : types_.functions()) {
      if (function.body == npos) continue;
      const std::string read = locals(function.body, text_.partner(function.body));
      if (!read.empty()) text_.insert(function.body + 1, read);
    }
    text_.apply();
  }

 private:
  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  void move(const hlsl::Declaration& declaration) {
    const std::vector<Declarator> all = declarators(text_, declaration.type, declaration.last);
    if (all.size() != 1 || !all[0].is_static || !all[0].is_const || all[0].initialiser == npos) return;
    const Declarator& constant = all[0];
    const std::size_t index = types_.named(constant.name);
    if (index == npos || !must_move(constant) || !sizes_are_written(constant)) return;
    const std::string name(word(constant.name));
    const std::string sizes = text_.spelled(constant.dimensions, constant.dimension_count);
    const std::string function = text_.free_name("set_" + name);
    const std::string to = text_.free_name("to_" + name);
    const std::string declared = constant.type + " ";
    moved_[index] = declared + name + sizes + "; " + function + "(" + name + "); ";
    const std::string before = locals(constant.initialiser, constant.end);
    text_.replace(
        declaration.first, constant.name - declaration.first,
        "void " + function + "(out " + declared + to + sizes + ") { " + before + "const " + declared);
    text_.insert(declaration.last + 1, to + " = " + name + "; }");
  }

  // It calls a function of the text, or reads what is moved.
  bool must_move(const Declarator& constant) const {
    for (std::size_t at = constant.initialiser; at < constant.end; ++at) {
      if (!text_.is_word(at)) continue;
      if (text_.is(at + 1, "(") && functions_[text_.word_number(at)]) return true;
      if (moved_.count(types_.named(at)) != 0) return true;
    }
    return false;
  }

  bool sizes_are_written(const Declarator& constant) const {
    for (std::size_t i = 0; i < constant.dimension_count; ++i)
      if (text_.is(constant.dimensions + i, "[") && text_.is(constant.dimensions + i + 1, "]")) return false;
    return true;
  }

  // The moved constants that the tokens read, as locals, in the order of the text.
  std::string locals(std::size_t first, std::size_t end) const {
    std::set<std::size_t> read;
    for (std::size_t at = first; at < end && at < text_.size(); ++at)
      if (text_.is_word(at) && moved_.count(types_.named(at)) != 0) read.insert(types_.named(at));
    std::string all;
    for (const std::size_t index : read) all += moved_.at(index);
    return all;
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<bool> functions_;  // by a word's number: whether a function has that name
  // `float weights[2]; set_weights(weights);` by the constant's index into types_.declared().
  std::map<std::size_t, std::string> moved_;
};

}  // namespace

void work_out_static_initialisers(TokenText& text) {
  StaticInitialisers(text).run();
}

}  // namespace penumbra::preparation
