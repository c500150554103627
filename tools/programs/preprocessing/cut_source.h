// A source that has been split, once for many readings, into directives and runs of text between them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "preprocessing/token.h"

namespace penumbra::preprocessing {

struct Definition {
  Spelling name = 0;
  bool has_list = false;  // a parameter list, possibly empty
  std::vector<Spelling> parameters;
  std::vector<Token> body;
};

// The text between two directives.
struct Run {
  std::size_t first = 0;  // indices into the source's tokens: [first, last)
  std::size_t last = 0;
  std::size_t first_name = 0;  // indices into the source's `names`: each identifier of the run once
  std::size_t last_name = 0;
};

enum class Step : std::uint8_t {
  run,
  define,
  undef,
  on_condition,  // an #if
  on_defined,
  on_undefined,
  or_on_condition,  // an #elif
  otherwise,
  end,
  include,
  unusual
};

struct Item {
  Step step = Step::unusual;
  bool malformed = false;    // an error if it is not skipped
  bool whole_float = false;  // a literal such as 1f: an error outside of conditions
  int line = 0;              // line of a directive's name
  std::size_t index = 0;     // index of the run, definition or include, or the spelling of the macro
  std::size_t first = 0;     // a condition's tokens
  std::size_t last = 0;
  std::size_t next = 0;  // for a condition: the item of the next branch or the end
  std::size_t end = 0;   // for a condition: the item of its end
};

struct Include {
  std::string name;
  bool quoted = false;
};

struct CutSource {
  bool usual = false;  // if false, the other members are empty, and glslang's preprocessor reads the source
  std::vector<Item> items;
  std::vector<Run> runs;
  std::vector<Token> tokens;  // tokens of runs and conditions
  std::vector<Place> places;  // places of the tokens
  // The runs as glslang prints them if no macro is called, and the end of each token in that text.
  std::string printed;
  std::vector<std::size_t> ends;
  std::vector<Spelling> names;
  std::vector<Definition> definitions;
  std::vector<Include> includes;
  int lines = 0;
  int depth = 0;  // depth of nested conditions
};

CutSource cut_source(std::string_view text, Spellings& spellings);

// Parses the text that follows #define.
//
// Returns nothing if glslang would report an error or a warning.
std::optional<Definition> cut_definition(const std::vector<Token>& line);

// The comparison is that of the C standard and glslang (6.10.3): the same tokens, with white space at the
// same places.
bool are_identical(const Definition& a, const Definition& b);

}  // namespace penumbra::preprocessing
