#include "programs/interpreter.h"

#include <optional>

#include "programs/arithmetic.h"

namespace penumbra::programs {

namespace {

using Word = std::uint32_t;
using Words = std::vector<Word>;

// The words of a variable that an expression names.
struct Place {
  int variable = 0;
  std::vector<int> words;
  Type type;
};

enum class Flow { on, leave, next, give };

class Interpreter {
 public:
  Interpreter(const Program& program, const Words& inputs)
      : program_(program), inputs_(inputs), outputs_(kOutputs, 0), storage_(program.variables.size()) {}

  Words run() {
    for (const int global : program_.globals) storage_[global] = zeros(program_.variables[global].type);
    execute(program_.functions.back().body);
    return std::move(outputs_);
  }

 private:
  Words zeros(const Type& type) const { return Words(static_cast<std::size_t>(words(type, program_)), 0); }

  Flow execute(const std::vector<Statement>& body) {
    for (const Statement& statement : body) {
      const Flow flow = execute(statement);
      if (flow != Flow::on) return flow;
    }
    return Flow::on;
  }

  Flow execute(const Statement& statement) {
    constexpr int most_steps = 20000;
    if (++steps_ > most_steps) throw Unfit("too long");
    using Kind = Statement::Kind;
    switch (statement.kind) {
      case Kind::declare:
        declare(statement);
        return Flow::on;
      case Kind::assign:
        assign(statement);
        return Flow::on;
      case Kind::step: {
        const Place place = place_of(statement.parts[0]);
        const Value one{scalar(Base::integer), {1}};
        write(place, convert(binary(statement.name.substr(1), read(place), one), place.type));
        return Flow::on;
      }
      case Kind::call:
        evaluate(statement.parts[0]);
        return Flow::on;
      case Kind::branch:
        if (condition(statement.parts[0])) return execute(statement.bodies[0]);
        return statement.bodies.size() > 1 ? execute(statement.bodies[1]) : Flow::on;
      case Kind::repeat:
        return repeat(statement);
      case Kind::repeat_until:
        return repeat_until(statement);
      case Kind::choose:
        return execute(chosen(statement));
      case Kind::leave:
        return Flow::leave;
      case Kind::next:
        return Flow::next;
      case Kind::give:
        if (!statement.parts.empty()) given_ = evaluate(statement.parts[0]);
        return Flow::give;
      case Kind::store:
        outputs_.at(statement.number) = evaluate(statement.parts[0]).words.at(0);
        return Flow::on;
    }
    return Flow::on;
  }

  void declare(const Statement& statement) {
    const Type& type = program_.variables[statement.number].type;
    storage_[statement.number] =
        statement.parts.empty() ? zeros(type) : assignable(evaluate(statement.parts[0]), type).words;
  }

  Value assignable(Value value, const Type& to) const {
    return to.is_number() ? convert(value, to) : std::move(value);
  }

  void assign(const Statement& statement) {
    Value value = evaluate(statement.parts[1]);
    const Place place = place_of(statement.parts[0]);
    if (statement.name != "=")
      value = binary(statement.name.substr(0, statement.name.size() - 1), read(place), value);
    write(place, assignable(value, place.type));
  }

  Flow repeat(const Statement& statement) {
    Words& counter = storage_[statement.number];
    for (counter = {0}; counter.at(0) < static_cast<Word>(statement.count); ++counter.at(0)) {
      if (!statement.parts.empty() && !condition(statement.parts[0])) break;
      const Flow flow = execute(statement.bodies[0]);
      if (flow == Flow::give) return flow;
      if (flow == Flow::leave) break;
    }
    return Flow::on;
  }

  Flow repeat_until(const Statement& statement) {
    Words& counter = storage_[statement.number];
    do {
      const Flow flow = execute(statement.bodies[0]);
      if (flow == Flow::give) return flow;
      if (flow == Flow::leave) break;
    } while (++counter.at(0) < static_cast<Word>(statement.count));
    return Flow::on;
  }

  const std::vector<Statement>& chosen(const Statement& statement) {
    const auto value = static_cast<std::int32_t>(evaluate(statement.parts[0]).words.at(0));
    for (std::size_t i = 0; i < statement.labels.size(); ++i)
      if (statement.labels[i] == value) return statement.bodies[i];
    return statement.bodies.back();
  }

  bool condition(const Expression& expression) {
    return convert(evaluate(expression), scalar(Base::boolean)).words.at(0) != 0;
  }

  Place place_of(const Expression& expression) {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::variable) {
      Place whole{expression.number, {}, expression.type};
      for (int i = 0; i < words(expression.type, program_); ++i) whole.words.push_back(i);
      return whole;
    }
    const Place of = place_of(expression.parts.at(0));
    Place part{of.variable, {}, expression.type};
    if (expression.kind == Kind::swizzle) {
      for (const int pick : expression.picks)
        part.words.push_back(of.words.at(of.type.is_matrix() ? pick / 4 * of.type.columns + pick % 4 : pick));
      return part;
    }
    int first = 0;
    const int size = words(expression.type, program_);
    if (expression.kind == Kind::member) {
      first = member_offset(program_.structures[of.type.structure], expression.number);
    } else {
      first = static_cast<int>(evaluate(expression.parts[1]).words.at(0)) * size;
    }
    if (first < 0 || first + size > static_cast<int>(of.words.size())) throw Unfit("index");
    part.words.assign(of.words.begin() + first, of.words.begin() + first + size);
    return part;
  }

