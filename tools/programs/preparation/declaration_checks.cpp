#include <cctype>
#include <charconv>
#include <map>
#include <system_error>

#include "preparation/declarators.h"
#include "preparation/declared_values.h"
#include "preparation/resource_types.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::uint64_t most_elements = 65536;  // FXC X3059

// The literal is 1024, 0x400 or 1024U.
bool is_above(std::string_view literal, std::uint64_t most) {
  const bool hexadecimal = literal.starts_with("0x") || literal.starts_with("0X");
  if (hexadecimal) literal.remove_prefix(2);
  std::uint64_t number = 0;
  const auto read =
      std::from_chars(literal.data(), literal.data() + literal.size(), number, hexadecimal ? 16 : 10);
  return read.ec == std::errc::result_out_of_range || (read.ec == std::errc() && number > most);
}

class ArraySizes {
 public:
  ArraySizes(TokenText& text, bool dxc) : text_(text), dxc_(dxc) {}

  void run() {
    for (const DeclaredValue& value : text_.types().declared())
      if (value.name != npos && value.type.dimensions > 0) check(value);
  }

 private:
  void check(const DeclaredValue& value) {
    for (std::size_t open = value.name + 1; text_.is(open, "[") && text_.matching_bracket(open) != npos;
         open = text_.matching_bracket(open) + 1) {
      const std::size_t close = text_.matching_bracket(open);
      if (close == open + 1) {
        if (needs_size(value)) refuse(value, " has no size: write how many elements it has");
      } else if (close == open + 2 && text_.is(open + 1, "0")) {
        refuse(value, " has 0 elements: it needs at least one");
      } else if (!dxc_ && close == open + 2 && is_above(text_.word(open + 1), most_elements)) {
        refuse(value, " has more than 65536 elements in one dimension: use a buffer or a texture");
      } else if (close == open + 3 && text_.is(open + 1, "-") && text_.is_number(open + 2)) {
        refuse(value, " has a negative size");
      }
    }
  }

  void refuse(const DeclaredValue& value, const std::string& why) {
    text_.error(value.name, "the array '" + text_.name(value.name) + "'" + why);
  }

  // An initialiser implies the size; DXC accepts resources without one.
  bool needs_size(const DeclaredValue& value) const {
    if (value.place == DeclaredValue::Place::parameter || text_.is(value.end, "=")) return false;
    return !dxc_ || !is_resource(value.type.name);
  }

  TokenText& text_;
  const bool dxc_;
};

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
    for (std::size_t at = first; at < next && text_.is_identifier(at) && is_modifier(text_.word(at)); ++at)
      is_extern = is_extern || text_.is(at, "extern");
    for (const DeclaredValue& value : values_)
      if (!is_extern) enter(value.name, scope);
    return next;
  }

  void enter(std::size_t name, const std::string& scope) {
    if (name == npos) return;
    const std::string spelling = text_.name(name);
    const auto [known, is_new] = names_.emplace(scope + spelling, name);
    if (is_new) return;
    text_.error(name, "'" + spelling + "' is already declared, at " + text_.file_of(known->second) + ":" +
                          std::to_string(text_[known->second].line) + ": remove one of the two");
    // glslang crashes on two types, so that each declaration gets a name of its own.
    text_.replace(name, 1, text_.free_name(spelling + "_" + std::to_string(name)));
  }

  TokenText& text_;
  std::map<std::string, std::size_t> names_;
  std::vector<DeclaredValue> values_;
};

// Returns the number of Direct3D 11's registers of a letter; 0 for a letter that has none.
std::size_t registers_of(char letter) {
  switch (letter) {
    case 'b':
      return 14;
    case 't':
      return 128;
    case 's':
      return 16;
    case 'u':
      return 64;
    default:
      return 0;
  }
}

// Returns the letters that a type may have: 'b', 't', 'u', 's'; empty if the type is not checked.
std::string_view letters_of(std::string_view type) {
  if (type == "cbuffer" || type == "ConstantBuffer") return "b";
  if (type == "tbuffer" || type == "TextureBuffer") return "t";
  if (type == "SamplerState" || type == "SamplerComparisonState") return "s";
  if (is_sampler(type)) return "st";
  if (!is_resource(type)) return {};
  const bool writable = type.starts_with("RW") || type.starts_with("RasterizerOrdered") ||
                        type.starts_with("Append") || type.starts_with("Consume");
  return writable ? "u" : "t";
}

class RegisterClasses {
 public:
  RegisterClasses(TokenText& text, bool dxc) : text_(text), dxc_(dxc) {}

  void run() {
    using Kind = hlsl::Declaration::Kind;
    for (const hlsl::Declaration& declaration : text_.declarations()) {
      if (declaration.kind == Kind::buffer) {
        check(declaration.type, declaration.open, text_.word(declaration.type));
      } else if (declaration.kind == Kind::variable) {
        std::size_t type = declaration.type;
        while (type < declaration.last && is_modifier(text_.word(type))) ++type;
        check(type, declaration.last, text_.word(type));
      }
    }
  }

