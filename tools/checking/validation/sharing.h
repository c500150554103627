#pragma once

namespace penumbra::validation {

// The work that the units of a run share; less than `everything` is only for benchmarks.
enum class Sharing {
  nothing,       // every unit is processed on its own
  declarations,  // unreached declarations are checked once (checked_declarations.h)
  everything,    // each text, each reached text and each module is processed once
};

}  // namespace penumbra::validation
