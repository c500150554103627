#include "preprocessing/macros.h"

#include "preprocessing/definition_cut.h"

namespace penumbra::preprocessing {

void Macros::define(const Definition& definition) {
  if (definition.name >= entries_.size()) {
    entries_.resize(definition.name + 1);
    defined_.resize(definition.name + 1);
  }
  Entry& entry = entries_[definition.name];
  if (entry.definition != nullptr && entry.definition != &definition &&
      !are_identical(*entry.definition, definition))
    throw Unusual("a macro is redefined differently");
  entry.definition = &definition;
  defined_[definition.name] = 1;
  names_.push_back(definition.name);
}

void Macros::undefine(Spelling name) {
  if (!is_defined(name)) return;
  entries_[name].definition = nullptr;
  defined_[name] = 0;
}

void Macros::clear() {
  for (const Spelling name : names_) {
    entries_[name] = {};
    defined_[name] = 0;
  }
  names_.clear();
}

}  // namespace penumbra::preprocessing
