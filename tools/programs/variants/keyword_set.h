// A set of shader keywords: the declaration of one `#pragma multi_compile` or `shader_feature` line.
//
// A set is a choice: every variant takes exactly one of its alternatives. An alternative is the list of
// keywords that are then defined: none for `_`, one for an ordinary keyword, several where a shortcut such as
// multi_compile_fwdadd_fullshadows combines keywords.
//
// Source: Unity Manual, "Declare shader keywords" (SL-MultipleProgramVariants-declare).
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "hlsl/stage.h"

namespace penumbra::variants {

// A source location.
struct Place {
  std::string file;
  int line = 0;    // 1-based
  int column = 0;  // 1-based
};

// Returns "file:line:column".
inline std::string text_of(const Place& place) {
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

using Keywords = std::vector<std::string>;

// The stages that a set is for. Ray tracing stages are known by name and never compiled here.
class StageSet {
 public:
  StageSet() = default;
  StageSet(std::initializer_list<hlsl::Stage> stages) {
    for (const hlsl::Stage stage : stages) add(stage);
  }
  static StageSet all() {
    StageSet stages;
    for (const hlsl::Stage stage : hlsl::all_stages) stages.add(stage);
    return stages;
  }
  void add(hlsl::Stage stage) { bits_ |= bit(stage); }
  void add(StageSet other) { bits_ |= other.bits_; }
  bool has(hlsl::Stage stage) const { return (bits_ & bit(stage)) != 0; }
  bool empty() const { return bits_ == 0; }
  bool meets(StageSet other) const { return (bits_ & other.bits_) != 0; }
  bool operator==(const StageSet&) const = default;

 private:
  static unsigned bit(hlsl::Stage stage) { return 1U << static_cast<unsigned>(stage); }
  unsigned bits_ = 0;
};

struct KeywordSet {
  enum class Kind { multi_compile, shader_feature };
  Kind kind = Kind::multi_compile;
  std::string pragma;  // the pragma as written: "multi_compile_local_fragment", "multi_compile_fog"
  bool local = false;
  StageSet stages = StageSet::all();
  std::vector<Keywords> alternatives;  // alternatives in the order written, no two equal
  Place place;
};

// A dynamic_branch keyword: no variant, but a uniform of type int that is 0 or 1 and has the keyword's name,
// so that `if (NAME)` compiles; no macro NAME is defined (Unity Manual, "How Unity compiles branching
// shaders").
struct DynamicKeyword {
  std::string name;
  bool local = false;
  Place place;
};

// Returns whether it is one of Unity's names of the empty keyword: "_", "__" and longer.
bool is_empty_keyword(const std::string& name);

bool contains(const Keywords& keywords, const std::string& keyword);

// Returns every keyword of the set once, in the order written.
Keywords keywords_of(const KeywordSet& set);

// Returns the set as it is written in a pragma: "_ A B".
std::string label_of(const KeywordSet& set);

// A condition that every compiled variant satisfies: the one form that all narrowing of a keyword space
// takes.
//
//   never K            {when: K, any_of: {}}       no variant has K
//   K needs A or B     {when: K, any_of: {A, B}}   a variant with K has A or B
//   always K           {when: "", any_of: {K}}     every variant of a program that declares K has it
//   one of A, B        {when: "", any_of: {A, B}}  of a program that declares A or B (with whole: both) every
//                                                  variant has one of them
//   only A and B       the same, of_their_sets     the sets that hold A or B keep only A and B, and with
//                                                  or_none the empty keyword, too
struct Clause {
  std::string when;
  Keywords any_of;
  bool whole = false;          // applies only to programs that declare every keyword of any_of
  bool of_their_sets = false;  // narrows each set on its own instead of the whole variant
  bool or_none = false;        // used with of_their_sets
  std::string said_by;         // its origin, for messages: "--keywords -A", "rules.json:3:5"
};

inline Clause never(const std::string& keyword, const std::string& said_by) {
  return {keyword, {}, false, false, false, said_by};
}
inline Clause always(const std::string& keyword, const std::string& said_by) {
  return {"", {keyword}, false, false, false, said_by};
}
inline Clause needs(const std::string& keyword, const Keywords& any_of, const std::string& said_by) {
  return {keyword, any_of, false, false, false, said_by};
}

}  // namespace penumbra::variants
