#include "preparation/value_types.h"

#include <utility>

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

using Place = DeclaredValue::Place;

// Keywords that may precede an identifier without being its type.
bool is_statement_word(std::string_view word) {
  static constexpr hlsl::NameSet words("return", "else", "do", "case", "struct", "class", "typedef", "goto",
                                       "namespace");
  return words.contains(word);
}

ValueType named_type(std::string_view name) {
  ValueType type;
  type.name = name;
  return type;
}

bool is_structured_buffer(std::string_view type) {
  return type == "StructuredBuffer" || type == "RWStructuredBuffer";
}

}  // namespace

class ValueTypesReader {
 public:
  ValueTypesReader(const TokenText& text, ValueTypes& to) : text_(text), to_(to) {}

  void run() {
    to_.places_.resize(text_.size());
    to_.types_.emplace_back();
    visible_.assign(text_.identifier_count(), npos);
    returns_.assign(text_.identifier_count(), not_declared);
    for (std::size_t index = 0; index < to_.declarations_.size(); ++index) declare(index);
    for (const hlsl::Declaration& declaration : to_.declarations_) read(declaration);
  }

 private:
  using Kind = hlsl::Declaration::Kind;

  // The first pass reads declarations at file scope and in structs.
  void declare(std::size_t index) {
    const hlsl::Declaration& declaration = to_.declarations_[index];
    switch (declaration.kind) {
      case Kind::variable:
        declare_values({declaration.type, declaration.last + 1, Place::global});
        break;
      case Kind::buffer:
        for (std::size_t at = declaration.open + 1; at < declaration.close;)
          at = declare_values({at, declaration.close, Place::global});
        break;
      case Kind::structure:
        declare_struct(index);
        break;
      case Kind::function:
      case Kind::prototype:
        declare_function(declaration);
        break;
      default:
        break;
    }
  }

  void declare_function(const hlsl::Declaration& declaration) {
    const ValueType returned = type_before(declaration.type, declaration.name);
    std::uint32_t& known = returns_[text_.identifier_number(declaration.name)];
    if (known == not_declared) {
      known = add_type(returned);
    } else if (to_.types_[known].name != returned.name) {
      known = 0;
    }
  }

  ValueType type_before(std::size_t first, std::size_t name) const {
    while (first < name && is_modifier(text_.word(first))) ++first;
    return first < name && text_.is_identifier(first) ? named_type(text_.word(first)) : ValueType{};
  }

  void declare_struct(std::size_t index) {
    const hlsl::Declaration& declaration = to_.declarations_[index];
    if (declaration.name == hlsl::Declaration::none) return;
    StructType type;
    type.declaration = index;
    if (text_.is(declaration.name + 1, ":") && text_.is_identifier(declaration.name + 2))
      type.base = text_.word(declaration.name + 2);
    for (std::size_t at = declaration.open + 1; at < declaration.close;)
      at = member(at, declaration.close, type);
    to_.structs_.insert_or_assign(text_.word(declaration.name), std::move(type));
    declare_values(
        {declaration.close + 1, declaration.last + 1, Place::global, text_.word(declaration.name)});
  }

  // Reads one member from `at`; returns where the next begins.
  std::size_t member(std::size_t at, std::size_t end, StructType& type) {
    std::size_t stop = at;
    while (stop < end && !text_.is_any(stop, ";", "{", "(")) ++stop;
    if (text_.is(stop, "(") && stop > at + 1) return method(at, stop, end, type);
    const std::size_t before = to_.declared_.size();
    const std::size_t next = declare_values({at, end, Place::member});
    for (std::size_t i = before; i < to_.declared_.size(); ++i) {
      type.members.push_back(i);
      type.member_names.emplace(text_.word(to_.declared_[i].name), i);
    }
    return next;
  }

  std::size_t method(std::size_t at, std::size_t parameters, std::size_t end, StructType& type) {
    hlsl::Declaration function;
    function.kind = Kind::function;
    function.first = function.type = at;
    function.name = parameters - 1;
    function.parameters_open = parameters;
    function.parameters_close = text_.matching_bracket(parameters);
    if (function.parameters_close == npos) return end;
    std::size_t stop = function.parameters_close + 1;
    while (stop < end && !text_.is_any(stop, "{", ";")) ++stop;
    if (!text_.is(stop, "{") || text_.matching_bracket(stop) == npos) return stop + 1;
    function.open = stop;
    function.close = function.last = text_.matching_bracket(stop);
    type.functions.push_back(function);
    return function.close + 1;
  }

  std::uint32_t add_type(const ValueType& type) {
    if (type.name.empty() && type.dimensions == 0 && !type.constant) return 0;
    to_.types_.push_back(type);
    return ValueTypes::narrow(to_.types_.size() - 1);
  }

