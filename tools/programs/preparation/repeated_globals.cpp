#include <map>
#include <string>
#include <utility>
#include <vector>

#include "preparation/declared_values.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class RepeatedGlobals {
 public:
  explicit RepeatedGlobals(TokenText& text) : text_(text) {}

  void run() {
    using Kind = hlsl::Declaration::Kind;
    for (const hlsl::Declaration& declaration : text_.declarations()) {
      if (declaration.kind == Kind::variable)
        read(declaration.type, declaration.last + 1, declaration.scope);
      else if (declaration.kind == Kind::buffer)
        for (std::size_t at = declaration.open + 1; at < declaration.close;)
          at = read(at, declaration.close, declaration.scope);
    }
    for (const auto& [name, type] : text_.types().structs()) {
      names_.clear();
      for (const std::size_t member : type.members) enter(text_.types().declared()[member].name, {});
    }
    text_.apply();
  }

 private:
  // Returns one past the declaration that begins at `first`.
  std::size_t read(std::size_t first, std::size_t end, const std::string& scope) {
    values_.clear();
    const std::size_t next = read_declaration(text_, {first, end, DeclaredValue::Place::global}, values_);
    bool is_extern = false;
    for (std::size_t at = first; at < next && text_.is_identifier(at) && is_modifier(text_[at].spelling);
         ++at)
      is_extern = is_extern || text_.is(at, "extern");
    for (const DeclaredValue& value : values_)
      if (!is_extern) enter(value.name, scope);
    return next;
  }

  void enter(std::size_t name, const std::string& scope) {
    if (name == npos) return;
    const std::string spelling(text_[name].spelling);
    const auto [known, is_new] = names_.emplace(scope + spelling, name);
    if (is_new) return;
    text_.note(name, hlsl::Severity::error,
               "'" + spelling + "' is already declared, at " + text_.file_of(known->second) + ":" +
                   std::to_string(text_[known->second].line) + ": remove one of the two");
    // glslang crashes on two types, so that each declaration gets a name of its own.
    text_.replace(name, 1, text_.free_name(spelling + "_" + std::to_string(name)));
  }

  TokenText& text_;
  std::map<std::string, std::size_t> names_;
  std::vector<DeclaredValue> values_;
};

}  // namespace

void check_repeated_globals(TokenText& text) {
  RepeatedGlobals(text).run();
}

}  // namespace penumbra::preparation
