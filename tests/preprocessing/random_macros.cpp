#include "preprocessing/random_macros.h"

#include <array>
#include <random>
#include <string_view>

namespace penumbra::preprocessing {

namespace {

constexpr std::array<const char*, 8> names{"A", "B", "C", "D", "F", "G", "H", "AB"};
constexpr std::array<const char*, 6> others{"x", "y", "half", "1", "0x2", "3.5f"};
constexpr std::array<const char*, 9> marks{"+", ";", "<", "==", "[", "]", "{", "}", ","};
constexpr std::array<const char*, 7> gaps{" ", " ", "", "  ", "\t", " /* c */ ", " \\\n "};
constexpr std::array<const char*, 8> operators{"+", "-", "*", "<", "==", "&&", "||", "&"};

class Source {
 public:
  explicit Source(std::uint32_t seed) : random_(seed) {}

  std::string run() {
    for (std::uint32_t lines = 4 + below(24); lines > 0; --lines) line(0);
    return out_;
  }

 private:
  // The numbers do not come from the standard library's distributions, which differ from machine to machine.
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  template <std::size_t size>
  const char* one_of(const std::array<const char*, size>& list) {
    return list[below(size)];
  }

  void gap(bool needed) {
    const char* const chosen = one_of(gaps);
    out_ += *chosen == '\0' && needed ? " " : chosen;
  }

  // F, G and H take one, two and no arguments wherever they are defined with any.
  static std::size_t parameters_of(char name) { return name == 'F' ? 1 : name == 'G' ? 2 : 0; }
  static bool has_list(const std::string& name) { return name == "F" || name == "G" || name == "H"; }

  void call(const std::string& name, int depth) {
    out_ += name;
    if (below(12) == 0) {  // this is no call after all
      out_ += " ;";
      return;
    }
    if (below(4) == 0) gap(false);
    if (in_text_ && below(20) == 0) out_ += '\n';
    out_ += '(';
    for (std::size_t i = 0; i < parameters_of(name.front()); ++i) {
      if (i > 0) out_ += ',';
      if (i > 0) {  // may be joined by ##, before which FXC expands arguments and C does not
        out_ += one_of(others);
        continue;
      }
      if (below(10) != 0 || parameters_of(name.front()) == 1) tokens(1 + below(3), depth + 1);
      if (in_text_ && below(20) == 0) out_ += '\n';
    }
    out_ += ')';
  }

  void token(int depth) {
    const std::uint32_t choice = below(10);
    if (choice < 4) {
      const std::string name = one_of(names);
      if (has_list(name) && depth < 4) return call(name, depth);
      out_ += has_list(name) ? "z" : name;
      return;
    }
    if (choice < 7) {
      out_ += one_of(others);
    } else if (choice == 7 && depth < 4) {
      out_ += '(';
      tokens(below(4), depth + 1);
      out_ += ')';
    } else {
      const char* const mark = one_of(marks);
      // FXC takes text in brackets of any kind as one argument, C only in round ones.
      const bool apart = std::string_view(",{}[]").find(*mark) != std::string_view::npos;
      out_ += depth > 0 && apart ? "." : mark;
    }
  }

  void tokens(std::uint32_t count, int depth) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > 0) gap(true);
      token(depth);
    }
  }

  void body(const std::string& name) {
    const bool parameters = name == "F" || name == "G";
    in_text_ = false;
    for (std::uint32_t count = below(6); count > 0; --count) {
      const std::uint32_t choice = below(9);
      out_ += ' ';
      if (parameters && choice < 3) {
        out_ += name == "G" && choice == 0 ? "q" : "p";
      } else if (choice == 3) {
        out_.append("x").append(below(2) == 0 ? "##" : " ## ").append(name == "G" ? "q" : "y");
      } else if (choice == 4) {
        out_.append(one_of(names)).append("##").append(one_of(names));
      } else {
        token(3);
      }
    }
    in_text_ = true;
  }

  void definition() {
    const std::string name = one_of(names);
    if (below(8) != 0) out_.append("#undef ").append(name).append("\n");
    out_.append("#define ").append(name);
    if (name == "F") out_ += "(p)";
    if (name == "G") out_ += below(2) == 0 ? "(p,q)" : "( p , q )";
    if (name == "H") out_ += "()";
    body(name);
    out_ += '\n';
  }

  void value(int depth) {
    const std::uint32_t choice = below(6);
    if (choice == 0) {
      out_.append("defined(").append(one_of(names)).append(")");
    } else if (choice == 1) {
      out_.append("!defined ").append(one_of(names));
    } else if (choice == 2) {
      out_ += std::array<const char*, 5>{"A", "B", "C", "D", "AB"}[below(5)];
    } else if (choice == 3 && depth < 3) {
      out_ += below(2) == 0 ? "-(" : "(";
      expression(depth + 1);
      out_ += ')';
    } else {
      out_ += std::array<const char*, 5>{"0", "1", "2", "0x10", "017"}[below(5)];
    }
  }

  void expression(int depth) {
    value(depth);
    for (std::uint32_t more = below(3); more > 0; --more) {
      out_.append(" ").append(one_of(operators)).append(" ");
      value(depth);
    }
  }

  void condition(int depth) {
    const std::uint32_t choice = below(3);
    if (choice == 0) {
      out_ += "#if ";
      expression(0);
    } else {
      out_.append(choice == 1 ? "#ifdef " : "#ifndef ").append(one_of(names));
    }
    out_ += '\n';
    lines(depth);
    if (below(3) == 0) {
      out_ += "#elif ";
      expression(0);
      out_ += '\n';
      lines(depth);
    }
    if (below(2) == 0) {
      out_ += "#else\n";
      lines(depth);
    }
    out_ += "#endif\n";
  }

  void lines(int depth) {
    for (std::uint32_t count = below(4); count > 0; --count) line(depth + 1);
  }

  void line(int depth) {
    const std::uint32_t choice = below(10);
    if (choice < 3) return definition();
    if (choice == 3 && depth < 3) return condition(depth);
    if (choice == 4) out_ += std::array<const char*, 3>{"// A F(1)\n", "/* B\n */", "\n"}[below(3)];
    if (below(2) == 0) gap(false);
    tokens(below(7), 0);
    out_ += '\n';
  }

  std::mt19937 random_;
  std::string out_;
  bool in_text_ = true;
};

}  // namespace

std::string random_macros(std::uint32_t seed) {
  return Source(seed).run();
}

}  // namespace penumbra::preprocessing
