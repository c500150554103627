#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

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
      } else if (!dxc_ && close == open + 2 && is_above(text_[open + 1].spelling, most_elements)) {
        refuse(value, " has more than 65536 elements in one dimension: use a buffer or a texture");
      } else if (close == open + 3 && text_.is(open + 1, "-") &&
                 text_[open + 2].kind == hlsl::Token::Kind::number) {
        refuse(value, " has a negative size");
      }
    }
  }

  void refuse(const DeclaredValue& value, const std::string& why) {
    text_.note(value.name, hlsl::Severity::error,
               "the array '" + std::string(text_[value.name].spelling) + "'" + why);
  }

  // An initialiser implies the size; DXC accepts resources without one.
  bool needs_size(const DeclaredValue& value) const {
    if (value.place == DeclaredValue::Place::parameter || text_.is(value.end, "=")) return false;
    return !dxc_ || !is_resource(value.type.name);
  }

  TokenText& text_;
  const bool dxc_;
};

}  // namespace

void check_array_sizes(TokenText& text, const EntryPoint& entry) {
  ArraySizes(text, entry.dxc).run();
}

}  // namespace penumbra::preparation
