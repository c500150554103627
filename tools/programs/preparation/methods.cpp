#include <map>
#include <set>
#include <utility>

#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/declared_values.h"
#include "preparation/passes.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns whether the name at this token is called, and neither declared nor a member of something else.
bool is_bare_call(const TokenText& text, std::size_t at) {
  static constexpr hlsl::NameSet statements("return", "else", "do", "case");
  if (!text.is(at + 1, "(") || text.is_any(at - 1, ".", ":")) return false;
  return !text.is_identifier(at - 1) || statements.contains(text.word(at - 1));
}

bool is_static(const TokenText& text, const hlsl::Declaration& function) {
  return text.has(function.first, function.name, "static");
}

using Place = DeclaredValue::Place;

enum class Receiver { variable, value, writable };  // a variable: glslang handles the call correctly

class MemberCalls {
 public:
  explicit MemberCalls(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t dot = 1; dot + 2 < text_.size(); ++dot)
      if (text_.is(dot, ".") && text_.is_identifier(dot + 1) && text_.is(dot + 2, "(")) call(dot);
    for (const auto& [type, receiver] : needed_) define(type, receiver);
    text_.apply();
  }

 private:
  void call(std::size_t dot) {
    const ValueType& type = types_.at(dot - 1);
    const std::size_t first = types_.begin(dot - 1);
    const auto known = types_.structs().find(type.name);
    if (first == npos || type.dimensions > 0 || known == types_.structs().end()) return;
    const auto& functions = known->second.functions;
    const bool is_member =
        std::any_of(functions.begin(), functions.end(), [&](const hlsl::Declaration& function) {
          return text_.word(function.name) == text_.word(dot + 1) && can_be_forwarded(function);
        });
    const Receiver receiver = receiver_of(first, dot - 1);
    if (!is_member || receiver == Receiver::variable) return;
    needed_.emplace(type.name, receiver);
    text_.insert(first, function_name(type.name, text_.word(dot + 1), receiver) + "(");
    const bool has_arguments = text_.matching_bracket(dot + 2) != dot + 3;
    text_.replace(dot, 3, has_arguments ? "," : "");
  }

  // Constants and results of calls are passed by value; otherwise the chain's first name decides.
  Receiver receiver_of(std::size_t first, std::size_t last) const {
    if (types_.at(last).constant) return Receiver::value;
    for (std::size_t at = last; at > first; --at) {
      if (text_.is(at, ")") && text_.matching_bracket(at) > first) return Receiver::value;
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) < at)
        at = text_.matching_bracket(at);
    }
    while (text_.is(first, "(")) ++first;
    const std::size_t index = types_.named(first);
    if (index == npos) return text_.is(first, "this") ? Receiver::variable : Receiver::value;
    const DeclaredValue& value = types_.declared()[index];
    if (value.type.constant) return Receiver::value;
    if (value.place != Place::global && !value.is_static) return Receiver::variable;
    const bool writable = value.is_static || value.type.name == "RWStructuredBuffer" || value.is_groupshared;
    return writable ? Receiver::writable : Receiver::value;
  }

  std::string function_name(std::string_view type, std::string_view member, Receiver receiver) const {
    std::string name = std::string(type) + "_" + std::string(member) +
                       (receiver == Receiver::value ? "_of_value" : "_of_variable");
    return text_.free_name(std::move(name));
  }

  const FunctionType* parameters_of(const hlsl::Declaration& function) const {
    const auto& all = types_.functions();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const FunctionType& known) { return known.name == function.name; });
    return found == all.end() ? nullptr : &*found;
  }

  bool can_be_forwarded(const hlsl::Declaration& function) const {
    const FunctionType* type = parameters_of(function);
    return type != nullptr &&
           std::all_of(type->parameters.begin(), type->parameters.end(),
                       [&](std::size_t index) { return types_.declared()[index].name != npos; });
  }

  // Defines functions for all member functions: the compiler resolves overloads.
  void define(std::string_view type, Receiver receiver) {
    const StructType& known = types_.structs().find(type)->second;
    std::string functions;
    for (const hlsl::Declaration& function : known.functions)
      if (can_be_forwarded(function)) functions += definition(type, function, receiver);
    text_.insert(types_.declarations()[known.declaration].last + 1, functions);
  }

  std::string definition(std::string_view type, const hlsl::Declaration& function, Receiver receiver) const {
    std::size_t returned = function.type;
    while (text_.is_any(returned, "static", "inline")) ++returned;
    const std::string self = text_.free_name("receiver");
    std::string arguments;
    for (const std::size_t index : parameters_of(function)->parameters)
      arguments += (arguments.empty() ? "" : ", ") + text_.name(types_.declared()[index].name);
    const std::size_t first = function.parameters_open + 1;
    std::string parameters = text_.spelled(first, function.parameters_close - first);
    if (arguments.empty()) parameters.clear();  // (void)
    std::string text = text_.spelled(returned, function.name - returned) + " " +
                       function_name(type, text_.word(function.name), receiver);
    text.append("(")
        .append(receiver == Receiver::writable ? "inout " : "")
        .append(type)
        .append(" ")
        .append(self);
    text.append(parameters.empty() ? "" : ", ").append(parameters).append(") { ");
    text.append(text_.is(returned, "void") ? "" : "return ").append(self).append(".");
    return text.append(text_.word(function.name)).append("(").append(arguments).append("); } ");
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::set<std::pair<std::string_view, Receiver>> needed_;
};

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
        variables_.emplace(declaration.scope + text_.name(declaration.name), &declaration);
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
    std::string text = text_.name(name);
    for (const std::string& type : hlsl::parameter_types(text_.tokens(), function)) text += ", " + type;
    return text;
  }

  // Records `S::f(...) {`.
  void note_definition(const hlsl::Declaration& function) {
    const std::size_t name = function.name;
    if (name < 3 || !text_.is(name - 1, ":") || !text_.is(name - 2, ":") || !text_.is_identifier(name - 3))
      return;
    definitions_[{text_.word(name - 3), signature(name)}].push_back(&function);
  }

  void fill(const hlsl::Declaration& structure) {
    std::vector<Prototype> prototypes;
    std::set<std::string> bodies;  // bodies in the struct itself, by signature
    for (std::size_t at = structure.open + 1; at < structure.close; at = text_.after(at)) {
      if (!text_.is(at, "(") || !text_.is_identifier(at - 1) || text_.matching_bracket(at) == npos) continue;
      std::size_t end = text_.matching_bracket(at) + 1;
      while (end < structure.close && !text_.is_any(end, ";", "{")) ++end;
      if (text_.is(end, "{")) bodies.insert(signature(at - 1));
      if (text_.is(end, ";")) prototypes.push_back({at - 1, end, signature(at - 1)});
    }
    for (const Prototype& prototype : prototypes) fill(structure, prototype, bodies);
  }

  void fill(const hlsl::Declaration& structure, const Prototype& prototype,
            const std::set<std::string>& bodies) {
    const std::string_view name = text_.word(prototype.name);
    if (bodies.contains(prototype.signature)) return drop(structure, prototype);
    const auto found = definitions_.find({text_.word(structure.name), prototype.signature});
    if (found == definitions_.end() || found->second.size() != 1) {
      if (is_called(prototype.name))
        text_.error(prototype.name, "'" + std::string(name) + "' of '" + text_.name(structure.name) +
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
    const auto known = variables_.find(structure.scope + text_.name(word));
    if (known == variables_.end() || known->second->first < structure.close) return;
    const hlsl::Declaration& variable = *known->second;
    for (std::size_t at = variable.first; at < variable.name; ++at)
      if (!is_modifier(text_.word(at)) && !is_number_type(text_.word(at))) return;
    move(variable.first, variable.last + 1, structure.first);
    text_.erase(variable.first, variable.last + 1 - variable.first);
    variables_.erase(known);
  }

  // HLSL accepts a prototype that nothing calls.
  bool is_called(std::size_t prototype) const {
    for (std::size_t at = 0; at + 1 < text_.size(); ++at)
      if (at != prototype && text_.is(at + 1, "(") && text_.is(at, text_.word(prototype))) return true;
    return false;
  }

  void drop(const hlsl::Declaration& structure, const Prototype& prototype) {
    std::size_t first = prototype.name;
    while (first > structure.open + 1 && !text_.is_any(first - 1, ";", "}")) --first;
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

// Unqualified calls of a struct's functions from its other functions: glslang does not convert their
// arguments (`f(1)` with a float parameter: "no matching overloaded function found"). They become
// `this.f(1)`.
void call_own_methods_by_this(TokenText& text) {
  std::set<std::string_view> free_functions;  // functions to which the unqualified name may also refer
  for (const hlsl::Declaration& declaration : text.types().declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function)
      free_functions.insert(text.word(declaration.name));
  for (const auto& [name, type] : text.types().structs()) {
    std::set<std::string_view> own;
    for (const hlsl::Declaration& function : type.functions)
      if (!is_static(text, function)) own.insert(text.word(function.name));
    for (const hlsl::Declaration& function : type.functions)
      for (std::size_t at = function.open + 1; at < function.close; ++at)
        if (text.is_identifier(at) && own.contains(text.word(at)) &&
            !free_functions.contains(text.word(at)) && is_bare_call(text, at) && !is_static(text, function))
          text.insert(at, "this.");
  }
  text.apply();
}

// Calls of a struct's member functions on objects other than the caller's own variables: on the result of a
// function (`Build(x).Sample(uv)`), a const variable, a static global, a member of a cbuffer, an element of a
// structured buffer. glslang passes the object by a pointer that such values do not have, and emits an
// invalid module.
//
// After the struct, a function is added that takes the object as its first parameter and calls the member
// function: by value if the object is read-only, otherwise as inout, which preserves the member function's
// side effects. The calls are redirected to it.
//
// Limits: the object's type must be known (value_types.h); member functions with unnamed parameters are not
// changed.
void call_members_on_variables(TokenText& text) {
  if (text.holds({"struct"})) MemberCalls(text).run();
}

// Member functions that are declared in a struct and defined later: `struct S { float f(); };` and `float
// S::f() { return a; }`, or the body further down in the struct. glslang accepts definitions only within the
// struct. The definition replaces the prototype, with its original lines.
//
// Numeric variables that a body uses and that are declared after the struct are moved before it. Limits:
// functions and other types that are declared between the struct and the definition are then unknown in the
// body.
void put_bodies_into_structs(TokenText& text) {
  MethodBodies(text).run();
}

}  // namespace penumbra::preparation