 private:
  void check(std::size_t first, std::size_t end, std::string_view type) {
    for (std::size_t at = first; at + 2 < end; ++at)
      if (text_.is(at, "register") && text_.is(at + 1, "(") && text_.is(at - 1, ":")) one(at + 2, type);
  }

  // Checks `t3`, `t[3]`; an identifier before one is a profile.
  void one(std::size_t at, std::string_view type) {
    if (!text_.is_identifier(at)) return;
    if (text_.is(at + 1, ",") && text_.is_identifier(at + 2) && !text_.word(at + 2).starts_with("space"))
      at += 2;
    const std::string_view word = text_.word(at);
    const char letter = static_cast<char>(std::tolower(word[0]));
    const std::size_t number = number_of(at);
    const std::string named = "register '" + std::string(word) + "'";
    if (number == npos || std::string_view("btsucivo").find(letter) == std::string_view::npos)
      return text_.error(at,
                         named +
                             " does not exist: they are b0 (constant buffers), t0 (textures and buffers), "
                             "s0 (samplers), u0 (writable ones), and those after them");
    const std::string_view letters = letters_of(type);
    const std::size_t count = registers_of(letter);
    if (!letters.empty() && letters.find(letter) == std::string_view::npos) {
      text_.error(at, named + " is not one for a " + std::string(type) + ", whose registers begin with '" +
                          std::string(letters.substr(0, 1)) + "'");
    } else if (count != 0 && number >= count && !dxc_) {
      text_.error(at, named + " does not exist in Direct3D 11, which has " + std::string(1, letter) +
                          "0 to " + std::string(1, letter) + std::to_string(count - 1));
    }
  }

  // Returns 3 for `t3` and `t[3]`, 0 for `t[` with anything else, and npos if it is no register.
  std::size_t number_of(std::size_t at) const {
    std::string_view digits = text_.word(at).substr(1);
    if (digits.empty()) {
      if (!text_.is(at + 1, "[")) return npos;
      if (!text_.is_number(at + 2)) return 0;
      digits = text_.word(at + 2);
    }
    std::size_t number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return read.ec == std::errc() && read.ptr == digits.data() + digits.size() ? number : npos;
  }

  TokenText& text_;
  const bool dxc_;
};

}  // namespace

void check_array_sizes(TokenText& text, const EntryPoint& entry) {
  ArraySizes(text, entry.dxc).run();
}

void check_groupshared_values(TokenText& text) {
  for (const DeclaredValue& value : text.types().declared()) {
    const bool inside =
        value.place == DeclaredValue::Place::local || value.place == DeclaredValue::Place::member;
    if (!inside || value.first == npos || value.name == npos) continue;
    for (std::size_t at = value.first; at < value.name; ++at)
      if (text.is(at, "groupshared"))
        text.error(at, "'" + text.name(value.name) +
                           "' is groupshared, and such variables belong outside of functions and structs");
  }
}

void check_interfaces(TokenText& text) {
  for (std::size_t at = 0; at + 2 < text.size(); ++at)
    if (text.is(at, "interface") && text.is_identifier(at + 1) && text.is(at + 2, "{"))
      text.error(at,
                 "not supported here: interfaces, such as '" + text.name(at + 1) +
                     "'; take it out, name the struct itself where a parameter or variable has its type, and "
                     "choose between structs with #if");
}

void check_static_members(TokenText& text) {
  const ValueTypes& types = text.types();
  for (const auto& [name, type] : types.structs())
    for (const std::size_t member : type.members) {
      const DeclaredValue& value = types.declared()[member];
      if (value.is_static && value.name != npos)
        text.error(value.name,
                   "'" + text.name(value.name) +
                       "' is a static member, which is not supported: declare it outside of the structure");
    }
}

void check_string_values(TokenText& text, const EntryPoint& entry) {
  const ValueTypes& types = text.types();
  if (types.structs().contains("string")) return;
  for (const DeclaredValue& value : types.declared()) {
    if (value.name == npos || value.type.name != "string") continue;
    const bool refused = entry.dxc && value.place != DeclaredValue::Place::global;
    text.note(value.name, refused ? hlsl::Severity::error : hlsl::Severity::warning,
              refused ? "strings may only be declared at file scope, and shaders do not read them: remove it"
                      : "shaders do not read strings: this variable has no effect");
  }
}

void check_repeated_globals(TokenText& text) {
  RepeatedGlobals(text).run();
}

void check_register_classes(TokenText& text, const EntryPoint& entry) {
  RegisterClasses(text, entry.dxc).run();
}

}  // namespace penumbra::preparation
