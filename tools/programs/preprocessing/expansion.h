// The expansion of macros as glslang does it for HLSL (its Pp.cpp and PpTokens.cpp): one stack of what is
// read, which is a text's tokens at its bottom. Two things differ from C there: arguments beside ## are
// expanded, and what stands in {} in an argument is one. Internal to this room.
#pragma once

#include <memory>
#include <vector>

#include "preprocessing/macros.h"
#include "preprocessing/spellings.h"
#include "preprocessing/token.h"

namespace penumbra::preprocessing {

// A token and where glslang would say that it is.
struct Read {
  Token token;
  int line = 0;
  int column = 0;
};

class Expansion {
 public:
  Expansion(Spellings& spellings, Macros& macros) : spellings_(spellings), macros_(macros) {}

  // What stands at the bottom. Of a condition, newlines follow the last token; nothing may be asked for
  // behind the last token of text.
  void read_text(const Token* first, const Token* last, const Place* places);
  void read_condition(const Token* first, const Token* last);
  const Token* position() const { return at_; }  // of the bottom

  Read scan();
  // Joins what ## joins to a token that was scanned.
  void paste(Read& left);
  // Where a macro of that name is called, true, and what it stands for is read next. Where there is none, 0
  // is if wanted.
  bool expand(Read& name, bool undefined_as_zero);
  // Drops what has been read to its end; true when only the bottom is left.
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
    bool pasted_behind = false;  // of an argument: ## follows its last token; of a macro: the token read last
    const Token* at = nullptr;
    const Token* last = nullptr;
    Spelling macro = 0;
    std::unique_ptr<Call> call;
    Read read;  // that was put back
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
  const Place* places_ = nullptr;  // of the token at `at_`; none of a condition
  int line_ = 0;                   // where glslang's scanner is
  int column_ = 0;
  bool joined_ = false;  // Place::joined of the last token
  std::size_t scanned_ = 0;
  int depth_ = 0;  // of arguments that are being expanded
};

}  // namespace penumbra::preprocessing
