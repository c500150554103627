#include <set>
#include <utility>

#include "hlsl/name_set.h"
#include "preparation/entry_functions.h"
#include "preparation/semantic_names.h"
#include "preparation/source_checks.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

namespace {

constexpr int deepest_struct = 16;  // nesting of structs

struct Direction {
  bool in = false;
  bool out = false;
};

// A value such as `float2 uv[2] : TEXCOORD0`: a parameter, a member or a return value.
struct Value {
  std::size_t type = npos;      // its type's first token
  std::size_t name = npos;      // the token for messages about it
  std::size_t semantic = npos;  // the semantic's token, the last of several; npos without one
  Direction direction;
  bool exempt = false;  // uniform, static, or with a ':' that is not followed by a semantic
};

bool is_type_modifier(std::string_view word) {
  static constexpr hlsl::NameSet modifiers(
      "const", "precise", "inline", "linear", "centroid", "nointerpolation", "noperspective", "sample",
      "row_major", "column_major", "snorm", "unorm", "volatile", "point", "line", "triangle", "lineadj",
      "triangleadj", "export", "struct", "globallycoherent");
  return modifiers.contains(word);
}

// Types whose values are inputs and outputs; others (textures, aliases) are not checked.
bool is_numeric(std::string_view type) {
  const std::size_t digit = type.find_first_of("0123456789");
  static constexpr hlsl::NameSet scalars("bool", "int", "uint", "dword", "half", "float", "double", "fixed",
                                         "vector", "matrix");
  if (type.starts_with("min") || type.starts_with("float16") || type.starts_with("int16") ||
      type.starts_with("uint16"))
    return type.find("_t") != std::string_view::npos || type.starts_with("min1");
  return scalars.contains(type.substr(0, digit)) &&
         (digit == std::string_view::npos || type.substr(digit).size() == 1 ||
          (type.substr(digit).size() == 3 && type[digit + 1] == 'x'));
}

// Types that contain several elements of their template argument.
bool holds_elements(std::string_view type) {
  static constexpr hlsl::NameSet types("InputPatch", "OutputPatch", "PointStream", "LineStream",
                                       "TriangleStream");
  return types.contains(type);
}

class EntrySemantics {
 public:
  EntrySemantics(TokenText& text, const EntryPoint& entry) : text_(text), entry_(entry) {}

  std::vector<SemanticPlace> run() {
    const std::vector<const hlsl::Declaration*> named = entry_functions(text_, entry_);
    if (named.size() != 1 || named.front()->parameters_close == npos) return {};
    const hlsl::Declaration& function = *named.front();
    visit(returned(function), 0);
    for (std::size_t at = function.parameters_open + 1; at < function.parameters_close;) {
      const std::size_t end = element_end(at, function.parameters_close, ",");
      const std::optional<Value> parameter = value(at, end);
      visit(parameter, 0);
      if (parameter && parameter->direction.in && parameter->direction.out) inouts_.push_back(*parameter);
      at = end + 1;
    }
    if (!entry_.dxc) name_system_values(function.open);
    text_.apply();
    return std::move(places_);
  }

 private:
  const hlsl::Declaration* structure(std::string_view name) const {
    for (const hlsl::Declaration& declaration : text_.declarations())
      if (declaration.kind == hlsl::Declaration::Kind::structure && declaration.name != npos &&
          declaration.open != npos && declaration.scope.empty() && text_.word(declaration.name) == name)
        return &declaration;
    return nullptr;
  }

  // Returns the next of these characters outside of brackets and angle brackets; `end` without one.
  std::size_t element_end(std::size_t at, std::size_t end, std::string_view mark) const {
    for (int angles = 0; at < end; ++at) {
      if ((text_.is_any(at, "(", "[", "{")) && text_.matching_bracket(at) != npos) {
        at = text_.matching_bracket(at);
        continue;
      }
      angles += text_.is(at, "<") ? 1 : text_.is(at, ">") ? -1 : 0;
      if (angles == 0 && text_.is(at, mark)) return at;
    }
    return end;
  }