  Value read(const Place& place) const {
    Value value{place.type, {}};
    for (const int word : place.words) value.words.push_back(storage_[place.variable].at(word));
    return value;
  }

  void write(const Place& place, const Value& value) {
    for (std::size_t i = 0; i < place.words.size(); ++i)
      storage_[place.variable].at(place.words[i]) = value.words.at(i);
  }

  Value evaluate(const Expression& expression) {
    using Kind = Expression::Kind;
    switch (expression.kind) {
      case Kind::literal:
        return {expression.type, {expression.bits}};
      case Kind::input:
        return {expression.type, {inputs_.at(expression.number)}};
      case Kind::variable:
      case Kind::member:
      case Kind::element:
        return is_place(expression) ? read(place_of(expression)) : part(expression);
      case Kind::swizzle:
        return swizzle(evaluate(expression.parts[0]), expression);
      case Kind::unary:
        return unary(expression.name, evaluate(expression.parts[0]));
      case Kind::binary: {
        const Value left = evaluate(expression.parts[0]);
        return binary(expression.name, left, evaluate(expression.parts[1]));
      }
      case Kind::choice: {
        const Value c = evaluate(expression.parts[0]);
        const Value yes = evaluate(expression.parts[1]);
        return choose(c, yes, evaluate(expression.parts[2]));
      }
      case Kind::cast:
        // Only 0 is cast to a type that is no number.
        if (!expression.type.is_number()) return {expression.type, zeros(expression.type)};
        return convert(evaluate(expression.parts[0]), expression.type);
      case Kind::construct:
        return construct(expression);
      case Kind::intrinsic: {
        std::vector<Value> arguments;
        for (const Expression& argument : expression.parts) arguments.push_back(evaluate(argument));
        return intrinsic(expression.name, expression.type, arguments);
      }
      case Kind::call:
        return call(expression);
    }
    return {};
  }

  static bool is_place(const Expression& expression) {
    return expression.kind == Expression::Kind::variable ||
           (!expression.parts.empty() && expression.kind <= Expression::Kind::swizzle &&
            is_place(expression.parts[0]));
  }

  // A member or element of a value that is no variable.
  Value part(const Expression& expression) {
    const Value of = evaluate(expression.parts[0]);
    const int size = words(expression.type, program_);
    const int first = expression.kind == Expression::Kind::member
                          ? member_offset(program_.structures[of.type.structure], expression.number)
                          : static_cast<int>(evaluate(expression.parts[1]).words.at(0)) * size;
    if (first < 0 || first + size > static_cast<int>(of.words.size())) throw Unfit("index");
    return {expression.type, Words(of.words.begin() + first, of.words.begin() + first + size)};
  }

  static Value swizzle(const Value& of, const Expression& expression) {
    Value result{expression.type, {}};
    for (const int pick : expression.picks)
      result.words.push_back(of.words.at(of.type.is_matrix() ? pick / 4 * of.type.columns + pick % 4 : pick));
    return result;
  }

  Value construct(const Expression& expression) {
    Value result{expression.type, {}};
    for (const Expression& argument : expression.parts) {
      const Value value = evaluate(argument);
      const bool number = expression.type.is_number();
      const Value converted = number ? convert(value, value.type.of_base(expression.type.base)) : value;
      result.words.insert(result.words.end(), converted.words.begin(), converted.words.end());
    }
    return result;
  }

  Value call(const Expression& expression) {
    const Function& function = program_.functions[expression.number];
    std::vector<std::optional<Place>> places(expression.parts.size());
    // Values of all arguments are made before the first is stored, as one may call the same function.
    std::vector<Value> values;
    for (std::size_t i = 0; i < expression.parts.size(); ++i) {
      const Variable& parameter = program_.variables[function.parameters[i]];
      const bool copied_back =
          parameter.place == Variable::Place::out || parameter.place == Variable::Place::inout;
      if (copied_back) places[i] = place_of(expression.parts[i]);
      const Value value = copied_back ? read(*places[i]) : evaluate(expression.parts[i]);
      values.push_back(assignable(value, parameter.type));
    }
    for (std::size_t i = 0; i < values.size(); ++i)
      storage_[function.parameters[i]] = std::move(values[i].words);
    given_ = {};
    execute(function.body);
    const Value given = function.gives ? assignable(given_, function.type) : Value{};
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i]) continue;
      const Value back{program_.variables[function.parameters[i]].type, storage_[function.parameters[i]]};
      write(*places[i], assignable(back, places[i]->type));
    }
    return given;
  }

  const Program& program_;
  const Words& inputs_;
  Words outputs_;
  std::vector<Words> storage_;  // storage of each variable; no function is entered twice at a time
  Value given_;
  int steps_ = 0;
};

}  // namespace

std::vector<std::uint32_t> run(const Program& program, const std::vector<std::uint32_t>& inputs) {
  return Interpreter(program, inputs).run();
}

}  // namespace penumbra::programs
