// The declarations of an expanded text that its entry point reaches, and a key for each of the others.
//
// Functions, prototypes and static constants may be removed from a text without changing its entry point if
// no reached code mentions their names. Everything else (types, buffers, resources, other variables) is
// reached. Only spelling decides, so the result is conservative: a local variable with the name of a function
// keeps that function. Declarations with the same name are kept or removed together.
//
// The key of a name is a hash of its declarations, of the file and the lines they are on, and, recursively,
// of everything they mention that is declared before them: if two texts give a name the same key, compiling
// it gives the same diagnostics in both.
#pragma once

#include "hlsl/diagnostic.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

class Reach {
 public:
  // `expanded` has no comments and no macros (tokens.h), and must outlive this object. Lines before the first
  // #line that names a file are in `main_file`.
  Reach(const std::string& expanded, std::string main_file, std::string_view entry);
  Reach(const Reach&) = delete;
  Reach& operator=(const Reach&) = delete;

  // Returns the keys of the names that the entry point does not reach, each once, in source order.
  const std::vector<std::string>& unreached() const { return unreached_; }
  // Returns the indices into unreached() of those at the location of the message: one line may hold several.
  std::vector<std::size_t> at(const Diagnostic& message) const;
  // Returns the text with what the entry point and the names in `also` (indices into unreached()) reach.
  // Lines keep their numbers.
  std::string text_with(const std::vector<std::size_t>& also) const;

 private:
  struct Range {  // a range of tokens, inclusive
    std::size_t first;
    std::size_t last;
  };
  // A name whose declarations may be removed.
  struct Name {
    std::vector<Range> declarations;
    std::vector<std::size_t> spelled;  // the names in them, as indices into names_
    std::string key;
  };

  friend class ReachReader;

  std::size_t offset(std::size_t token) const;  // position in the text
  void reach(std::vector<std::size_t> from, std::vector<bool>& reached) const;

  const std::string& text_;
  std::string main_file_;
  std::vector<Token> tokens_;
  std::vector<Name> names_;
  std::vector<bool> reached_;                 // for each of names_: the entry point reaches it
  std::vector<std::size_t> unreached_names_;  // indices into names_
  std::vector<std::string> unreached_;
};

}  // namespace penumbra::hlsl
