// The macros that are defined at a point of the source. Internal to this folder.
#pragma once

#include <vector>

#include "preprocessing/cut_source.h"

namespace penumbra::preprocessing {

class Macros {
 public:
  bool is_defined(Spelling name) const { return name < defined_.size() && defined_[name] != 0; }
  const Definition* definition(Spelling name) const {
    return is_defined(name) ? entries_[name].definition : nullptr;
  }

  // The definition must outlive this object. Throws Unusual if the name already has another definition.
  void define(const Definition& definition);
  void undefine(Spelling name);

  // Returns whether its own expansion is being read.
  bool is_busy(Spelling name) const { return entries_[name].busy; }
  void set_busy(Spelling name, bool busy) { entries_[name].busy = busy; }

  void clear();

 private:
  struct Entry {
    const Definition* definition = nullptr;
    bool busy = false;
  };

  std::vector<Entry> entries_;          // indexed by name
  std::vector<unsigned char> defined_;  // the same, for fast lookup of every name of a text
  std::vector<Spelling> names_;         // all that were ever defined
};

}  // namespace penumbra::preprocessing
