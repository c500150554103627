#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

namespace penumbra::validation {

// Keeps the most recent results, by a key of everything that they depend on. Not thread-safe.
template <typename Result>
class RecentResults {
 public:
  explicit RecentResults(std::size_t most) : most_(most) {}

  std::shared_ptr<const Result> find(const std::string& key) const {
    const auto known = results_.find(key);
    return known == results_.end() ? nullptr : known->second;
  }

  std::shared_ptr<const Result> keep(const std::string& key, Result result) {
    const auto [place, is_new] = results_.try_emplace(key);
    place->second = std::make_shared<const Result>(std::move(result));
    if (is_new) order_.push_back(key);
    std::shared_ptr<const Result> kept = place->second;
    if (order_.size() > most_) {
      results_.erase(order_.front());
      order_.pop_front();
    }
    return kept;
  }

 private:
  std::size_t most_;
  std::deque<std::string> order_;
  std::unordered_map<std::string, std::shared_ptr<const Result>> results_;
};

}  // namespace penumbra::validation