  void name_value(std::size_t at, std::size_t declared) {
    to_.places_[at].named = ValueTypes::narrow(declared);
    to_.places_[at].type = declared_types_[declared];
  }

  std::size_t declare_values(const DeclarationRange& range) {
    just_read_.clear();
    const std::size_t next = read_declaration(text_, range, just_read_);
    for (const DeclaredValue& value : just_read_) enter(value);
    return next;
  }

  void enter(const DeclaredValue& value) {
    const std::size_t index = to_.declared_.size();
    to_.declared_.push_back(value);
    declared_types_.push_back(add_type(value.type));
    if (value.name == npos) return;
    to_.places_[value.name].named = ValueTypes::narrow(index);
    if (value.place == Place::member) return;
    const std::uint32_t number = text_.identifier_number(value.name);
    std::size_t& visible = visible_[number];
    if (value.place != Place::global) hidden_.emplace_back(number, visible);
    visible = index;
  }

  // The second pass reads the bodies and initialisers.
  void read(const hlsl::Declaration& declaration) {
    if (declaration.kind == Kind::function || declaration.kind == Kind::prototype) {
      read_function(declaration);
    } else if (declaration.kind == Kind::structure && declaration.name != hlsl::Declaration::none) {
      read_methods(text_.word(declaration.name));
    } else if (declaration.kind == Kind::variable) {
      for (std::size_t at = declaration.first; at <= declaration.last; ++at) step(at, nullptr);
    }
  }

  void read_methods(std::string_view name) {
    current_struct_ = name;
    for (const hlsl::Declaration& function : to_.structs_.at(name).functions) read_function(function);
    current_struct_ = {};
  }

  void read_function(const hlsl::Declaration& declaration) {
    const std::size_t before = hidden_.size();
    FunctionType function;
    function.name = declaration.name;
    const std::size_t first = to_.declared_.size();
    for (std::size_t at = declaration.parameters_open + 1; at < declaration.parameters_close;)
      at = parameter(at, declaration.parameters_close);
    for (std::size_t i = first; i < to_.declared_.size(); ++i) function.parameters.push_back(i);
    if (declaration.kind == Kind::function) {
      function.body = declaration.open;
      body(declaration);
    }
    to_.functions_.push_back(std::move(function));
    restore(before);
  }

  std::size_t parameter(std::size_t at, std::size_t end) {
    if (text_.is(at, "void") && at + 1 == end) return end;
    return declare_values({at, end, Place::parameter});
  }

  void restore(std::size_t size) {
    for (; hidden_.size() > size; hidden_.pop_back()) visible_[hidden_.back().first] = hidden_.back().second;
  }

  void body(const hlsl::Declaration& declaration) {
    std::vector<std::size_t> blocks;
    for (std::size_t at = declaration.open; at <= declaration.close; ++at) {
      step(at, &blocks);
      if (text_.is(at, "{")) blocks.push_back(hidden_.size());
      if (text_.is(at, "}") && !blocks.empty()) {
        restore(blocks.back());
        blocks.pop_back();
      }
    }
  }

  void step(std::size_t at, const std::vector<std::size_t>* in_body) {
    if (text_.is_identifier(at)) {
      if (in_body != nullptr) declaration_statement(at);
      name(at);
    } else if (text_.is(at, "]")) {
      element(at);
    } else if (text_.is(at, ")")) {
      parenthesised(at);
    }
  }

  // Two consecutive identifiers, or a type with template arguments and an identifier, are a declaration.
  void declaration_statement(std::size_t at) {
    if (at < statement_end_ || (at > 0 && text_.is(at - 1, "."))) return;
    if (is_modifier(text_.word(at)) || is_statement_word(text_.word(at))) return;
    const std::size_t name = after_template(text_, at + 1, text_.size());
    if (!text_.is_identifier(name) || is_statement_word(text_.word(name))) return;
    const bool is_template = name > at + 1;
    if (is_template && text_.is(name + 1, "(")) return;                        // a < b > c(
    if (is_template && visible_[text_.identifier_number(at)] != npos) return;  // two comparisons
    std::size_t first = at;
    while (first > 0 && text_.is_identifier(first - 1) && is_modifier(text_.word(first - 1))) --first;
    std::size_t end = name;
    while (end < text_.size() && !text_.is_any(end, ";", ")", "}")) end = text_.after(end);
    statement_end_ = end;
    declare_values({first, end, Place::local});
  }

  void name(std::size_t at) {
    const bool called = text_.is(at + 1, "(");
    if (at > 0 && text_.is(at - 1, ".")) {
      if (at < 2) return;
      to_.places_[at].begin = to_.places_[at - 2].begin;
      member_of(to_.at(at - 2), at, called);
      return;
    }
    if (at > 0 && text_.is(at - 1, ":") && at > 1 && text_.is(at - 2, ":")) return;
    to_.places_[at].begin = ValueTypes::narrow(at);
    if (text_.is(at, "this")) {
      to_.places_[at].type = add_type(named_type(current_struct_));
    } else if (called) {
      result(at, function_result(at));
    } else {
      variable(at);
    }
  }

