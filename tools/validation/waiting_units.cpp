#include "validation/waiting_units.h"

#include <algorithm>

#include "platform/content_hash.h"

namespace penumbra::validation {

std::string variant_of(const CompileUnit& unit) {
  platform::ContentHash hash;
  hash.update(unit.technique).update(unit.file).update(unit.shader).update(unit.pass).update(unit.sub_shader);
  hash.update(unit.compile.entry).update(static_cast<int>(unit.compile.stage));
  for (const std::string& keyword : unit.keywords) hash.update(keyword);
  return hash.hex();
}

void WaitingUnits::add(const std::string& variant, std::size_t unit) {
  const auto [place, first] = group_of_.try_emplace(variant, groups_.size());
  if (first) groups_.emplace_back();
  groups_[place->second].push_back(unit);
}

std::size_t WaitingUnits::size() const {
  std::size_t count = first_.size();
  for (const Group& group : groups_) count += group.size();
  return count;
}

WaitingUnits::Group* WaitingUnits::group_for(unsigned worker) {
  if (current_.size() <= worker) current_.resize(worker + std::size_t{1}, 0);
  std::size_t& current = current_[worker];
  if (current != 0 && !groups_[current - 1].empty()) return &groups_[current - 1];
  if (begun_ < groups_.size()) {
    current = ++begun_;
    return &groups_[current - 1];
  }
  const auto longest = std::max_element(groups_.begin(), groups_.end(),
                                        [](const Group& a, const Group& b) { return a.size() < b.size(); });
  return longest == groups_.end() || longest->empty() ? nullptr : &*longest;
}

std::optional<std::size_t> WaitingUnits::next(unsigned worker) {
  Group* const group = first_.empty() ? group_for(worker) : &first_;
  if (group == nullptr) return std::nullopt;
  const std::size_t unit = group->front();
  group->pop_front();
  return unit;
}

}  // namespace penumbra::validation
