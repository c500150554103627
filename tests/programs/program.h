// A program in the part of HLSL that random programs are made of, as a tree: printed for the device
// (program_text.h) and worked out by the rules of the language in C++ (interpreter.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::programs {

enum class Base { boolean, integer, natural, real };  // bool, int, uint, float: in the order of promotion

struct Type {
  Base base = Base::real;
  int rows = 0;        // rows of a matrix; 0 for other types
  int columns = 0;     // columns of a matrix or vector; 0 for a scalar
  int length = 0;      // length of an array; 0 for other types
  int structure = -1;  // index into Program::structures; -1: a number

  bool operator==(const Type&) const = default;
  bool is_matrix() const { return rows > 0; }
  bool is_vector() const { return rows == 0 && columns > 0; }
  bool is_scalar() const { return columns == 0 && is_number(); }
  bool is_number() const { return length == 0 && structure < 0; }
  // The number of components of a number.
  int components() const { return (rows > 0 ? rows : 1) * (columns > 0 ? columns : 1); }
  Type of_base(Base other) const { return {other, rows, columns, length, structure}; }
  Type element() const { return {base, rows, columns, 0, structure}; }  // element of an array
};

inline Type scalar(Base base) {
  return {base};
}
inline Type vector(Base base, int size) {
  return {base, 0, size};
}

struct Variable {
  enum class Place { local, in, out, inout, file };  // `file`: a static variable of the file
  std::string name;
  Type type;
  Place place = Place::local;
  bool writable = true;  // a loop's counter is not
};

struct Structure {
  std::string name;
  std::vector<Type> members;  // called m0, m1, ...; no structures in them
};

struct Expression {
  enum class Kind {
    literal,    // bits
    input,      // number: which of the words that the program is given
    variable,   // number
    member,     // number; of parts[0]
    element,    // of parts[0], an array, vector or matrix, at parts[1]
    swizzle,    // picks; of parts[0]: components, of a matrix row * 4 + column
    unary,      // name: - ! ~
    binary,     // name
    choice,     // parts[0] ? parts[1] : parts[2]
    cast,       // (type)parts[0]
    construct,  // type(parts...)
    intrinsic,  // name
    call        // number: of the function
  };
  Kind kind = Kind::literal;
  Type type;
  std::string name{};
  int number = 0;
  std::uint32_t bits = 0;
  std::vector<int> picks{};
  std::vector<Expression> parts{};
};

struct Statement {
  enum class Kind {
    declare,  // variable number, initialised with parts[0] if there is one
    assign,   // name ("=", "+=", ...): parts[0] is the target
    step,     // name ("++", "--") on parts[0], in front or behind
    call,     // parts[0]
    branch,   // if (parts[0]) bodies[0] else bodies[1]
    repeat,   // for (int number = 0; number < count && parts[0]; ++number) bodies[0]; no parts: no condition
    repeat_until,  // do bodies[0] while (++number < count), number declared before
    choose,        // switch (parts[0]) with labels; the last body is default's
    leave,         // break
    next,          // continue
    give,          // return parts[0], or nothing
    store          // word `number` of the output = parts[0], a scalar
  };
  Kind kind = Kind::declare;
  std::string name{};
  int number = 0;
  int count = 0;
  std::vector<Expression> parts{};
  std::vector<std::vector<Statement>> bodies{};
  std::vector<int> labels{};
};

struct Function {
  std::string name;
  bool gives = false;  // whether it returns `type`
  Type type;
  std::vector<int> parameters;  // variables
  std::vector<Statement> body;
};

struct Program {
  std::string prefix;  // prefix of the names at file scope
  std::vector<Structure> structures;
  std::vector<Variable> variables;
  std::vector<int> globals;         // static variables, zero at the start
  std::vector<Function> functions;  // each calls only those before it; the last is the program
};

inline constexpr int kInputs = 12;   // words
inline constexpr int kOutputs = 10;  // words

// Words that a value takes, one for each component.
int words(const Type& type, const Program& program);
int member_offset(const Structure& structure, int member);

}  // namespace penumbra::programs