  std::uint32_t function_result(std::size_t name) {
    if (!current_struct_.empty()) {
      const ValueType own = method_result(current_struct_, text_.word(name));
      if (!own.name.empty()) return add_type(own);
    }
    const std::uint32_t known = returns_[text_.identifier_number(name)];
    return known == not_declared ? 0 : known;
  }

  void result(std::size_t callee, std::uint32_t type) {
    const std::size_t close = text_.matching_bracket(callee + 1);
    if (close == npos || to_.begin(callee) == npos) return;
    to_.places_[close].type = type;
    to_.places_[close].begin = to_.places_[callee].begin;
  }

  void variable(std::size_t at) {
    if (to_.named(at) != npos) return;  // its own declaration
    std::size_t index = visible_[text_.identifier_number(at)];
    const bool may_be_member = index == npos || to_.declared_[index].place == Place::global;
    if (may_be_member && !current_struct_.empty()) {
      const std::size_t member = find_member(current_struct_, text_.word(at));
      if (member != npos) index = member;
    }
    if (index != npos) name_value(at, index);
  }

  void member_of(ValueType of, std::size_t at, bool called) {
    if (of.name.empty() || of.dimensions > 0) return;
    if (called) return result(at, add_type(method_result(of.name, text_.word(at))));
    const std::size_t index = find_member(of.name, text_.word(at));
    if (index == npos) return;
    name_value(at, index);
    if (!of.constant || to_.at(at).constant) return;
    ValueType type = to_.at(at);
    type.constant = true;
    to_.places_[at].type = add_type(type);
  }

  // The search goes along the bases, which may be cyclic in an invalid text.
  template <typename Look>
  void each_base(std::string_view type, Look look) const {
    constexpr int deepest = 16;
    for (int depth = 0; depth < deepest && !type.empty(); ++depth) {
      const auto known = to_.structs_.find(type);
      if (known == to_.structs_.end() || look(known->second)) return;
      type = known->second.base;
    }
  }

  std::size_t find_member(std::string_view type, std::string_view name) const {
    std::size_t found = npos;
    each_base(type, [&](const StructType& in) {
      const auto member = in.member_names.find(name);
      if (member != in.member_names.end()) found = member->second;
      return found != npos;
    });
    return found;
  }

  ValueType method_result(std::string_view type, std::string_view name) const {
    ValueType found;
    bool several = false;
    each_base(type, [&](const StructType& in) {
      for (const hlsl::Declaration& function : in.functions) {
        if (text_.word(function.name) != name) continue;
        const ValueType returned = type_before(function.type, function.name);
        several = several || (!found.name.empty() && found.name != returned.name);
        found = returned;
      }
      return !found.name.empty();
    });
    return several ? ValueType{} : found;
  }

  void element(std::size_t close) {
    const std::size_t open = text_.matching_bracket(close);
    if (open == npos || open == 0) return;
    ValueType type = to_.at(open - 1);
    to_.places_[close].begin = to_.places_[open - 1].begin;
    if (type.dimensions > 0) {
      --type.dimensions;
    } else if (is_structured_buffer(type.name)) {
      const bool constant = type.name == "StructuredBuffer";
      type = named_type(type.element);
      type.constant = constant;
    } else {
      return;
    }
    to_.places_[close].type = add_type(type);
  }

  void parenthesised(std::size_t close) {
    const std::size_t open = text_.matching_bracket(close);
    if (open == npos || to_.begin(close) != npos || close == open + 1) return;
    if (to_.begin(close - 1) != open + 1) return;
    to_.places_[close].type = to_.places_[close - 1].type;
    to_.places_[close].begin = ValueTypes::narrow(open);
  }

  const TokenText& text_;
  ValueTypes& to_;
  std::vector<std::uint32_t> declared_types_;  // for each declared value: index into types_
  // By identifier number, these are the type that functions of that name return, and the variable that the
  // name refers to.
  static constexpr std::uint32_t not_declared = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> returns_;
  std::vector<std::size_t> visible_;
  // The index in visible_, and the value that it replaced.
  std::vector<std::pair<std::uint32_t, std::size_t>> hidden_;
  std::vector<DeclaredValue> just_read_;
  std::string_view current_struct_;
  std::size_t statement_end_ = 0;  // end of the declaration that is being read
};

ValueTypes::ValueTypes(const TokenText& text) : declarations_(text.declarations()) {
  ValueTypesReader(text, *this).run();
}

}  // namespace penumbra::preparation
