#include "techniques/parameter_struct.h"

namespace penumbra::techniques {

std::size_t component_count(const ParameterField& field) {
  if (field.type == "float2") return 2;
  return field.type == "float4" ? 4 : 1;
}

}  // namespace penumbra::techniques
