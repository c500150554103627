#include "validation/waiting_units.h"

#include <algorithm>

#include "platform/content_hash.h"

namespace penumbra::validation {

std::string variant_of(const CompileUnit& unit) {
  platform::ContentHash hash;
  hash.update(unit.file).update(unit.sub_shader);
  add_names(hash, unit);
  return hash.hex();
}

void WaitingUnits::add(const std::string& variant, std::size_t unit) {
  const auto [place, first] = group_of_.try_emplace(variant, groups_.size());
  if (first) groups_.emplace_back();
  groups_[place->second].units.push_back(unit);
}

std::size_t WaitingUnits::size() const {
  std::size_t count = first_.size();
  for (const Group& group : groups_) count += group.left();
  return count;
}

WaitingUnits::Group* WaitingUnits::group_for(unsigned worker) {
  if (current_.size() <= worker) current_.resize(worker + std::size_t{1}, 0);
  std::size_t& current = current_[worker];
  if (current != 0 && groups_[current - 1].left() > 0) return &groups_[current - 1];
  if (begun_ < groups_.size()) {
    current = ++begun_;
    return &groups_[current - 1];
  }
  const auto longest = std::max_element(groups_.begin(), groups_.end(),
                                        [](const Group& a, const Group& b) { return a.left() < b.left(); });
  return longest == groups_.end() || longest->left() == 0 ? nullptr : &*longest;
}

std::optional<std::size_t> WaitingUnits::next(unsigned worker) {
  if (!first_.empty()) {
    const std::size_t unit = first_.back();
    first_.pop_back();
    return unit;
  }
  Group* const group = group_for(worker);
  if (group == nullptr) return std::nullopt;
  return group->units[group->handed_out++];
}

}  // namespace penumbra::validation
