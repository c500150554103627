#include "programs/program_text.h"

#include <bit>
#include <cstdio>
#include <map>

namespace penumbra::programs {

int words(const Type& type, const Program& program) {
  int one = type.components();
  if (type.structure >= 0) {
    const Structure& structure = program.structures[type.structure];
    one = member_offset(structure, static_cast<int>(structure.members.size()));
  }
  return one * (type.length > 0 ? type.length : 1);
}

int member_offset(const Structure& structure, int member) {
  int offset = 0;
  for (int i = 0; i < member; ++i) offset += words(structure.members[i], {});
  return offset;
}

namespace {

using ExpressionKind = Expression::Kind;
using StatementKind = Statement::Kind;

const char* base_name(Base base) {
  switch (base) {
    case Base::boolean:
      return "bool";
    case Base::integer:
      return "int";
    case Base::natural:
      return "uint";
    case Base::real:
      break;
  }
  return "float";
}

// The precedence of an operator in the table of the language's reference, from the one that binds most.
int precedence(const std::string& op) {
  static const std::map<std::string, int> all{
      {"*", 10}, {"/", 10}, {"%", 10}, {"+", 9},  {"-", 9}, {"<<", 8}, {">>", 8}, {"<", 7},  {">", 7},
      {"<=", 7}, {">=", 7}, {"==", 6}, {"!=", 6}, {"&", 5}, {"^", 4},  {"|", 3},  {"&&", 2}, {"||", 1}};
  return all.at(op);
}

constexpr int kChoice = 0;
constexpr int kUnary = 11;
constexpr int kPostfix = 12;

class Printer {
 public:
  explicit Printer(const Program& program) : program_(program) {}

  std::string run() {
    for (const Structure& structure : program_.structures) print_structure(structure);
    const std::string structures = std::move(text_);
    text_.clear();
    for (const int global : program_.globals) {
      const Variable& variable = program_.variables[global];
      text_ += "static " + declaration(variable) +
               (variable.type.length > 0 ? "" : " = " + zero(variable.type)) + ";\n";
    }
    for (const Function& function : program_.functions) print_function(function);
    return structures + zero_arrays_ + text_;
  }

 private:
  std::string type_name(const Type& type) const {
    if (type.structure >= 0) return program_.structures[type.structure].name;
    std::string name = base_name(type.base);
    if (type.rows > 0) name += std::to_string(type.rows) + "x";
    if (type.columns > 0) name += std::to_string(type.columns);
    return name;
  }

  std::string declaration(const Variable& variable) const {
    return declaration(variable.type, variable.name);
  }

  std::string declaration(const Type& type, const std::string& name) const {
    return type_name(type) + " " + name + (type.length > 0 ? "[" + std::to_string(type.length) + "]" : "");
  }

  // An array of zeros is a static variable without an initialiser: glslang reads no `(float[3])0`.
  std::string zero(const Type& type) {
    if (type.length == 0) return "(" + type_name(type) + ")0";
    const std::string name =
        program_.functions.back().name + "_0_" + type_name(type) + "_" + std::to_string(type.length);
    const std::string line = "static " + declaration(type, name) + ";\n";
    if (zero_arrays_.find(line) == std::string::npos) zero_arrays_ += line;
    return name;
  }

  void print_structure(const Structure& structure) {
    text_ += "struct " + structure.name + " {";
    for (std::size_t i = 0; i < structure.members.size(); ++i)
      text_ += " " + declaration(structure.members[i], "m" + std::to_string(i)) + ";";
    text_ += " };\n";
  }

  void print_function(const Function& function) {
    text_ += (function.gives ? type_name(function.type) : "void") + " " + function.name + "(";
    std::string parameters;
    for (const int parameter : function.parameters) {
      const Variable& variable = program_.variables[parameter];
      const char* way = variable.place == Variable::Place::out     ? "out "
                        : variable.place == Variable::Place::inout ? "inout "
                                                                   : "";
      parameters += (parameters.empty() ? "" : ", ") + (way + declaration(variable));
    }
    text_ += parameters + ") {\n";
    print(function.body, "  ");
    text_ += "}\n";
  }

