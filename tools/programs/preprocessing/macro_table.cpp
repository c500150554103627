#include "preprocessing/macro_table.h"

#include "preprocessing/condition.h"

namespace penumbra::preprocessing {

namespace {

CutSource cut_directive(const char* name, std::string_view rest, Spellings& spellings) {
  return cut_source(std::string(name).append(" ").append(rest).append("\n"), spellings);
}

const std::string no_file;

}  // namespace

MacroTable::MacroTable() {
  expansion_.record_names(&consulted_);
}

void MacroTable::define(std::string_view definition) {
  CutSource cut = cut_directive("#define", definition, spellings_);
  if (cut.definitions.size() != 1) return;
  macros_.define(definitions_.emplace_back(std::move(cut)).definitions.front(), no_file);
}

Condition MacroTable::evaluate(std::string_view condition) {
  const CutSource cut = cut_directive("#if", condition, spellings_);
  const Item& item = cut.items.front();
  const Token* const tokens = cut.tokens.data();
  Condition answer;
  consulted_.clear();
  try {
    answer.holds = holds(tokens + item.first, tokens + item.last, expansion_, spellings_);
  } catch (const Problem& problem) {
    answer.problem = problem.what();
    expansion_.clear();
  }
  for (const Spelling name : consulted_) answer.consulted.insert(spellings_.text(name));
  return answer;
}

}  // namespace penumbra::preprocessing
