#include "preparation/constant_uniforms.h"

#include <map>
#include <string>
#include <vector>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/value_types.h"

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
      const std::string name(text_[constant.name].spelling);
      text_.note(constant.name, hlsl::Severity::warning,
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

}  // namespace

void make_constants_uniforms(TokenText& text) {
  ConstantUniforms(text).run();
}

}  // namespace penumbra::preparation