  void print(const std::vector<Statement>& body, const std::string& indent) {
    for (const Statement& statement : body) print(statement, indent);
  }

  void block(const std::vector<Statement>& body, const std::string& indent) {
    text_ += "{\n";
    print(body, indent + "  ");
    text_ += indent + "}";
  }

  void print(const Statement& statement, const std::string& indent) {
    const auto part = [&](std::size_t i) { return expression(statement.parts.at(i), kChoice); };
    text_ += indent;
    switch (statement.kind) {
      case StatementKind::declare: {
        const Variable& variable = program_.variables[statement.number];
        text_ +=
            declaration(variable) + " = " + (statement.parts.empty() ? zero(variable.type) : part(0)) + ";";
        break;
      }
      case StatementKind::assign:
        text_ += expression(statement.parts[0], kPostfix) + " " + statement.name + " " + part(1) + ";";
        break;
      case StatementKind::step:
        text_ += statement.count == 0 ? statement.name + part(0) + ";" : part(0) + statement.name + ";";
        break;
      case StatementKind::call:
        text_ += part(0) + ";";
        break;
      case StatementKind::branch:
        text_ += "if (" + part(0) + ") ";
        block(statement.bodies[0], indent);
        if (statement.bodies.size() > 1) {
          text_ += " else ";
          block(statement.bodies[1], indent);
        }
        break;
      case StatementKind::repeat: {
        const std::string counter = program_.variables[statement.number].name;
        text_ += "for (int " + counter + " = 0; " + counter + " < " + std::to_string(statement.count) +
                 (statement.parts.empty() ? "" : " && " + expression(statement.parts[0], 3)) + "; ++" +
                 counter + ") ";
        block(statement.bodies[0], indent);
        break;
      }
      case StatementKind::repeat_until: {
        const std::string counter = program_.variables[statement.number].name;
        text_ += "do ";
        block(statement.bodies[0], indent);
        text_ += " while (++" + counter + " < " + std::to_string(statement.count) + ");";
        break;
      }
      case StatementKind::choose:
        choose(statement, indent);
        break;
      case StatementKind::leave:
        text_ += "break;";
        break;
      case StatementKind::next:
        text_ += "continue;";
        break;
      case StatementKind::give:
        text_ += statement.parts.empty() ? "return;" : "return " + part(0) + ";";
        break;
      case StatementKind::store:
        store(statement);
        break;
    }
    text_ += "\n";
  }

  void choose(const Statement& statement, const std::string& indent) {
    text_ += "switch (" + expression(statement.parts[0], kChoice) + ") {\n";
    for (std::size_t i = 0; i < statement.bodies.size(); ++i) {
      const bool last = i == statement.labels.size();
      text_ += indent + (last ? "default" : "case " + std::to_string(statement.labels[i])) + ": ";
      block(statement.bodies[i], indent);
      text_ += " break;\n";
    }
    text_ += indent + "}";
  }

  void store(const Statement& statement) {
    const Expression& value = statement.parts[0];
    const std::string text = expression(value, kChoice);
    text_ += "Out[last + " + std::to_string(statement.number) + "] = ";
    text_ += value.type.base == Base::boolean   ? "(" + text + ") ? 1u : 0u;"
             : value.type.base == Base::natural ? text + ";"
                                                : "asuint(" + text + ");";
  }

  std::string literal(const Expression& value) const {
    switch (value.type.base) {
      case Base::boolean:
        return value.bits != 0 ? "true" : "false";
      case Base::integer:
        return std::to_string(static_cast<std::int32_t>(value.bits));
      case Base::natural:
        return std::to_string(value.bits) + "u";
      case Base::real:
        break;
    }
    char text[32];
    std::snprintf(text, sizeof(text), "%.6f", static_cast<double>(std::bit_cast<float>(value.bits)));
    return text;
  }

