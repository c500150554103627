#include <algorithm>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/passes.h"
#include "preparation/resource_types.h"
#include "preparation/value_types.h"
#include "preparation/written_values.h"

namespace penumbra::preparation {

namespace {

using Kind = hlsl::Declaration::Kind;

class ConstantUniforms {
 public:
  explicit ConstantUniforms(TokenText& text) : text_(text) {}

  void run() {
    for (const hlsl::Declaration& declaration : text_.declarations())
      if (declaration.kind == Kind::variable && text_.is(declaration.last, ";")) change(declaration);
    if (sizes_.empty()) return;
    write_sizes();
    text_.apply();
  }

 private:
  void change(const hlsl::Declaration& declaration) {
    const std::vector<Declarator> all = declarators(text_, declaration.type, declaration.last);
    const bool uniforms = !all.empty() && all[0].is_const && !all[0].is_static && !all[0].is_groupshared &&
                          is_number_type(all[0].type);
    if (!uniforms) return;
    for (std::size_t at = declaration.type; at < all[0].name; ++at)
      if (text_.is(at, "const")) text_.erase(at, 1);
    for (const Declarator& constant : all) {
      if (constant.initialiser == npos) continue;
      const std::string name = text_.name(constant.name);
      text_.warn(constant.name,
                 "'" + name +
                     "' is a uniform, because it is not static: Unity ignores its initialiser, and it is 0 " +
                     "unless something sets it; write 'static const' for a constant");
      sizes_[text_.types().named(constant.name)] =
          "(" + text_.spelled(constant.initialiser, constant.end - constant.initialiser) + ")";
      text_.erase(constant.initialiser - 1, constant.end - constant.initialiser + 1);
    }
  }

  // Writes the values in the array sizes after declared names.
  void write_sizes() {
    const ValueTypes& types = text_.types();
    for (const DeclaredValue& value : types.declared()) {
      if (value.name == npos || value.type.dimensions == 0) continue;
      for (std::size_t at = value.name + 1; at < value.end; ++at) {
        const auto size = text_.is_identifier(at) ? sizes_.find(types.named(at)) : sizes_.end();
        if (size != sizes_.end()) text_.replace(at, 1, size->second);
      }
    }
  }

  TokenText& text_;
  std::map<std::size_t, std::string> sizes_;  // the initialiser, by the index into types().declared()
};

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
      const std::string_view name = text_.word(declarator.name);
      uniform_words_[text_.identifier_number(declarator.name)] = true;
      uniforms_[name] = {std::move(declarator), insert_before};
    }
  }

  // Structs with resources have already been split.
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
      if (!text_.is_identifier(back) && !text_.is(back, ",") && !text_.is_number(back)) return false;
    }
    return false;
  }

  bool declares(std::size_t at) const {
    if (!text_.is_identifier(at - 1)) return ends_type(at - 1);
    return !text_.is_any(at - 1, "return", "else", "do");
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
      const std::string_view name = text_.word(at);
      if (text_.is_any(at - 1, ".", ":")) continue;
      if (declares(at)) blocks.back().insert(name);
      const bool own = std::any_of(blocks.begin(), blocks.end(),
                                   [&](const auto& names) { return names.count(name) != 0; });
      if (!own) use(at);
    }
  }

  void find_writes(const hlsl::Declaration& function) {
    for_each_use(function, [&](std::size_t at) {
      if (writes_.writes(at)) written_.insert(text_.word(at));
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
      if (written_.count(text_.word(at)) != 0) text_.replace(at, 1, copy_name(text_.word(at)));
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

// A declaration such as `const float k = 5;` at file scope, without static, is a uniform in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax, "extern"). Its
// initialiser is a default that Unity ignores, so it is 0 unless something sets it. glslang treats it as a
// constant. `const` and the initialiser are removed, with a warning; array sizes that use the constant get
// its value.
void make_constants_uniforms(TokenText& text) {
  ConstantUniforms(text).run();
}

// Static variables, textures, samplers and buffers that are declared in a cbuffer, the first as URP's
// DOTS_INSTANCED_PROP writes them. In HLSL they are not part of its layout. glslang makes them members of the
// block: a static one silently loses its value, and no Vulkan driver accepts the others. They are moved
// before the cbuffer, with their line; a cbuffer without other members is removed.
void move_out_of_cbuffers(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != Kind::buffer) continue;
    std::size_t first = declaration.open + 1;
    std::size_t staying = 0;
    for (std::size_t at = first; at < declaration.close; at = text.after(at)) {
      if (!text.is(at, ";")) continue;
      const std::size_t count = at + 1 - first;
      if (text.has(first, at, "static") || is_resource(text.word(first))) {
        text.insert_from(first, declaration.first, text.spelled(first, count));
        text.erase(first, count);
      } else {
        ++staying;
      }
      first = at + 1;
    }
    if (staying > 0 || first == declaration.open + 1) continue;
    text.erase(declaration.first, declaration.open - declaration.first + 1);
    text.erase(declaration.close, declaration.last - declaration.close + 1);
  }
  text.apply();
}

// Writes to uniforms: HLSL lets a shader assign to a global variable or a member of a cbuffer, which changes
// only this invocation's copy (docs "Variable Syntax": extern globals are initialised from outside). glslang
// rejects an assignment ("can't modify a uniform") and silently drops writes through out and inout
// parameters.
//
// Every numeric uniform or uniform struct of numbers that is assigned to, in whole or in part, incremented or
// decremented, or passed to an out parameter of a function of the text gets a static variable, initialised
// from it at the beginning of the shader, which replaces every use in a function.
void copy_written_uniforms(TokenText& text) {
  WrittenUniforms(text).run();
}

}  // namespace penumbra::preparation
