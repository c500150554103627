#include "shaderlab/commands.h"

#include <array>

#include "shaderlab/characters.h"
#include "shaderlab/command_values.h"

namespace penumbra::shaderlab {

namespace {

enum class Operands {
  none,
  one,         // Cull Off
  pair,        // Offset 0, -1
  blend,       // Blend [target] A B [, A B], Blend [target] Off
  blend_op,    // BlendOp [target] Op [, Op]
  color_mask,  // ColorMask RGB [target]
  test,        // AlphaTest Greater 0.5, AlphaTest Off
  colour,      // Color (1, 1, 1, 1), Color [_Color]
  channels,    // Bind "vertex", vertex
  expression   // combine texture * primary DOUBLE, constant
};

// The braces in which a command is allowed.
enum class Scope { pass, stencil, fog, material, channels, texture };

struct Shape {
  const char* name;
  Scope scope;
  Operands operands;
  std::optional<Scope> block;        // the scope of its braces
  Values values = Values::anything;  // the values of its words
};

constexpr std::array kShapes{
    Shape{"AlphaTest", Scope::pass, Operands::test, {}, Values::comparison},
    Shape{"AlphaToMask", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"BindChannels", Scope::pass, Operands::none, Scope::channels},
    Shape{"Blend", Scope::pass, Operands::blend, {}, Values::blend_factor},
    Shape{"BlendOp", Scope::pass, Operands::blend_op, {}, Values::blend_operation},
    Shape{"Color", Scope::pass, Operands::colour, {}},
    Shape{"ColorMask", Scope::pass, Operands::color_mask, {}, Values::color_mask},
    Shape{"ColorMaterial", Scope::pass, Operands::one, {}, Values::color_material},
    Shape{"Conservative", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"Cull", Scope::pass, Operands::one, {}, Values::cull},
    Shape{"Fog", Scope::pass, Operands::none, Scope::fog},
    Shape{"Lighting", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"Material", Scope::pass, Operands::none, Scope::material},
    Shape{"Offset", Scope::pass, Operands::pair, {}, Values::number},
    Shape{"SeparateSpecular", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"SetTexture", Scope::pass, Operands::one, Scope::texture},
    Shape{"Stencil", Scope::pass, Operands::none, Scope::stencil},
    Shape{"ZClip", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"ZTest", Scope::pass, Operands::one, {}, Values::comparison},
    Shape{"ZWrite", Scope::pass, Operands::one, {}, Values::toggle},
    Shape{"Comp", Scope::stencil, Operands::one, {}, Values::comparison},
    Shape{"CompBack", Scope::stencil, Operands::one, {}, Values::comparison},
    Shape{"CompFront", Scope::stencil, Operands::one, {}, Values::comparison},
    Shape{"Fail", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"FailBack", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"FailFront", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"Pass", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"PassBack", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"PassFront", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"ReadMask", Scope::stencil, Operands::one, {}, Values::stencil_number},
    Shape{"Ref", Scope::stencil, Operands::one, {}, Values::stencil_number},
    Shape{"WriteMask", Scope::stencil, Operands::one, {}, Values::stencil_number},
    Shape{"ZFail", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"ZFailBack", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"ZFailFront", Scope::stencil, Operands::one, {}, Values::stencil_operation},
    Shape{"Color", Scope::fog, Operands::colour, {}},
    Shape{"Density", Scope::fog, Operands::one, {}},
    Shape{"Mode", Scope::fog, Operands::one, {}, Values::fog_mode},
    Shape{"Range", Scope::fog, Operands::pair, {}},
    Shape{"Ambient", Scope::material, Operands::colour, {}},
    Shape{"Diffuse", Scope::material, Operands::colour, {}},
    Shape{"Emission", Scope::material, Operands::colour, {}},
    Shape{"Shininess", Scope::material, Operands::one, {}},
    Shape{"Specular", Scope::material, Operands::colour, {}},
    Shape{"Bind", Scope::channels, Operands::channels, {}},
    Shape{"Combine", Scope::texture, Operands::expression, {}},
    Shape{"ConstantColor", Scope::texture, Operands::colour, {}},
    Shape{"LightmapMode", Scope::texture, Operands::one, {}},
    Shape{"Matrix", Scope::texture, Operands::one, {}},
    Shape{"TexGen", Scope::texture, Operands::one, {}},
};

const Shape* find_shape(const Cursor& cursor, Scope scope) {
  if (!cursor.at(Token::Kind::identifier)) return nullptr;
  const auto* found = std::find_if(kShapes.begin(), kShapes.end(), [&](const Shape& shape) {
    return shape.scope == scope && same_keyword(shape.name, cursor.peek().spelling);
  });
  return found == kShapes.end() ? nullptr : found;
}

std::vector<std::string> names_of(Scope scope) {
  std::vector<std::string> names;
  for (const Shape& shape : kShapes)
    if (shape.scope == scope) names.emplace_back(shape.name);
  return names;
}

bool at_value(const Cursor& cursor) {
  return cursor.at(Token::Kind::identifier) || cursor.at(Token::Kind::number) ||
         cursor.at(Token::Kind::bracket) || cursor.at(Token::Kind::string);
}

Command::Value::Kind value_kind(Token::Kind kind) {
  switch (kind) {
    case Token::Kind::number:
      return Command::Value::Kind::number;
    case Token::Kind::string:
      return Command::Value::Kind::string;
    case Token::Kind::bracket:
      return Command::Value::Kind::property;
    case Token::Kind::punctuation:
      return Command::Value::Kind::punctuation;
    default:
      return Command::Value::Kind::identifier;
  }
}

class CommandParser {
 public:
  CommandParser(Cursor& cursor, Scope scope) : cursor_(cursor), scope_(scope) {}

