// Static constants whose initialiser calls a function of the text: `static const float weights[2] = {
// Gauss(0), Gauss(1) };`. glslang attributes the call to whatever function precedes it: it then reports
// recursion, or drops the callee as unused and crashes. The value is computed in a generated function, and
// every function that reads the constant begins with a local constant of that name and value.
//
// Constants only, because their value is the same everywhere; arrays need explicit sizes. A function with a
// parameter of the same name does not read the constant.

#include "preparation/passes.h"

#include <optional>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/value_types.h"
#include "preparation/written_values.h"

namespace penumbra::preparation {

namespace {

class StaticInitialisers {
 public:
  explicit StaticInitialisers(TokenText& text)
      : text_(text), types_(text.types()), functions_(text.identifier_count(), false) {
    for (const FunctionType& function : types_.functions())
      if (function.name != npos && text_.is_identifier(function.name))
        functions_[text_.identifier_number(function.name)] = true;
  }

  void run() {
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::variable) move(declaration);
    if (moved_.empty()) return;
    for (const FunctionType& function : types_.functions()) {
      if (function.body == npos) continue;
      const std::string read = locals(function.body, text_.matching_bracket(function.body));
      if (!read.empty()) text_.insert(function.body + 1, read);
    }
    text_.apply();
  }

 private:
  void move(const hlsl::Declaration& declaration) {
    const std::vector<Declarator> all = declarators(text_, declaration.type, declaration.last);
    if (all.size() != 1 || !all[0].is_static || !all[0].is_const || all[0].initialiser == npos) return;
    const Declarator& constant = all[0];
    const std::size_t index = types_.named(constant.name);
    if (index == npos || !must_move(constant) || !sizes_are_written(constant)) return;
    refuse_if_written_later(constant);
    const std::string name = text_.name(constant.name);
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

  // The value is computed again in every function, which is equivalent only if its operands do not change.
  void refuse_if_written_later(const Declarator& constant) {
    std::set<std::string_view> functions;
    const std::size_t written = written_in(constant.initialiser, constant.end, functions);
    if (written == npos) return;
    text_.error(constant.name, "not supported here: '" + text_.name(constant.name) +
                                   "' is initialised from '" + text_.name(written) +
                                   "', which the shader writes to; initialise a local variable from it");
  }

  // Returns the first use in the tokens, or in the functions they call, of a variable at file scope that is
  // written to.
  std::size_t written_in(std::size_t first, std::size_t end, std::set<std::string_view>& functions) {
    for (std::size_t at = first; at < end; ++at) {
      if (!text_.is_identifier(at)) continue;
      if (types_.named(at) != npos && written_globals().count(types_.named(at)) != 0) return at;
      if (!text_.is(at + 1, "(") || !functions_[text_.identifier_number(at)] ||
          !functions.insert(text_.word(at)).second)
        continue;
      for (const FunctionType& function : types_.functions()) {
        if (function.body == npos || text_.word(function.name) != text_.word(at)) continue;
        const std::size_t found = written_in(function.body, text_.matching_bracket(function.body), functions);
        if (found != npos) return found;
      }
    }
    return npos;
  }

  const std::set<std::size_t>& written_globals() {
    if (written_) return *written_;
    written_.emplace();
    const WrittenValues writes(text_);
    for (const FunctionType& function : types_.functions()) {
      if (function.body == npos) continue;
      for (std::size_t at = function.body; at < text_.matching_bracket(function.body); ++at) {
        const std::size_t named = text_.is_identifier(at) && !text_.is(at - 1, ".") ? types_.named(at) : npos;
        if (named != npos && types_.declared()[named].place == DeclaredValue::Place::global &&
            writes.writes(at))
          written_->insert(named);
      }
    }
    return *written_;
  }

  // A constant must move if it calls a function of the text, or reads a constant that is moved.
  bool must_move(const Declarator& constant) const {
    for (std::size_t at = constant.initialiser; at < constant.end; ++at) {
      if (!text_.is_identifier(at)) continue;
      if (text_.is(at + 1, "(") && functions_[text_.identifier_number(at)]) return true;
      if (moved_.count(types_.named(at)) != 0) return true;
    }
    return false;
  }

  bool sizes_are_written(const Declarator& constant) const {
    for (std::size_t i = 0; i < constant.dimension_count; ++i)
      if (text_.is(constant.dimensions + i, "[") && text_.is(constant.dimensions + i + 1, "]")) return false;
    return true;
  }

  // Returns the moved constants that the tokens read, as locals, in the order of the text.
  std::string locals(std::size_t first, std::size_t end) const {
    std::set<std::size_t> read;
    for (std::size_t at = first; at < end && at < text_.size(); ++at)
      if (text_.is_identifier(at) && moved_.count(types_.named(at)) != 0) read.insert(types_.named(at));
    std::string all;
    for (const std::size_t index : read) all += moved_.at(index);
    return all;
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<bool> functions_;                   // for each identifier number: a function has that name
  std::optional<std::set<std::size_t>> written_;  // variables at file scope, indices into types_.declared()
  // The statements `float weights[2]; set_weights(weights);` by the constant's index into types_.declared().
  std::map<std::size_t, std::string> moved_;
};

}  // namespace

void work_out_static_initialisers(TokenText& text) {
  StaticInitialisers(text).run();
}

}  // namespace penumbra::preparation
