#include "preparation/method_bodies.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preparation/declarators.h"
#include "preparation/declared_values.h"

namespace penumbra::preparation {

namespace {

struct Prototype {
  std::size_t name = npos;
  std::size_t semicolon = npos;
  std::string signature;  // its name and the types of its parameters
};

class MethodBodies {
 public:
  explicit MethodBodies(TokenText& text) : text_(text) {}

  void run() {
    for (const hlsl::Declaration& declaration : text_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::function)
        note_definition(declaration);
      else if (declaration.kind == hlsl::Declaration::Kind::variable && declaration.name != npos)
        variables_.emplace(declaration.scope + std::string(text_[declaration.name].spelling), &declaration);
    for (const hlsl::Declaration& declaration : text_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::structure && declaration.open != npos &&
          declaration.name != npos && !text_.is(declaration.type, "interface"))
        fill(declaration);
    text_.apply();
  }

 private:
  using Key = std::pair<std::string_view, std::string>;  // struct, signature

  std::string signature(std::size_t name) const {
    hlsl::Declaration function;
    function.name = name;
    function.parameters_open = name + 1;
    function.parameters_close = text_.matching_bracket(name + 1);
    std::string text(text_[name].spelling);
    for (const std::string& type : hlsl::parameter_types(text_.tokens(), function)) text += ", " + type;
    return text;
  }

  // Records `S::f(...) {`.
  void note_definition(const hlsl::Declaration& function) {
    const std::size_t name = function.name;
    if (name < 3 || !text_.is(name - 1, ":") || !text_.is(name - 2, ":") || !text_.is_identifier(name - 3))
      return;
    definitions_[{text_[name - 3].spelling, signature(name)}].push_back(&function);
  }

  void fill(const hlsl::Declaration& structure) {
    std::vector<Prototype> prototypes;
    std::set<std::string> bodies;  // bodies in the struct itself, by signature
    for (std::size_t at = structure.open + 1; at < structure.close; at = after_brackets(text_, at)) {
      if (!text_.is(at, "(") || !text_.is_identifier(at - 1) || text_.matching_bracket(at) == npos) continue;
      std::size_t end = text_.matching_bracket(at) + 1;
      while (end < structure.close && !text_.is(end, ";") && !text_.is(end, "{")) ++end;
      if (text_.is(end, "{")) bodies.insert(signature(at - 1));
      if (text_.is(end, ";")) prototypes.push_back({at - 1, end, signature(at - 1)});
    }
    for (const Prototype& prototype : prototypes) fill(structure, prototype, bodies);
  }

  void fill(const hlsl::Declaration& structure, const Prototype& prototype,
            const std::set<std::string>& bodies) {
    const std::string_view name = text_[prototype.name].spelling;
    if (bodies.contains(prototype.signature)) return drop(structure, prototype);
    const auto found = definitions_.find({text_[structure.name].spelling, prototype.signature});
    if (found == definitions_.end() || found->second.size() != 1) {
      if (is_called(prototype.name))
        text_.note(prototype.name, hlsl::Severity::error,
                   "'" + std::string(name) + "' of '" + std::string(text_[structure.name].spelling) +
                       "' has no body: write it into the struct");
      return drop(structure, prototype);
    }
    const hlsl::Declaration& definition = *found->second.front();
    for (std::size_t at = definition.open; at < definition.close; ++at)
      if (text_.is_identifier(at)) bring(structure, at);
    text_.erase(prototype.name, prototype.semicolon + 1 - prototype.name);
    move(definition.name, definition.last + 1, prototype.name);
    text_.erase(definition.first, definition.last + 1 - definition.first);
    found->second.push_back(nullptr);  // used
  }

  // Moves the numeric variable that this identifier names, if it is declared after the struct.
  void bring(const hlsl::Declaration& structure, std::size_t word) {
    const auto known = variables_.find(structure.scope + std::string(text_[word].spelling));
    if (known == variables_.end() || known->second->first < structure.close) return;
    const hlsl::Declaration& variable = *known->second;
    for (std::size_t at = variable.first; at < variable.name; ++at)
      if (!is_modifier(text_[at].spelling) && !is_number_type(text_[at].spelling)) return;
    move(variable.first, variable.last + 1, structure.first);
    text_.erase(variable.first, variable.last + 1 - variable.first);
    variables_.erase(known);
  }

  // HLSL accepts a prototype that nothing calls.
  bool is_called(std::size_t prototype) const {
    for (std::size_t at = 0; at + 1 < text_.size(); ++at)
      if (at != prototype && text_.is(at + 1, "(") && text_.is(at, text_[prototype].spelling)) return true;
    return false;
  }

  void drop(const hlsl::Declaration& structure, const Prototype& prototype) {
    std::size_t first = prototype.name;
    while (first > structure.open + 1 && !text_.is(first - 1, ";") && !text_.is(first - 1, "}")) --first;
    text_.erase(first, prototype.semicolon + 1 - first);
  }

  // The text moves line by line, so that each line keeps its location.
  void move(std::size_t first, std::size_t end, std::size_t to) {
    for (std::size_t line = first; line < end;) {
      std::size_t next = line + 1;
      while (next < end && text_[next].line == text_[line].line && text_[next].file == text_[line].file)
        ++next;
      text_.insert_from(line, to, text_.spelled(line, next - line));
      line = next;
    }
  }

  TokenText& text_;
  std::map<Key, std::vector<const hlsl::Declaration*>> definitions_;
  std::map<std::string, const hlsl::Declaration*> variables_;  // variables by scope and name
};

}  // namespace

void put_bodies_into_structs(TokenText& text) {
  MethodBodies(text).run();
}

}  // namespace penumbra::preparation
