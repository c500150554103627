// A source that has been split, once for many readings, into directives and runs of text between them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "preprocessing/token.h"

namespace penumbra::preprocessing {

struct Definition {
  Spelling name = 0;
  Place place;
  bool has_list = false;  // a parameter list, possibly empty
  std::vector<Spelling> parameters;
  std::vector<Token> body;
  bool pastes = false;  // ## is in the body
};

// The text between two directives.
struct Run {
  std::size_t first = 0;  // indices into the source's tokens: [first, last)
  std::size_t last = 0;
  std::size_t first_name = 0;  // indices into the source's `names`: each identifier of the run once
  std::size_t last_name = 0;
  std::size_t bad = 0;  // index of its first bad token; `last` if there is none
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
  skipped,  // #pragma, #warning and #line: places are those of the file
  problem   // a directive that is an error where it is not skipped
};

struct Item {
  Step step = Step::problem;
  Place place;            // place of a directive's '#'
  bool once = false;      // it is #pragma once
  std::size_t index = 0;  // index of the run, definition, include or message, or the spelling of the macro
  std::size_t first = 0;  // a condition's tokens
  std::size_t last = 0;
  std::size_t next = 0;  // for a condition: the item of the next branch or the end
  std::size_t end = 0;   // for a condition: the item of its end
};

struct CutSource {
  // An error wherever the source is read: a condition or a comment without its end. Empty if there is none.
  std::string problem;
  Place problem_place;
  std::vector<Item> items;
  std::vector<Run> runs;
  std::vector<Token> tokens;  // tokens of runs and conditions
  std::vector<Place> places;  // places of the tokens
  // The runs as they are printed if no macro is called, and the end of each token in that text.
  std::string printed;
  std::vector<std::size_t> ends;
  std::vector<Spelling> names;
  std::vector<Definition> definitions;
  std::vector<std::string> includes;
  std::vector<std::string> messages;  // of Step::problem
};

CutSource cut_source(std::string_view text, Spellings& spellings);

}  // namespace penumbra::preprocessing
