// Macro expansion: a stack of inputs with a text's tokens at the bottom. It is C's, but where FXC differs:
// arguments beside ## are expanded, text in any brackets counts as one argument, and where a call has too few
// arguments, those that they expand to are counted. Internal to this folder.
#pragma once

#include <set>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

// The macros that are defined at a point of the source.
class Macros {
 public:
  bool is_defined(Spelling name) const { return name < defined_.size() && defined_[name] != 0; }
  const Definition* definition(Spelling name) const {
    return is_defined(name) ? entries_[name].definition : nullptr;
  }

  struct Known {
    const Definition* definition = nullptr;
    const std::string* file = nullptr;
  };

  // The definition and the file's name must outlive this object. Returns the definition that this one
  // replaces by another one; null if there is none.
  Known define(const Definition& definition, const std::string& file);
  void undefine(Spelling name) {
    if (is_defined(name)) defined_[name] = 0;
  }

  // Returns whether its own expansion is being read.
  bool is_busy(Spelling name) const { return entries_[name].busy; }
  void set_busy(Spelling name, bool busy) { entries_[name].busy = busy; }

  void clear();

 private:
  struct Entry : Known {
    bool busy = false;
  };

  std::vector<Entry> entries_;          // indexed by name
  std::vector<unsigned char> defined_;  // the same, for fast lookup of every name of a text
  std::vector<Spelling> names_;         // all that were ever defined
};

// What follows a text whose tokens end in the middle of a macro's call.
class Continuation {
 public:
  virtual ~Continuation() = default;
  // Calls Expansion::read_text(), or returns false at the end of the file.
  virtual bool go_on() = 0;
};

class Expansion {
 public:
  Expansion(Spellings& spellings, Macros& macros) : spellings_(spellings), macros_(macros) {}

  // Sets the bottom of the stack.
  void read_text(const Token* first, const Token* last, const Place* places);
  void continue_with(Continuation* continuation) { continuation_ = continuation; }
  const Token* position() const { return at_; }  // position in the bottom input
  const Place& place() const { return place_; }  // place of the token that was read last from the text
  void begin_directive(const Place& place) { place_ = place; }

  Token scan();
  // If a macro of that name is called here, pushes its expansion and returns true.
  bool expand(Token& name);
  // Pops the inputs that are exhausted; returns true if only the bottom is left.
  bool at_bottom();
  // Returns the expansion of these tokens alone. In a condition, `defined NAME` becomes a number.
  std::vector<Token> expanded(const Token* first, const Token* last, bool condition);
  // Collects the names that are looked up from now on.
  void record_names(std::set<Spelling>* names) { names_ = names; }
  // Ends what is read after an error.
  void clear();
  // Ends what is read, and begins to count the work again, which has a limit.
  void restart();

 private:
  using Arguments = std::vector<std::vector<Token>>;

  struct Input {
    const Token* at = nullptr;
    const Token* last = nullptr;
    const Definition* macro = nullptr;  // null for a list of tokens
    std::vector<Token> tokens{};        // the substituted body of the macro; empty where it is read in place
  };

  void pop();
  bool open_follows() const;
  Token is_defined();
  Arguments read_arguments(const Definition& macro, const Place& call);
  void check_count(const Definition& macro, std::size_t count, const Place& call) const;
  std::vector<Token> substituted(const Definition& macro, const Arguments& arguments,
                                 const Arguments& expanded);
  void join(std::vector<Token>& left, const Token* right, const Token* last);
  Token as_text(const std::vector<Token>& argument);
  Token integer(int value);

  Spellings& spellings_;
  Macros& macros_;
  std::vector<Input> inputs_;
  std::size_t floor_ = 0;  // the inputs from here on are read
  const Token* at_ = nullptr;
  const Token* last_ = nullptr;
  const Place* places_ = nullptr;  // place of the token at `at_`
  Place place_;
  Continuation* continuation_ = nullptr;
  bool in_call_ = false;  // the arguments of a call in the text are read
  std::set<Spelling>* names_ = nullptr;
  std::size_t scanned_ = 0;
  int depth_ = 0;  // depth of nested lists; at 0 the text is below the inputs
};

}  // namespace penumbra::preprocessing
