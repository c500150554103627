// The names that a random program may use at a place, and chance.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs {

// Gives the same numbers from the same seed on every platform; the standard's distributions promise nothing.
class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}

  int below(int end) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(end)); }
  int between(int least, int most) { return least + below(most - least + 1); }
  bool percent(int share) { return below(100) < share; }
  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }

  template <typename T>
  const T& of(const std::vector<T>& all) {
    return all.at(static_cast<std::size_t>(below(static_cast<int>(all.size()))));
  }

 private:
  std::mt19937 engine_;
};

// The blocks around a place, innermost last, with the variables each declares.
class Scope {
 public:
  explicit Scope(Program& program) : program_(program) {}

  void open() { blocks_.emplace_back(); }
  void close() { blocks_.pop_back(); }
  std::size_t depth() const { return blocks_.size(); }

  int declare(const Variable& variable) {
    program_.variables.push_back(variable);
    blocks_.back().push_back(static_cast<int>(program_.variables.size()) - 1);
    return blocks_.back().back();
  }

  bool declares_here(const std::string& name) const {
    for (const int variable : blocks_.back())
      if (program_.variables[variable].name == name) return true;
    return false;
  }

  // The variables that no inner block hides.
  std::vector<int> visible() const {
    std::vector<int> all;
    std::vector<std::string> seen;
    for (std::size_t i = blocks_.size(); i-- > 0;) {
      for (const int variable : blocks_[i]) {
        const std::string& name = program_.variables[variable].name;
        bool hidden = false;
        for (const std::string& other : seen) hidden = hidden || other == name;
        if (!hidden) all.push_back(variable);
      }
      for (const int variable : blocks_[i]) seen.push_back(program_.variables[variable].name);
    }
    return all;
  }

 private:
  Program& program_;
  std::vector<std::vector<int>> blocks_;
};

}  // namespace penumbra::programs
