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

class UniformStructs {
 public:
  explicit UniformStructs(TokenText& text)
      : text_(text), types_(text.types()), carriers_(structs_with_resources(types_)) {}

  void run() {
    if (carriers_.empty()) return;
    for (const DeclaredValue& value : types_.declared())
      if (is_uniform_struct(value)) take_apart(value);
    for (std::size_t at = 0; at < text_.size(); ++at) replace_use(at);
    text_.apply();
  }

 private:
  struct Parts {
    std::string declarations;
    std::string assignments;
    int left = 4096;  // structs and members to go into: more, and something is wrong with the text
    int depth = 0;    // depth of the nested structs that are being read

    bool exceeded() const {
      constexpr std::size_t most_text = 1U << 20U;
      return left <= 0 || declarations.size() + assignments.size() > most_text;
    }
  };
  static constexpr int deepest = 32;  // a struct that contains itself has no depth

  bool is_uniform_struct(const DeclaredValue& value) const {
    return value.place == DeclaredValue::Place::global && !value.is_static && value.name != npos &&
           value.type_at != npos && carriers_.count(value.type.name) != 0;
  }

  void take_apart(const DeclaredValue& value) {
    Parts parts;
    const bool alone = value.type.dimensions == 0 && value.first != npos && text_.is(value.last, ";");
    if (alone) add_members(value.type.name, text_.name(value.name), "whole", parts);
    if (!alone || parts.exceeded()) {
      text_.error(
          value.name,
          "'" + text_.name(value.name) +
              (alone ? "' is a struct of resources with too many members, or too deeply nested"
                     : "' is one of several variables of a struct that holds resources; declare each alone, "
                       "and the resources of an array as arrays of their own"));
      return;
    }
    text_.replace(value.first, value.last - value.first + 1, parts.declarations);
    text_.insert(end_of_block(value) + 1, std::string(value.type.name) + " " + function_name(value.name) +
                                              "() { " + std::string(value.type.name) + " whole; " +
                                              parts.assignments + "return whole; } ");
  }

  // `name` is that of the new variable, and `whole` the chain it is assigned to.
  void add_members(std::string_view type, const std::string& name, const std::string& whole,
                   Parts& parts) const {
    const auto known = types_.structs().find(type);
    if (parts.exceeded() || known == types_.structs().end()) return;
    if (parts.depth >= deepest) {
      parts.left = 0;
      return;
    }
    --parts.left;
    ++parts.depth;
    add_members(known->second.base, name, whole, parts);
    for (const std::size_t index : known->second.members) {
      const DeclaredValue& member = types_.declared()[index];
      if (parts.exceeded()) break;
      --parts.left;
      if (member.type_at == npos) continue;
      std::string part = text_.free_name(std::string(name).append("_").append(text_.word(member.name)));
      std::string target = std::string(whole).append(".").append(text_.word(member.name));
      if (carriers_.count(member.type.name) != 0) {
        add_members(member.type.name, part, target, parts);
        continue;
      }
      parts.declarations.append(text_.spelled(member.type_at, member.type_end - member.type_at)).append(" ");
      parts.declarations.append(part)
          .append(text_.spelled(member.name + 1, member.end - member.name - 1))
          .append("; ");
      parts.assignments.append(target).append(" = ").append(part).append("; ");
    }
    --parts.depth;
  }

  std::string function_name(std::size_t of) const { return text_.free_name(text_.name(of) + "_whole"); }

  // The end is that of the cbuffer it is a member of, else its own.
  std::size_t end_of_block(const DeclaredValue& value) const {
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::buffer && declaration.open < value.name &&
          value.name < declaration.close)
        return declaration.last;
    return value.last;
  }

  // In `s.map`, the part of that name is used; any other `s` is the whole.
  void replace_use(std::size_t at) {
    const std::size_t index = text_.is_identifier(at) ? types_.named(at) : npos;
    if (index == npos || !is_uniform_struct(types_.declared()[index])) return;
    if (types_.declared()[index].name == at) return;
    std::string part = text_.name(at);
    for (std::size_t member = at + 2; text_.is(member - 1, ".") && text_.is_identifier(member); member += 2) {
      const std::size_t named = types_.named(member);
      if (named == npos) break;
      part = text_.free_name(part.append("_").append(text_.word(member)));
      if (carriers_.count(types_.declared()[named].type.name) != 0) continue;
      text_.replace(at, member - at + 1, part);
      return;
    }
    text_.replace(at, 1, function_name(at) + "()");
  }

  TokenText& text_;
  const ValueTypes& types_;
  const std::set<std::string_view> carriers_;
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

// Global variables and members of cbuffers whose struct contains textures, samplers or buffers as well as
// numbers. glslang splits them and makes the numbers constants outside of any block, which is invalid SPIR-V.
//
// `Surface s;` becomes one declaration per member, `Texture2D s_map; float4 s_tint;`, in its place, followed
// by a function that assembles a Surface from them; reads of `s` call that function.
//
// Limits: in a cbuffer the members are not aligned to sixteen bytes as the struct is, and reflection lists
// them with their new names. Arrays of such structs are an error.
void take_apart_uniform_structs(TokenText& text) {
  UniformStructs(text).run();
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
