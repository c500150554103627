#include "variants/narrowing.h"

#include <utility>

#include "variants/keyword_expression.h"
#include "variants/stripping.h"
#include "variants/urp_settings.h"

namespace penumbra::variants {

Narrowing read_narrowing(const NarrowingInput& input) {
  Narrowing narrowing;
  if (!input.stripping.empty()) narrowing = read_stripping(input.stripping);
  if (!input.urp_assets.empty()) {
    const UrpSettings settings = read_urp_assets(input.urp_assets);
    for (Clause& clause : clauses_of(settings, "--urp-asset")) narrowing.clauses.push_back(std::move(clause));
    for (std::string& pass : unused_passes(settings)) narrowing.unused_passes.push_back(std::move(pass));
  }
  for (const std::string& expression : input.keywords)
    for (Clause& clause : parse_keyword_expression(expression))
      narrowing.clauses.push_back(std::move(clause));
  return narrowing;
}

}  // namespace penumbra::variants
