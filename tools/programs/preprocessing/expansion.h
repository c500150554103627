// Macro expansion as glslang does it for HLSL (its Pp.cpp and PpTokens.cpp): a stack of inputs with a text's
// tokens at the bottom. It differs from C in two ways: arguments beside ## are expanded, and text in braces
// counts as one argument. Internal to this folder.
#pragma once

#include <memory>

#include "preprocessing/cut_source.h"
#include "preprocessing/spellings.h"
#include "preprocessing/token.h"

namespace penumbra::preprocessing {

// The macros that are defined at a point of the source.
class Macros {
 public:
  bool is_defined(Spelling name) const { return name < defined_.size() && defined_[name] != 0; }
  const Definition* definition(Spelling name) const {
    return is_defined(name) ? entries_[name].definition : nullptr;
  }

  // The definition must outlive this object. Throws Unusual if the name already has another definition.
  void define(const Definition& definition);
  void undefine(Spelling name);

  // Returns whether its own expansion is being read.
  bool is_busy(Spelling name) const { return entries_[name].busy; }
  void set_busy(Spelling name, bool busy) { entries_[name].busy = busy; }

  void clear();

 private:
  struct Entry {
    const Definition* definition = nullptr;
    bool busy = false;
  };

  std::vector<Entry> entries_;          // indexed by name
  std::vector<unsigned char> defined_;  // the same, for fast lookup of every name of a text
  std::vector<Spelling> names_;         // all that were ever defined
};

// A token and the location that glslang would report for it.
struct Read {
  Token token;
  int line = 0;
  int column = 0;
};

class Expansion {
 public:
  Expansion(Spellings& spellings, Macros& macros) : spellings_(spellings), macros_(macros) {}

  // Sets the bottom of the stack. After a condition's last token, scan() returns newlines; nothing may be
  // read after the last token of a text.
  void read_text(const Token* first, const Token* last, const Place* places);
  void read_condition(const Token* first, const Token* last);
  const Token* position() const { return at_; }  // position in the bottom input

  Read scan();
  // Applies the ## operators that follow a scanned token.
  void paste(Read& left);
  // If a macro of that name is called here, pushes its expansion and returns true. For an undefined name,
  // pushes 0 if requested.
  bool expand(Read& name, bool undefined_as_zero);
  // Pops the inputs that are exhausted; returns true if only the bottom is left.
  bool at_bottom();
  void clear();

 private:
  struct Call {
    std::vector<std::vector<Token>> arguments;
    std::vector<std::vector<Token>> expanded;
  };

  enum class Source { macro, argument, put_back };

  struct Input {
    Source source = Source::argument;
    bool pasted_behind =
        false;  // for an argument: ## follows its last token; for a macro: ## follows the token read last
    const Token* at = nullptr;
    const Token* last = nullptr;
    Spelling macro = 0;
    std::unique_ptr<Call> call;
    Read read;  // the token that was put back
  };

  Read scan_bottom();
  bool scan_input(Read& out);
  void pop();
  void put_back(const Read& read);
  bool peek_paste() const;
  bool peek_continued() const;
  void push_argument(const std::vector<Token>& tokens, bool pasted_behind);
  std::unique_ptr<Call> read_arguments(const Definition& macro, Read& read);
  void read_argument(Read& read, std::vector<Token>& argument);
  void expand_argument(const std::vector<Token>& argument, std::vector<Token>& expanded);
  std::unique_ptr<Call> new_call(std::size_t arguments);

  Spellings& spellings_;
  Macros& macros_;
  std::vector<Input> inputs_;
  std::vector<std::unique_ptr<Call>> free_calls_;
  const Token* at_ = nullptr;
  const Token* last_ = nullptr;
  const Place* places_ = nullptr;  // place of the token at `at_`; null for a condition
  int line_ = 0;                   // the position of glslang's scanner
  int column_ = 0;
  bool joined_ = false;  // Place::joined of the last token
  std::size_t scanned_ = 0;
  int depth_ = 0;  // depth of nested argument expansions
};

}  // namespace penumbra::preprocessing