  static std::string swizzle(const Expression& value) {
    std::string text;
    for (const int pick : value.picks)
      text += value.parts[0].type.is_matrix() ? "_m" + std::to_string(pick / 4) + std::to_string(pick % 4)
                                              : std::string(1, "xyzw"[pick]);
    return text;
  }

  std::string list(const Expression& of) {
    std::string text;
    for (const Expression& part : of.parts) text += (text.empty() ? "" : ", ") + expression(part, kChoice);
    return text;
  }

  std::string arguments(const Expression& of) { return "(" + list(of) + ")"; }

  // The expression stands in parentheses if it binds less than `around`.
  std::string expression(const Expression& value, int around) {
    int own = kPostfix;
    std::string text;
    switch (value.kind) {
      case ExpressionKind::literal:
        text = literal(value);
        if (text[0] == '-') own = kUnary;
        break;
      case ExpressionKind::input:
        text = "In[first + " + std::to_string(value.number) + "]";
        if (value.type.base != Base::natural)
          text = (value.type.base == Base::real ? "asfloat(" : "asint(") + text + ")";
        break;
      case ExpressionKind::variable:
        text = program_.variables[value.number].name;
        break;
      case ExpressionKind::member:
        text = expression(value.parts[0], kPostfix) + ".m" + std::to_string(value.number);
        break;
      case ExpressionKind::element:
        text = expression(value.parts[0], kPostfix) + "[" + expression(value.parts[1], kChoice) + "]";
        break;
      case ExpressionKind::swizzle:
        text = expression(value.parts[0], kPostfix) + "." + swizzle(value);
        break;
      case ExpressionKind::unary:
        own = kUnary;
        text = value.name + expression(value.parts[0], kPostfix);
        break;
      case ExpressionKind::binary:
        own = precedence(value.name);
        text = expression(value.parts[0], own) + " " + value.name + " " + expression(value.parts[1], own + 1);
        break;
      case ExpressionKind::choice:
        own = kChoice;
        text = expression(value.parts[0], 1) + " ? " + expression(value.parts[1], 1) + " : " +
               expression(value.parts[2], 1);
        break;
      case ExpressionKind::cast:
        own = value.type.length > 0 ? own : kUnary;
        text = value.type.length > 0
                   ? zero(value.type)  // only 0 is cast to an array
                   : "(" + type_name(value.type) + ")" + expression(value.parts[0], kPostfix);
        break;
      case ExpressionKind::construct:
        text = value.type.is_number() ? type_name(value.type) + arguments(value) : "{ " + list(value) + " }";
        break;
      case ExpressionKind::intrinsic:
        text = value.name + arguments(value);
        break;
      case ExpressionKind::call:
        text = program_.functions[value.number].name + arguments(value);
        break;
    }
    return own < around ? "(" + text + ")" : text;
  }

  const Program& program_;
  std::string text_;
  std::string zero_arrays_;
};

}  // namespace

std::string program_text(const Program& program) {
  return Printer(program).run();
}

std::string shader_text(const std::vector<const Program*>& programs) {
  std::string text =
      "StructuredBuffer<uint> In; RWStructuredBuffer<uint> Out; static uint first; static uint last;\n";
  std::string calls;
  const std::string outputs = std::to_string(kOutputs);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    text += program_text(*programs[i]);
    calls += "  last = (at.x * " + std::to_string(programs.size()) + "u + " + std::to_string(i) + "u) * " +
             outputs + "u; " + programs[i]->functions.back().name + "();\n";
  }
  return text + "[numthreads(1, 1, 1)] void Main(uint3 at : SV_GroupID) {\n  first = at.x * " +
         std::to_string(kInputs) + "u;\n" + calls + "}\n";
}

}  // namespace penumbra::programs