  // Reads the last of `: A : B`.
  void read_semantic(std::size_t first, std::size_t end, Value& value) const {
    value.semantic = npos;
    bool has_other = false;  // a register, or nothing, which the parser reports
    for (std::size_t at = first; at < end && !text_.is(at, "="); ++at) {
      if (!text_.is(at, ":")) continue;
      const bool is_semantic = at + 1 < end && text_.is_identifier(at + 1) && !text_.is(at + 2, "(");
      if (is_semantic) value.semantic = at + 1;
      has_other = has_other || !is_semantic;
    }
    value.exempt = value.exempt || (has_other && value.semantic == npos);
  }

  std::size_t behind_type(std::size_t type, std::size_t end) const {
    std::size_t at = type + 1;
    if (!text_.is(at, "<")) return at;
    for (int depth = 0; at < end; ++at) {
      depth += text_.is(at, "<") ? 1 : text_.is(at, ">") ? -1 : 0;
      if (depth == 0) return at + 1;
    }
    return end;
  }

  std::optional<Value> value(std::size_t first, std::size_t end) const {
    Value value;
    value.direction.in = true;
    std::size_t at = first;
    for (; at < end; ++at) {
      if (text_.is(at, "[") && text_.matching_bracket(at) != npos) {  // an attribute
        at = text_.matching_bracket(at);
      } else if (text_.is_any(at, "uniform", "static")) {
        value.exempt = true;
      } else if (text_.is(at, "out")) {
        value.direction = {false, true};
      } else if (text_.is(at, "inout")) {
        value.direction = {true, true};
      } else if (!text_.is(at, "in") && !is_type_modifier(text_.word(at))) {
        break;
      }
    }
    if (at >= end || !text_.is_identifier(at)) return std::nullopt;
    value.type = at;
    value.name = behind_type(at, end);
    if (value.name >= end || !text_.is_identifier(value.name)) return std::nullopt;
    read_semantic(value.name + 1, end, value);
    return value;
  }

  std::optional<Value> returned(const hlsl::Declaration& function) const {
    Value value;
    value.direction.out = true;
    value.type = function.type;
    while (value.type < function.name && (is_type_modifier(text_.word(value.type)) ||
                                          text_.is(value.type, "static") || !text_.is_identifier(value.type)))
      ++value.type;
    if (value.type >= function.name) return std::nullopt;
    value.name = function.name;
    read_semantic(function.parameters_close + 1, function.open, value);
    return value;
  }

  void visit(const std::optional<Value>& value, int depth) {
    if (!value || value->exempt || depth > deepest_struct || text_.is(value->type, "void")) return;
    if (value->semantic != npos) return add(*value);
    std::string_view type = text_.word(value->type);
    Direction direction = value->direction;
    if (holds_elements(type)) {
      if (!text_.is(value->type + 1, "<")) return;
      direction = type.ends_with("Stream") ? Direction{false, true} : Direction{true, false};
      type = text_.word(value->type + 2);
    }
    if (const hlsl::Declaration* members = structure(type)) visit_members(*members, direction, depth + 1);
  }

  void visit_members(const hlsl::Declaration& of, Direction direction, int depth) {
    if (depth > deepest_struct || !visited_.insert({&of, direction.out}).second) return;
    for (std::size_t at = of.name + 1; at < of.open; ++at)  // its bases
      if (text_.is_identifier(at))
        if (const hlsl::Declaration* base = structure(text_.word(at)))
          if (base != &of) visit_members(*base, direction, depth + 1);
    for (std::size_t at = of.open + 1; at < of.close;) {
      const std::size_t semicolon = element_end(at, of.close, ";");
      if (const std::size_t behind = behind_function(at, semicolon); behind != npos) {
        at = behind;
        continue;
      }
      visit_declarators(at, semicolon, direction, depth);
      at = semicolon + 1;
    }
  }

