#include "shaderlab/properties.h"

#include <array>
#include <map>

#include "shaderlab/characters.h"

namespace penumbra::shaderlab {

namespace {

struct TypeName {
  const char* name;
  PropertyType type;
};

constexpr std::array kTypes{
    TypeName{"Float", PropertyType::float_},      TypeName{"Range", PropertyType::range},
    TypeName{"Int", PropertyType::int_},          TypeName{"Integer", PropertyType::integer},
    TypeName{"Color", PropertyType::color},       TypeName{"Vector", PropertyType::vector},
    TypeName{"2D", PropertyType::texture},        TypeName{"3D", PropertyType::texture},
    TypeName{"Cube", PropertyType::texture},      TypeName{"2DArray", PropertyType::texture},
    TypeName{"CubeArray", PropertyType::texture}, TypeName{"Any", PropertyType::texture},
    TypeName{"Rect", PropertyType::texture},
};

// Separates Toggle(_ON) into Toggle and "_ON".
Attribute attribute_of(const Token& token) {
  const std::size_t open = std::min(token.spelling.find('('), token.spelling.size());
  const std::size_t close = token.spelling.rfind(')');
  Attribute attribute{{std::string(trimmed(token.spelling.substr(0, open))), token.place}, {}};
  if (close != std::string_view::npos && close > open)
    attribute.arguments = trimmed(token.spelling.substr(open + 1, close - open - 1));
  return attribute;
}

class PropertyParser {
 public:
  explicit PropertyParser(Cursor& cursor) : cursor_(cursor) {}

  Property parse() {
    while (cursor_.at(Token::Kind::bracket)) property_.attributes.push_back(attribute_of(cursor_.take()));
    property_.name =
        cursor_.expect_word(property_.attributes.empty() ? "a property's name or '}' in Properties"
                                                         : "a property's name after its attributes");
    cursor_.expect_mark('(', "after the property " + property_.name.text);
    property_.display_name = cursor_.expect_text("the label of " + property_.name.text).text;
    cursor_.expect_mark(',', "between label and type of " + property_.name.text);
    type();
    cursor_.expect_mark(')', "after the type of " + property_.name.text);
    cursor_.expect_mark('=', "and the default of " + property_.name.text);
    value();
    return std::move(property_);
  }

 private:
  void type() {
    const Token& token = cursor_.peek();
    const auto* found = std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& type) {
      return token.kind == Token::Kind::identifier && same_keyword(type.name, token.spelling);
    });
    if (found == kTypes.end()) unknown_type();
    property_.type = found->type;
    property_.type_name = cursor_.take().spelling;
    if (found->type == PropertyType::range) range();
  }

  [[noreturn]] void unknown_type() {
    std::vector<std::string> names;
    names.reserve(kTypes.size());
    for (const TypeName& type : kTypes) names.emplace_back(type.name);
    std::string hint;
    if (cursor_.at(Token::Kind::identifier)) hint = near_name_hint(cursor_.peek().spelling, names);
    if (hint.empty()) {
      hint = "Float, Range(a, b), Int, Integer, Color, Vector, 2D, 3D, Cube, 2DArray, CubeArray or Any";
    } else if (hint.find('?') != std::string::npos) {
      cursor_.fail("a type for " + property_.name.text + " (" + hint + ")");
    }
    cursor_.fail("the type of " + property_.name.text + ", " + hint);
  }

  void range() {
    cursor_.expect_mark('(', "after Range");
    cursor_.expect_number("the least value of the Range");
    cursor_.expect_mark(',', "between the values of the Range");
    cursor_.expect_number("the largest value of the Range");
    cursor_.expect_mark(')', "after the values of the Range");
  }

  void value() {
    switch (property_.type) {
      case PropertyType::color:
      case PropertyType::vector:
        return numbers();
      case PropertyType::texture:
        return texture();
      default:
        property_.default_numbers = {
            cursor_.expect_number("the default of " + property_.name.text + ", a number")};
    }
  }

  void numbers() {
    cursor_.expect_mark('(', "before the default of " + property_.name.text);
    do {
      property_.default_numbers.push_back(
          cursor_.expect_number("a number in the default of " + property_.name.text));
    } while (property_.default_numbers.size() < 4 && cursor_.take_punctuation(','));
    cursor_.expect_mark(')', "after the default of " + property_.name.text);
  }

  // In "white" {}, the braces once held options of fixed-function texturing.
  void texture() {
    cursor_.expect_text("the default texture of " + property_.name.text);
    if (!cursor_.at_punctuation('{')) return;
    const int line = cursor_.take().place.line;
    while (!cursor_.take_punctuation('}')) {
      if (cursor_.at_end() || cursor_.at_punctuation('{') || cursor_.at_punctuation('='))
        cursor_.fail("'}' for the '{' of line " + std::to_string(line) + " after the default of " +
                     property_.name.text);
      cursor_.take();
    }
  }

  Cursor& cursor_;
  Property property_;
};

}  // namespace

void parse_properties(Cursor& cursor, std::vector<Property>& properties) {
  cursor.expect_mark('{', "after Properties");
  std::map<std::string, int> lines;
  while (!cursor.take_punctuation('}')) {
    properties.push_back(PropertyParser(cursor).parse());
    const Name& name = properties.back().name;
    const auto [earlier, is_new] = lines.emplace(name.text, name.place.line);
    if (!is_new)
      cursor.warn(name.place, "the property " + name.text + " is already declared in line " +
                                  std::to_string(earlier->second));
  }
}

}  // namespace penumbra::shaderlab
