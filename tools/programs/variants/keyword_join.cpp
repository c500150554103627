#include "variants/keyword_join.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "input/input_error.h"

namespace penumbra::variants {
namespace {

constexpr std::size_t most_choices = 65536;
constexpr std::size_t most_work = 4'000'000;  // unions made for one axis

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  // The smaller number is the root, so that a group has the position of its first set.
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

Choice united(const Choice& a, const Choice& b) {
  Choice both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

bool has(const Choice& choice, int keyword) {
  return std::binary_search(choice.begin(), choice.end(), keyword);
}

bool satisfies(const Choice& choice, const Tie& tie) {
  if (tie.when >= 0 && !has(choice, tie.when)) return true;
  return std::any_of(tie.any_of.begin(), tie.any_of.end(), [&](int keyword) { return has(choice, keyword); });
}

std::string places_of(const std::vector<const JoinedSet*>& members) {
  std::string places;
  for (std::size_t i = 0; i < members.size() && i < 6; ++i) places += "\n    " + members[i]->place;
  if (members.size() > 6) places += "\n    and " + std::to_string(members.size() - 6) + " more";
  return places;
}

// Returns every distinct union of one alternative of each.
std::vector<Choice> combinations(const std::vector<const JoinedSet*>& members) {
  if (members.size() == 1) return members.front()->alternatives;
  std::vector<Choice> choices{{}};
  std::size_t work = 0;
  for (const JoinedSet* member : members) {
    std::vector<Choice> next;
    std::set<Choice> seen;
    for (const Choice& choice : choices) {
      for (const Choice& alternative : member->alternatives) {
        Choice both = united(choice, alternative);
        if (seen.insert(both).second) next.push_back(std::move(both));
        if (++work <= most_work && next.size() <= most_choices) continue;
        throw InputError(members.front()->place,
                         "keyword sets that depend on each other span more than " +
                             std::to_string(most_choices) + " combinations",
                         "pin or exclude some of their keywords; they are declared at" + places_of(members));
      }
    }
    choices = std::move(next);
  }
  return choices;
}

// The groups of dependent sets: those that share a keyword and those to which one tie refers.
struct Grouping {
  Grouping(const std::vector<JoinedSet>& sets, const std::vector<Tie>& ties_between) {
    Groups groups(sets.size());
    std::map<int, std::size_t> first_with;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      for (const Choice& alternative : sets[i].alternatives)
        for (const int keyword : alternative)
          groups.unite(first_with.try_emplace(keyword, i).first->second, i);
    }
    for (const Tie& tie : ties_between) {
      if (tie.when >= 0 && !first_with.contains(tie.when)) continue;
      std::vector<std::size_t> named;
      if (tie.when >= 0) named.push_back(first_with[tie.when]);
      for (const int keyword : tie.any_of) {
        const auto found = first_with.find(keyword);
        if (found != first_with.end()) named.push_back(found->second);
      }
      if (named.empty()) {
        unsatisfiable = &tie;
        continue;
      }
      for (const std::size_t set : named) groups.unite(named.front(), set);
      ties.emplace_back(&tie, named.front());
    }
    for (std::size_t i = 0; i < sets.size(); ++i) group_of.push_back(groups.find(i));
  }

  std::vector<std::size_t> group_of;                     // for each set, the number of the group's first set
  std::vector<std::pair<const Tie*, std::size_t>> ties;  // each tie with a set of the group that it is for
  const Tie* unsatisfiable = nullptr;                    // no remaining set can satisfy it
};

}  // namespace

Axes join(const std::vector<JoinedSet>& sets, const std::vector<Tie>& ties) {
  const Grouping grouping(sets, ties);
  Axes axes;
  std::map<std::size_t, std::size_t> axis_of_group;
  std::vector<std::vector<const JoinedSet*>> members;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const auto [axis, is_new] = axis_of_group.try_emplace(grouping.group_of[i], members.size());
    if (is_new) members.emplace_back();
    members[axis->second].push_back(&sets[i]);
    axes.axis_of_set.push_back(axis->second);
  }
  for (const std::vector<const JoinedSet*>& group : members) axes.choices.push_back(combinations(group));
  for (const auto& [tie, set] : grouping.ties) {
    std::vector<Choice>& choices = axes.choices[axes.axis_of_set[set]];
    const bool had_some = !choices.empty();
    std::erase_if(choices, [&, asked = tie](const Choice& choice) { return !satisfies(choice, *asked); });
    if (had_some && choices.empty()) axes.emptied_by = tie->said_by;
  }
  if (grouping.unsatisfiable != nullptr) {
    for (std::vector<Choice>& choices : axes.choices) choices.clear();
    axes.emptied_by = grouping.unsatisfiable->said_by;
  }
  return axes;
}

}  // namespace penumbra::variants
