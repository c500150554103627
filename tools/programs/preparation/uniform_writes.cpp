#include "preparation/uniform_writes.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/value_types.h"
#include "preparation/written_values.h"

namespace penumbra::preparation {

namespace {

using Kind = hlsl::Declaration::Kind;

struct Uniform {
  Declarator declarator;
  std::size_t insert_before = 0;  // the token after the declaration it stands in
};

class WrittenUniforms {
 public:
  explicit WrittenUniforms(TokenText& text)
      : text_(text),
        types_(text.types()),
        declarations_(text.declarations()),
        writes_(text),
        uniform_words_(text.identifier_count(), false) {}

  void run() {
    find_uniforms();
    for (const hlsl::Declaration& declaration : declarations_)
      if (declaration.kind == Kind::function) find_writes(declaration);
    if (written_.empty()) return;
    for (const std::string_view name : written_) declare_copy(name, uniforms_.at(name));
    for (const hlsl::Declaration& declaration : declarations_)
      if (declaration.kind == Kind::function) use_copies(declaration);
    text_.apply();
  }

 private:
  void add_uniforms(std::size_t first, std::size_t last, std::size_t insert_before) {
    for (Declarator& declarator : declarators(text_, first, last)) {
      const bool uniform = !declarator.is_static && !declarator.is_groupshared && !declarator.is_const;
      if (!uniform || !(is_number_type(declarator.type) || is_struct(declarator.type))) continue;
      const std::string_view name = text_[declarator.name].spelling;
      uniform_words_[text_.identifier_number(declarator.name)] = true;
      uniforms_[name] = {std::move(declarator), insert_before};
    }
  }

  // Structs with resources have already been split (uniform_structs.h).
  bool is_struct(const std::string& type) const { return types_.structs().count(type) != 0; }

  void find_uniforms() {
    for (const hlsl::Declaration& declaration : declarations_) {
      if (declaration.kind == Kind::variable && text_.is(declaration.last, ";"))
        add_uniforms(declaration.type, declaration.last, declaration.last + 1);
      if (declaration.kind != Kind::buffer) continue;
      std::size_t first = declaration.open + 1;
      for (std::size_t at = first; at < declaration.close; ++at) {
        if (!text_.is(at, ";")) continue;
        add_uniforms(first, at, declaration.last + 1);
        first = at + 1;
      }
    }
  }

  // Returns whether the '>' at this token ends a type: `vector<float, 3> a`.
  bool ends_type(std::size_t at) const {
    if (!text_.is(at, ">")) return false;
    for (std::size_t back = at; back-- > 0 && at - back < 6;) {
      if (text_.is(back, "<")) return back > 0 && text_.is_identifier(back - 1);
      if (!text_.is_identifier(back) && !text_.is(back, ",") && text_[back].kind != hlsl::Token::Kind::number)
        return false;
    }
    return false;
  }

  bool declares(std::size_t at) const {
    if (!text_.is_identifier(at - 1)) return ends_type(at - 1);
    return !text_.is(at - 1, "return") && !text_.is(at - 1, "else") && !text_.is(at - 1, "do");
  }

  // Calls `use(token)` for every name in the function that refers to a uniform: not to a member, parameter or
  // local variable of the same name in an enclosing block.
  template <typename Use>
  void for_each_use(const hlsl::Declaration& function, Use use) const {
    std::vector<std::set<std::string_view>> blocks(1);
    for (std::size_t at = function.parameters_open + 1; at < function.close; ++at) {
      if (text_.is(at, "{")) blocks.emplace_back();
      if (text_.is(at, "}") && blocks.size() > 1) blocks.pop_back();
      if (!text_.is_identifier(at) || !uniform_words_[text_.identifier_number(at)]) continue;
      const std::string_view name = text_[at].spelling;
      if (text_.is(at - 1, ".") || text_.is(at - 1, ":")) continue;
      if (declares(at)) blocks.back().insert(name);
      const bool own = std::any_of(blocks.begin(), blocks.end(),
                                   [&](const auto& names) { return names.count(name) != 0; });
      if (!own) use(at);
    }
  }

  void find_writes(const hlsl::Declaration& function) {
    for_each_use(function, [&](std::size_t at) {
      if (writes_.writes(at)) written_.insert(text_[at].spelling);
    });
  }

  static std::string copy_name(std::string_view name) { return "penumbra_copy_" + std::string(name); }

  void declare_copy(std::string_view name, const Uniform& uniform) {
    const Declarator& declarator = uniform.declarator;
    text_.insert(uniform.insert_before, "static " + declarator.type + " " + copy_name(name) +
                                            text_.spelled(declarator.dimensions, declarator.dimension_count) +
                                            " = " + std::string(name) + ";");
  }

  void use_copies(const hlsl::Declaration& function) {
    for_each_use(function, [&](std::size_t at) {
      if (written_.count(text_[at].spelling) != 0) text_.replace(at, 1, copy_name(text_[at].spelling));
    });
  }

  TokenText& text_;
  const ValueTypes& types_;
  const std::vector<hlsl::Declaration>& declarations_;
  WrittenValues writes_;
  std::vector<bool> uniform_words_;  // for each identifier number: a uniform has that name
  std::unordered_map<std::string_view, Uniform> uniforms_;
  std::set<std::string_view> written_;
};

}  // namespace

void copy_written_uniforms(TokenText& text) {
  WrittenUniforms(text).run();
}

}  // namespace penumbra::preparation
