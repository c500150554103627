// Which declarations of an expanded text its entry point reaches, and a name for all that one rests on.
//
// What may be left out of a text without a change to its entry point: functions, prototypes and static
// constants whose name nothing that is reached spells. All else (types, buffers, resources, other variables)
// is reached. Spelling alone decides, so that too much stays and never too little: a local variable called as
// some function is reaches that function. Declarations of one name stay or go together.
//
// The key of a name is a hash of its declarations, of the file and the lines they stand on, and of everything
// they name that is declared before them, and so on down: where two texts give a name the same key, there is
// the same to be said of it in both.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

class Reach {
 public:
  // `expanded`: no comments, no macros (tokens.h); it outlives this. Lines before the first #line that names
  // a file are in `main_file`.
  Reach(const std::string& expanded, std::string main_file, std::string_view entry);
  Reach(const Reach&) = delete;
  Reach& operator=(const Reach&) = delete;

  // The keys of the names that the entry point does not reach, each once, in the order of the text.
  const std::vector<std::string>& unreached() const { return unreached_; }
  // The indices into unreached() of those that stand where the message points: one line may hold several.
  std::vector<std::size_t> at(const Diagnostic& message) const;
  // The text with what the entry point reaches and what these of unreached() do. Lines keep their numbers.
  std::string text_with(const std::vector<std::size_t>& also) const;

 private:
  struct Range {  // of tokens, both included
    std::size_t first;
    std::size_t last;
  };
  // A name whose declarations may go.
  struct Name {
    std::vector<Range> declarations;
    std::vector<std::size_t> spelled;  // the names in them, as indices into names_
    std::string key;
  };

  friend class ReachReader;

  std::size_t offset(std::size_t token) const;  // in the text
  void reach(std::vector<std::size_t> from, std::vector<bool>& reached) const;

  const std::string& text_;
  std::string main_file_;
  std::vector<Token> tokens_;
  std::vector<Name> names_;
  std::vector<bool> reached_;                 // of names_, by the entry point
  std::vector<std::size_t> unreached_names_;  // indices into names_
  std::vector<std::string> unreached_;
};

}  // namespace penumbra::hlsl