  // Returns one past a member function that begins here; npos for other members.
  std::size_t behind_function(std::size_t first, std::size_t end) const {
    for (std::size_t at = first; at < end; ++at) {
      if (text_.is_any(at, ":", "=")) return npos;
      if (text_.is(at, "[") && text_.matching_bracket(at) != npos) at = text_.matching_bracket(at);
      if (!text_.is(at, "(") || text_.matching_bracket(at) == npos) continue;
      for (std::size_t body = text_.matching_bracket(at) + 1; body < end; ++body)
        if (text_.is(body, "{") && text_.matching_bracket(body) != npos)
          return text_.matching_bracket(body) + 1;
      return end + 1;
    }
    return npos;
  }

  // Visits `float a : A, b : B;`.
  void visit_declarators(std::size_t first, std::size_t end, Direction direction, int depth) {
    std::size_t at = element_end(first, end, ",");
    std::optional<Value> member = value(first, at);
    if (!member || text_.is(member->type + 1, "{")) return;
    while (true) {
      member->direction = direction;
      visit(member, depth);
      if (at >= end) return;
      const std::size_t next = element_end(at + 1, end, ",");
      if (!text_.is_identifier(at + 1)) return;
      member->name = at + 1;
      read_semantic(at + 2, next, *member);
      at = next;
    }
  }

  void add_place(std::size_t at, bool output) {
    places_.push_back({text_.name(at), output, text_.file_of(at), text_[at].line});
    tokens_.push_back(at);
  }

  // Returns the value if it is a vector or scalar; nullptr for the semantics of other values.
  const Value* inout_with(std::size_t semantic) const {
    const auto found = std::find_if(inouts_.begin(), inouts_.end(), [&](const Value& value) {
      return value.semantic == semantic && text_.is(value.name + 1, ":") &&
             is_numeric(text_.word(value.type));
    });
    return found == inouts_.end() ? nullptr : &*found;
  }

  // Replaces `inout float4 p : POSITION` by `in float4 p_in : POSITION, out float4 p : SV_Position`.
  void take_apart(const Value& parameter, const std::string& output, std::size_t body) {
    std::size_t direction = parameter.type;
    while (!text_.is(direction, "inout")) --direction;
    const std::string name = text_.name(parameter.name);
    const std::string input = text_.free_name(name + "_in");
    text_.replace(direction, 1,
                  "in " + text_.spelled(parameter.type, parameter.name - parameter.type) + " " + input +
                      " : " + text_.name(parameter.semantic) + ", out");
    text_.replace(parameter.semantic, 1, output);
    text_.insert(body + 1, name + " = " + input + ";");
  }

  // Replaces names of Direct3D 9. A name that is an input and an output of the program, in a struct of both,
  // stays.
  void name_system_values(std::size_t body) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      SemanticPlace& place = places_[i];
      const std::string name = system_value_of(place.semantic, entry_.stage, !place.output);
      const bool both = std::count(tokens_.begin(), tokens_.end(), tokens_[i]) > 1;
      const bool read_by_name = entry_.stage == hlsl::Stage::vertex && !entry_.rasterized;
      const Value* const apart = place.output ? inout_with(tokens_[i]) : nullptr;
      if (name.empty() || (both && apart == nullptr) || read_by_name) continue;
      place.semantic = name;
      if (apart != nullptr) {
        take_apart(*apart, name, body);
      } else {
        text_.replace(tokens_[i], 1, name);
      }
    }
  }

  void add(const Value& value) {
    const std::string semantic = text_.name(value.semantic);
    for (const bool output : {false, true}) {
      if (!(output ? value.direction.out : value.direction.in)) continue;
      add_place(value.semantic, output);
      const std::string problem = distance_problem(semantic, entry_.stage, !output);
      if (!problem.empty() && reported_.insert(value.semantic).second)
        text_.error(value.semantic, "'" + semantic + "' " + problem);
    }
  }

  TokenText& text_;
  const EntryPoint& entry_;
  std::set<std::pair<const hlsl::Declaration*, bool>> visited_;
  std::set<std::size_t> reported_;
  std::vector<SemanticPlace> places_;
  std::vector<std::size_t> tokens_;  // tokens of places_
  std::vector<Value> inouts_;        // parameters
};

}  // namespace

std::vector<SemanticPlace> read_entry_semantics(TokenText& text, const EntryPoint& entry) {
  return EntrySemantics(text, entry).run();
}

}  // namespace penumbra::preparation
