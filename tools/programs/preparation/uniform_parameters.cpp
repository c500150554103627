#include "preparation/uniform_parameters.h"

#include "preparation/value_types.h"

namespace penumbra::preparation {

void drop_uniform_of_parameters(TokenText& text) {
  const ValueTypes& types = text.types();
  for (const FunctionType& function : types.functions()) {
    if (function.name == npos || text.is(function.name, text.entry())) continue;
    for (const std::size_t parameter : function.parameters) {
      const DeclaredValue& value = types.declared()[parameter];
      if (value.first == npos || value.type_at == npos) continue;
      for (std::size_t at = value.first; at < value.type_at; ++at)
        if (text.is(at, "uniform")) text.erase(at, 1);
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
