#include "preparation/uniform_structs.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "preparation/resource_types.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

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

  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  bool is_uniform_struct(const DeclaredValue& value) const {
    return value.place == DeclaredValue::Place::global && !value.is_static && value.name != npos &&
           value.type_at != npos && carriers_.count(value.type.name) != 0;
  }

  void take_apart(const DeclaredValue& value) {
    Parts parts;
    const bool alone = value.type.dimensions == 0 && value.first != npos && text_.is(value.last, ";");
    if (alone) add_members(value.type.name, std::string(word(value.name)), "whole", parts);
    if (!alone || parts.exceeded()) {
      text_.note(
          value.name, hlsl::Severity::error,
          "'" + std::string(word(value.name)) +
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
      std::string part = text_.free_name(std::string(name).append("_").append(word(member.name)));
      std::string target = std::string(whole).append(".").append(word(member.name));
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

  std::string function_name(std::size_t of) const {
    return text_.free_name(std::string(word(of)) + "_whole");
  }

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
    std::string part(word(at));
    for (std::size_t member = at + 2; text_.is(member - 1, ".") && text_.is_identifier(member); member += 2) {
      const std::size_t named = types_.named(member);
      if (named == npos) break;
      part = text_.free_name(part.append("_").append(word(member)));
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

}  // namespace

void take_apart_uniform_structs(TokenText& text) {
  UniformStructs(text).run();
}

}  // namespace penumbra::preparation