  Command parse(const Shape& shape) {
    command_.name = name_of(cursor_.take());
    values_ = shape.values;
    operands(shape.operands);
    if (shape.block) block(*shape.block);
    return std::move(command_);
  }

 private:
  void take_value() {
    const Token& token = cursor_.take();
    command_.values.push_back({value_kind(token.kind), std::string(token.spelling), token.place});
  }

  // Reads a required value: if there is a command's name instead, the value is missing.
  void value() {
    if (!at_value(cursor_) || find_shape(cursor_, scope_) != nullptr)
      cursor_.fail("a value for " + command_.name.text);
    const bool numeric = values_ == Values::number || values_ == Values::stencil_number;
    // The identifier may be a command with a typing error.
    if (numeric && cursor_.at(Token::Kind::identifier)) {
      const Token& word = cursor_.peek();
      cursor_.error(word.place, "expected a number for " + command_.name.text + ", found '" +
                                    std::string(word.spelling.substr(0, 40)) + "'");
      return;
    }
    take_value();
    const Command::Value& taken = command_.values.back();
    const ValueProblem problem = value_problem(command_.name.text, values_, taken);
    if (!problem.message.empty()) cursor_.say(taken.place, problem.severity, problem.message);
  }

  bool take_comma() {
    if (!cursor_.at_punctuation(',')) return false;
    take_value();
    return true;
  }

  bool last_is_off() const {
    const Command::Value& last = command_.values.back();
    return last.kind == Command::Value::Kind::identifier && same_keyword(last.text, "Off");
  }

  void operands(Operands operands) {
    switch (operands) {
      case Operands::none:
        return;
      case Operands::one:
        return value();
      case Operands::pair:
        return pair();
      case Operands::blend:
        return blend();
      case Operands::blend_op:
        return blend_op();
      case Operands::color_mask:
        value();
        if (cursor_.at(Token::Kind::number)) take_value();
        return;
      case Operands::test:
        value();
        if (cursor_.at(Token::Kind::number) || cursor_.at(Token::Kind::bracket)) take_value();
        return;
      case Operands::colour:
        return colour();
      case Operands::channels:
        return pair();
      case Operands::expression:
        return expression();
    }
  }

  void pair() {
    value();
    take_comma();
    value();
  }

  void target() {
    if (cursor_.at(Token::Kind::number)) take_value();
  }

  void blend() {
    target();
    value();
    if (last_is_off()) return;
    value();
    if (!take_comma()) return;
    value();
    value();
  }

  void blend_op() {
    target();
    value();
    if (take_comma()) value();
  }

