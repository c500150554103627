#include "programs/random_program.h"

#include "programs/build.h"
#include "programs/random_expression.h"

namespace penumbra::programs {

namespace {

using Kind = Statement::Kind;
using Place = Variable::Place;

class RandomProgram {
 public:
  RandomProgram(std::uint32_t seed, const std::string& prefix)
      : chance_(seed), scope_(program_), expressions_(program_, scope_, chance_) {
    program_.prefix = prefix;
  }

  Program run() {
    scope_.open();
    for (int i = chance_.below(3); i > 0; --i) structure();
    for (int i = chance_.below(3); i > 0; --i)
      program_.globals.push_back(
          scope_.declare({program_.prefix + "g" + std::to_string(i), type(), Place::file}));
    for (int i = chance_.below(4); i > 0; --i) function();
    main();
    return std::move(program_);
  }

 private:
  Type number_type() {
    const Base base = static_cast<Base>(std::min(chance_.below(5), 3));
    const int way = chance_.below(10);
    if (way < 4) return scalar(base);
    if (way < 8 || base != Base::real) return vector(base, chance_.between(2, 4));
    return {base, chance_.between(2, 4), chance_.between(2, 4)};
  }

  Type type() {
    if (!program_.structures.empty() && chance_.percent(15))
      return {Base::real, 0, 0, chance_.percent(25) ? 2 : 0,
              chance_.below(static_cast<int>(program_.structures.size()))};
    Type type = number_type();
    if (chance_.percent(15)) type.length = chance_.between(2, 4);
    return type;
  }

  void structure() {
    Structure made{program_.prefix + "S" + std::to_string(program_.structures.size()), {}};
    for (int i = chance_.between(1, 4); i > 0; --i) {
      made.members.push_back(number_type());
      if (chance_.percent(20)) made.members.back().length = chance_.between(2, 3);
    }
    program_.structures.push_back(std::move(made));
  }

  // A name of the function; sometimes one that hides another of an outer block.
  std::string local_name() {
    const std::vector<int> visible = scope_.visible();
    if (scope_.depth() > 3 && !visible.empty() && chance_.percent(10)) {
      const std::string& name = program_.variables[chance_.of(visible)].name;
      if (!scope_.declares_here(name)) return name;
    }
    return "v" + std::to_string(next_name_++);
  }

  void function() {
    const auto number = static_cast<int>(program_.functions.size());
    Function made;
    made.name = program_.prefix + "F" + std::to_string(chance_.percent(30) ? 0 : number);
    made.gives = chance_.percent(75);
    made.type = type();
    made.type.length = 0;
    writes_outside_ = false;
    in_function_ = &made;
    scope_.open();
    std::vector<Statement> body;
    for (int i = chance_.below(4); i > 0; --i) parameter(made, body);
    if (overloads(made)) made.name = program_.prefix + "F" + std::to_string(number) + "x";
    statements(body, chance_.between(1, 3), 1);
    if (made.gives) body.push_back(give(made));
    scope_.close();
    made.body = std::move(body);
    program_.functions.push_back(std::move(made));
    if (!writes_outside_) expressions_.pure_functions.push_back(number);
  }

  void parameter(Function& function, std::vector<Statement>& body) {
    Variable made{local_name(), type(), Place::in};
    if (chance_.percent(30)) made.place = chance_.percent(50) ? Place::out : Place::inout;
    const int number = scope_.declare(made);
    function.parameters.push_back(number);
    if (made.place == Place::out || made.place == Place::inout) writes_outside_ = true;
    if (made.place == Place::out) {  // nothing is read from it before it is written
      Statement first{Kind::assign, "="};
      first.parts = {build::variable(number, made.type), zero(made.type)};
      body.push_back(std::move(first));
    }
  }

  static Expression zero(const Type& type) { return build::cast(type, build::number(Base::integer, 0)); }

  // Overloads differ in their number of parameters, so that no conversion decides between them.
  bool overloads(const Function& made) const {
    for (const Function& other : program_.functions)
      if (other.name == made.name && other.parameters.size() == made.parameters.size()) return true;
    return false;
  }

  Statement give(const Function& function) {
    Statement made{Kind::give};
    if (function.gives) made.parts.push_back(expressions_.convertible(function.type, 1));
    return made;
  }

