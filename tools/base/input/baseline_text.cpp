#include "input/baseline_text.h"

#include "input/counted.h"
#include "input/visible_text.h"

namespace penumbra {

std::string baseline_lines(const std::vector<std::string>& unknown, const std::vector<std::string>& gone) {
  std::string text;
  for (const std::string& one : unknown) text += "not in the baseline: " + visible(one) + "\n";
  for (const std::string& one : gone) text += "only in the baseline: " + visible(one) + "\n";
  return text;
}

std::string baseline_counts(const std::string& thing, std::size_t unknown, std::size_t gone) {
  return counted(unknown, thing) + " not in the baseline, " + std::to_string(gone) + " only there";
}

}  // namespace penumbra