  void colour() {
    if (!cursor_.at_punctuation('(')) {
      value();
      while (take_comma()) value();  // Color 0, 0, 0, 0
      return;
    }
    take_value();
    do {
      if (!cursor_.at(Token::Kind::number)) cursor_.fail("a number for " + command_.name.text);
      take_value();
    } while (take_comma());
    if (!cursor_.at_punctuation(')')) cursor_.fail("',' or ')' in the colour of " + command_.name.text);
    take_value();
  }

  void expression() {
    while (at_value(cursor_) || (cursor_.at(Token::Kind::punctuation) && !cursor_.at_punctuation('{') &&
                                 !cursor_.at_punctuation('}'))) {
      if (find_shape(cursor_, scope_) != nullptr) break;
      take_value();
    }
    if (command_.values.empty()) cursor_.fail("a value for " + command_.name.text);
  }

  void block(Scope scope) {
    // SetTexture alone may omit its braces.
    if (scope == Scope::texture && !cursor_.at_punctuation('{')) return;
    cursor_.expect_mark('{', "after " + command_.name.text);
    while (!cursor_.take_punctuation('}')) {
      if (const Shape* shape = find_shape(cursor_, scope)) {
        command_.block.push_back(CommandParser(cursor_, scope).parse(*shape));
      } else if (cursor_.at(Token::Kind::identifier)) {
        skip(scope);
      } else {
        cursor_.fail("a command or '}' in the " + command_.name.text + " of line " +
                     std::to_string(command_.name.place.line));
      }
    }
  }

  void skip(Scope scope) {
    const Token word = cursor_.take();
    const std::string hint = cursor_.warns() ? near_name_hint(word.spelling, names_of(scope)) : "";
    cursor_.error(word.place, "'" + std::string(word.spelling) + "' is not a command of " +
                                  command_.name.text + (hint.empty() ? "" : ": " + hint));
    while ((at_value(cursor_) || cursor_.at_punctuation(',')) && cursor_.peek().place.line == word.place.line)
      cursor_.take();
  }

  Cursor& cursor_;
  Scope scope_;
  Values values_ = Values::anything;
  Command command_;
};

// Skips from '{' to its '}'; returns true when a program stands between.
bool skip_block(Cursor& cursor, const Token& owner) {
  const Place open = cursor.take().place;
  bool holds_program = false;
  for (std::size_t depth = 1; depth > 0;) {
    if (cursor.at_end())
      cursor.fail("'}' for the '{' of '" + std::string(owner.spelling) + "' in line " +
                  std::to_string(open.line));
    if (cursor.at_punctuation('{')) ++depth;
    if (cursor.at_punctuation('}')) --depth;
    holds_program |= cursor.at(Token::Kind::program);
    cursor.take();
  }
  return holds_program;
}

std::string unknown_command_message(const Token& word, const std::vector<std::string>& structure) {
  std::vector<std::string> known = names_of(Scope::pass);
  known.insert(known.end(), structure.begin(), structure.end());
  const std::string hint = near_name_hint(word.spelling, known);
  return "'" + std::string(word.spelling.substr(0, 40)) + "' is not a command of ShaderLab" +
         (hint.empty() ? "" : ": " + hint);
}

}  // namespace

bool at_command(const Cursor& cursor) {
  return find_shape(cursor, Scope::pass) != nullptr;
}

Command parse_command(Cursor& cursor) {
  return CommandParser(cursor, Scope::pass).parse(*find_shape(cursor, Scope::pass));
}

void skip_unknown_command(Cursor& cursor, const std::vector<std::string>& structure) {
  const Token word = cursor.take();
  const auto same_line = [&] { return cursor.peek().place.line == word.place.line; };
  while (same_line() && !at_command(cursor) &&
         (at_value(cursor) || cursor.at_punctuation(',') || cursor.at_punctuation('=')))
    cursor.take();
  const bool loses_program = cursor.at_punctuation('{') && skip_block(cursor, word);
  if (!loses_program && !cursor.warns()) return cursor.error(word.place, {});
  const std::string message = unknown_command_message(word, structure);
  if (loses_program) cursor.fail_at(word.place, message + " (and its block holds a program)");
  cursor.error(word.place, message);
}

}  // namespace penumbra::shaderlab
