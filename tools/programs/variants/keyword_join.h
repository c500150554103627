// Joins keyword sets that depend on each other into independent axes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace penumbra::variants {

// Keyword numbers, ascending: the keywords that one combination defines.
using Choice = std::vector<int>;

// A choice among alternatives, before its dependencies are known.
struct JoinedSet {
  std::vector<Choice> alternatives;  // no two equal
  std::string place;                 // used in messages
};

// A clause with keyword numbers: `when` (or -1: always) requires one of `any_of`.
struct Tie {
  int when = -1;
  std::vector<int> any_of;
  std::string said_by;
};

struct Axes {
  std::vector<std::vector<Choice>>
      choices;  // choices of each axis: distinct, in the order of the sets, the first varying slowest
  std::vector<std::size_t> axis_of_set;
  std::string emptied_by;  // the tie that left an axis empty
};

// Throws InputError when dependent sets span more than 65,536 combinations.
Axes join(const std::vector<JoinedSet>& sets, const std::vector<Tie>& ties);

}  // namespace penumbra::variants
