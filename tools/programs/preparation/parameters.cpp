#include <map>
#include <utility>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/passes.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using Kind = hlsl::Declaration::Kind;

class Prototypes {
 public:
  explicit Prototypes(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == Kind::prototype) prototypes_.push_back(&declaration);
    if (prototypes_.empty()) return;
    for (const hlsl::Declaration& declaration : types_.declarations())
      if (declaration.kind == Kind::function) definitions_.emplace(signature(declaration), &declaration);
    for (const FunctionType& function : types_.functions()) parameters_[function.name] = &function;
    for (const hlsl::Declaration* prototype : prototypes_) match(*prototype);
    text_.apply();
  }

 private:
  using Signature = std::pair<std::string, std::vector<std::string>>;

  Signature signature(const hlsl::Declaration& function) const {
    return {function.scope + text_.name(function.name), hlsl::parameter_types(text_.tokens(), function)};
  }

  void match(const hlsl::Declaration& prototype) {
    const auto definition = definitions_.find(signature(prototype));
    if (definition == definitions_.end()) return;
    if (is_needed(prototype, *definition->second)) {
      copy_const(*parameters_.at(definition->second->name), *parameters_.at(prototype.name));
    } else {
      text_.erase(prototype.first, prototype.last - prototype.first + 1);
    }
  }

  bool is_needed(const hlsl::Declaration& prototype, const hlsl::Declaration& definition) const {
    const std::uint32_t name = text_.identifier_number(prototype.name);
    for (std::size_t at = prototype.last; at < definition.first; ++at)
      if (text_.identifier_number(at) == name && text_.is(at + 1, "(") && !is_declared_at(at)) return true;
    return false;
  }

  bool is_declared_at(std::size_t name) const { return parameters_.count(name) != 0; }

  void copy_const(const FunctionType& from, const FunctionType& to) {
    for (std::size_t i = 0; i < from.parameters.size() && i < to.parameters.size(); ++i) {
      const DeclaredValue& wanted = types_.declared()[from.parameters[i]];
      const DeclaredValue& parameter = types_.declared()[to.parameters[i]];
      if (wanted.type.constant == parameter.type.constant || parameter.type_at == npos) continue;
      if (wanted.type.constant) text_.insert(parameter.type_at, "const ");
      for (std::size_t at = parameter.first; at < parameter.type_at; ++at)
        if (text_.is(at, "const")) text_.erase(at, 1);
    }
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::vector<const hlsl::Declaration*> prototypes_;
  std::map<Signature, const hlsl::Declaration*> definitions_;
  std::map<std::size_t, const FunctionType*> parameters_;  // by the function's name
};

}  // namespace

// Prototypes that glslang misreads. It treats a parameter's `const` as part of how it is passed: if prototype
// and definition differ in it, a call emits invalid SPIR-V or crashes. And it treats a prototype of the entry
// point as a different function, without a body.
//
// A prototype is removed if nothing between it and the definition calls the function; in the others, each
// parameter is const where it is in the definition.
void match_prototypes(TokenText& text) {
  Prototypes(text).run();
}

}  // namespace penumbra::preparation
