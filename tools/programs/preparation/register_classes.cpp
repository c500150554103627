#include <cctype>
#include <charconv>
#include <string>
#include <string_view>

#include "preparation/declarators.h"
#include "preparation/resource_types.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

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
        check(declaration.type, declaration.open, text_[declaration.type].spelling);
      } else if (declaration.kind == Kind::variable) {
        std::size_t type = declaration.type;
        while (type < declaration.last && is_modifier(text_[type].spelling)) ++type;
        check(type, declaration.last, text_[type].spelling);
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
    if (text_.is(at + 1, ",") && text_.is_identifier(at + 2) && !text_[at + 2].spelling.starts_with("space"))
      at += 2;
    const std::string_view word = text_[at].spelling;
    const char letter = static_cast<char>(std::tolower(word[0]));
    const std::size_t number = number_of(at);
    const std::string named = "register '" + std::string(word) + "'";
    if (number == npos || std::string_view("btsucivo").find(letter) == std::string_view::npos)
      return text_.note(at, hlsl::Severity::error,
                        named +
                            " does not exist: they are b0 (constant buffers), t0 (textures and buffers), "
                            "s0 (samplers), u0 (writable ones), and those after them");
    const std::string_view letters = letters_of(type);
    const std::size_t count = registers_of(letter);
    if (!letters.empty() && letters.find(letter) == std::string_view::npos) {
      text_.note(at, hlsl::Severity::error,
                 named + " is not one for a " + std::string(type) + ", whose registers begin with '" +
                     std::string(letters.substr(0, 1)) + "'");
    } else if (count != 0 && number >= count && !dxc_) {
      text_.note(at, hlsl::Severity::error,
                 named + " does not exist in Direct3D 11, which has " + std::string(1, letter) + "0 to " +
                     std::string(1, letter) + std::to_string(count - 1));
    }
  }

  // Returns 3 for `t3` and `t[3]`, 0 for `t[` with anything else, and npos if it is no register.
  std::size_t number_of(std::size_t at) const {
    std::string_view digits = text_[at].spelling.substr(1);
    if (digits.empty()) {
      if (!text_.is(at + 1, "[")) return npos;
      if (text_[at + 2].kind != hlsl::Token::Kind::number) return 0;
      digits = text_[at + 2].spelling;
    }
    std::size_t number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return read.ec == std::errc() && read.ptr == digits.data() + digits.size() ? number : npos;
  }

  TokenText& text_;
  const bool dxc_;
};

}  // namespace

void check_register_classes(TokenText& text, const EntryPoint& entry) {
  RegisterClasses(text, entry.dxc).run();
}

}  // namespace penumbra::preparation
