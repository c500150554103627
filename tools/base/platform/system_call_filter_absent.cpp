// Replaces system_call_filter.cpp if libseccomp is not available.
#include "platform/system_call_filter.h"

namespace penumbra::platform {

int filter_system_calls() {
  return 0;
}

int filter_foreign_calls() {
  return 0;
}

}  // namespace penumbra::platform