  void main() {
    Function made;
    made.name = program_.prefix + "Main";
    in_function_ = &made;
    scope_.open();
    std::vector<Statement> body;
    for (int i = chance_.between(1, 3); i > 0; --i) body.push_back(declare());
    statements(body, chance_.between(3, 6), 2);
    for (int i = 0; i < kOutputs; ++i) body.push_back(store(i));
    scope_.close();
    made.body = std::move(body);
    program_.functions.push_back(std::move(made));
  }

  Statement store(int number) {
    Statement made{Kind::store};
    made.number = number;
    const Type stored = scalar(static_cast<Base>(std::min(chance_.below(5), 3)));
    if (chance_.percent(10)) {
      made.parts.push_back(expressions_.rounded());
    } else if (std::optional<Expression> place = expressions_.place(stored, false);
               place && chance_.percent(80)) {
      made.parts.push_back(*std::move(place));
    } else {
      made.parts.push_back(expressions_.of(stored, 2));
    }
    return made;
  }

  bool mentions(const Expression& expression, const std::string& name) const {
    if (expression.kind == Expression::Kind::variable && program_.variables[expression.number].name == name)
      return true;
    for (const Expression& part : expression.parts)
      if (mentions(part, name)) return true;
    return false;
  }

  Statement declare() {
    Variable variable{local_name(), type(), Place::local};
    Statement made{Kind::declare};
    if (!variable.type.is_number() && chance_.percent(60)) {
      made.parts.push_back(expressions_.construct(variable.type, 1));
    } else if (chance_.percent(85)) {
      made.parts.push_back(expressions_.convertible(variable.type, 2));
    }
    // Compilers do not agree on which of two variables of a name its own initialiser means.
    if (!made.parts.empty() && mentions(made.parts[0], variable.name))
      variable.name = "v" + std::to_string(next_name_++);
    made.number = scope_.declare(variable);
    return made;
  }

  void statements(std::vector<Statement>& body, int count, int depth) {
    for (int i = 0; i < count; ++i) statement(body, depth);
  }

  std::vector<Statement> block(int depth) {
    std::vector<Statement> body;
    scope_.open();
    statements(body, chance_.between(1, 3), depth);
    scope_.close();
    return body;
  }

  void statement(std::vector<Statement>& body, int depth) {
    const int way = chance_.below(20);
    if (way < 5 || (depth == 0 && way >= 12)) {
      body.push_back(declare());
    } else if (way < 12) {
      assignment(body);
    } else if (way < 13) {
      step(body);
    } else if (way < 14) {
      call(body);
    } else if (way < 17) {
      branch(body, depth - 1);
    } else if (way < 19) {
      repeat(body, depth - 1);
    } else {
      choose(body, depth - 1);
    }
  }

  // A place to write to, which is noted when it lies outside of the function.
  std::optional<Expression> target(const Type& type) {
    std::optional<Expression> found = expressions_.place(type, true);
    if (!found) return found;
    const Expression* root = &*found;
    while (root->kind != Expression::Kind::variable) root = root->parts.data();
    if (program_.variables[root->number].place == Place::file) writes_outside_ = true;
    return found;
  }

  void assignment(std::vector<Statement>& body) {
    static const std::vector<std::string> of_wholes{"+=", "-=", "*=", "&=", "|=", "^="};
    std::optional<Expression> to = target(chance_.percent(85) ? number_type() : type());
    if (!to) return;
    Statement made{Kind::assign, "="};
    const Type type = to->type;
    Expression value = expressions_.convertible(type, 2);
    const bool compound = type.is_number() && type.base != Base::boolean && chance_.percent(30);
    if (compound) {
      value = expressions_.of(chance_.percent(70) ? type : scalar(type.base), 2);
      made.name = type.base == Base::real ? (chance_.percent(50) ? "+=" : "-=") : chance_.of(of_wholes);
    }
    made.parts = {*std::move(to), std::move(value)};
    body.push_back(std::move(made));
  }

  void step(std::vector<Statement>& body) {
    std::optional<Expression> to = target(scalar(static_cast<Base>(chance_.between(1, 3))));
    if (!to) return;
    Statement made{Kind::step, chance_.percent(50) ? "++" : "--"};
    made.count = chance_.below(2);
    made.parts = {*std::move(to)};
    body.push_back(std::move(made));
  }

