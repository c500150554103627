// The order in which units are handed out to workers.
//
// One worker gets all units of a variant, one after another: for most graphics APIs they have the same
// reached text, which it then compiles once (checked_declarations.h). When no whole variant is left, a worker
// takes over units that another has not begun.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "validation/unit.h"

namespace penumbra::validation {

// Returns a key that is equal for the units that differ in the graphics API alone.
std::string variant_of(const CompileUnit& unit);

class WaitingUnits {
 public:
  void add(const std::string& variant, std::size_t unit);
  void put_first(std::size_t unit) { first_.push_back(unit); }  // for the next worker that asks

  std::size_t size() const;  // number of units that have not been handed out
  std::optional<std::size_t> next(unsigned worker);

 private:
  struct Group {
    std::vector<std::size_t> units;
    std::size_t handed_out = 0;

    std::size_t left() const { return units.size() - handed_out; }
  };

  Group* group_for(unsigned worker);

  std::vector<std::size_t> first_;  // handed out from the back
  std::vector<Group> groups_;       // groups in the order of their first units
  std::unordered_map<std::string, std::size_t> group_of_;
  std::size_t begun_ = 0;             // groups that a worker has been given
  std::vector<std::size_t> current_;  // for each worker, its group's index plus one; 0 means none
};

}  // namespace penumbra::validation