  void call(std::vector<Statement>& body) {
    if (program_.functions.empty()) return declare_at(body);
    const int number = chance_.below(static_cast<int>(program_.functions.size()));
    const Function& function = program_.functions[number];
    Expression made;
    made.kind = Expression::Kind::call;
    made.number = number;
    made.type = function.type;
    std::vector<int> used;
    for (const int parameter : function.parameters) {
      const Variable variable = program_.variables[parameter];
      if (variable.place == Place::in) {
        made.parts.push_back(expressions_.argument(variable.type, 1));
        continue;
      }
      // Each argument has a variable of its own: what two that overlap hold afterwards is left open.
      Variable given{"v" + std::to_string(next_name_++), variable.type, Place::local};
      Statement declaration{Kind::declare};
      declaration.parts.push_back(expressions_.of(variable.type, 1));
      declaration.number = scope_.declare(given);
      made.parts.push_back(build::variable(declaration.number, variable.type));
      body.push_back(std::move(declaration));
    }
    bool pure = false;
    for (const int known : expressions_.pure_functions) pure = pure || known == number;
    if (!pure) writes_outside_ = true;
    if (!function.gives || chance_.percent(20)) {
      Statement called{Kind::call};
      called.parts.push_back(std::move(made));
      body.push_back(std::move(called));
      return;
    }
    Statement result{Kind::declare};
    result.number = scope_.declare({"v" + std::to_string(next_name_++), function.type, Place::local});
    result.parts.push_back(std::move(made));
    body.push_back(std::move(result));
  }

  void declare_at(std::vector<Statement>& body) { body.push_back(declare()); }

  void branch(std::vector<Statement>& body, int depth) {
    Statement made{Kind::branch};
    made.parts.push_back(expressions_.of(scalar(chance_.percent(85) ? Base::boolean : Base::integer), 2));
    made.bodies.push_back(block(depth));
    leave(made.bodies.back());
    if (chance_.percent(50)) made.bodies.push_back(block(depth));
    body.push_back(std::move(made));
  }

  // The body ends with break, continue or an early return, at the end of a branch.
  void leave(std::vector<Statement>& body) {
    if (in_loop_ && chance_.percent(25)) {
      body.push_back({chance_.percent(50) ? Kind::leave : Kind::next});
    } else if (in_function_->name.find("Main") == std::string::npos && chance_.percent(20)) {
      body.push_back(give(*in_function_));
    }
  }

  void repeat(std::vector<Statement>& body, int depth) {
    const bool until = chance_.percent(30);
    Statement made{until ? Kind::repeat_until : Kind::repeat};
    made.count = chance_.between(1, 4);
    const bool outer = in_loop_;
    Variable counter{"v" + std::to_string(next_name_++), scalar(Base::integer), Place::local, false};
    if (until) {
      Statement declaration{Kind::declare};
      declaration.number = made.number = scope_.declare(counter);
      body.push_back(std::move(declaration));
    }
    scope_.open();
    if (!until) {
      made.number = scope_.declare(counter);
      if (chance_.percent(30)) made.parts.push_back(expressions_.of(scalar(Base::boolean), 2));
    }
    in_loop_ = true;
    made.bodies.push_back(block(depth));
    in_loop_ = outer;
    scope_.close();
    body.push_back(std::move(made));
  }

  void choose(std::vector<Statement>& body, int depth) {
    Statement made{Kind::choose};
    made.parts.push_back(build::binary("&", scalar(Base::integer), expressions_.of(scalar(Base::integer), 2),
                                       build::number(Base::integer, 3)));
    const bool outer = in_loop_;
    in_loop_ = false;  // a break in it would leave the switch
    for (int i = chance_.between(1, 3); i > 0; --i) {
      made.labels.push_back(static_cast<int>(made.labels.size()) + chance_.below(2) * 2);
      for (std::size_t k = 0; k + 1 < made.labels.size(); ++k)
        if (made.labels[k] == made.labels.back()) made.labels.back() = 7 + static_cast<int>(k);
      made.bodies.push_back(block(depth));
    }
    made.bodies.push_back(block(depth));
    in_loop_ = outer;
    body.push_back(std::move(made));
  }

  Program program_;
  Chance chance_;
  Scope scope_;
  RandomExpression expressions_;
  const Function* in_function_ = nullptr;
  bool in_loop_ = false;
  bool writes_outside_ = false;
  int next_name_ = 0;
};

}  // namespace

Program random_program(std::uint32_t seed, const std::string& prefix) {
  return RandomProgram(seed, prefix).run();
}

}  // namespace penumbra::programs
