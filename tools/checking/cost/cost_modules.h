// The distinct modules of a request, before any driver sees them. Internal to this folder.
#pragma once

#include <vector>

#include "cost/measure_cost.h"
#include "cost/module_compiler.h"

namespace penumbra::cost {

struct CostModule {
  std::string file;
  std::string entry;
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::vector<CostVariant> variants;
  CompiledModule compiled;  // the module without diagnostics
};

struct CostModules {
  std::vector<CostModule> modules;  // modules in the order of the request, by their first variant
  std::vector<hlsl::Diagnostic> diagnostics;
};

// Adds those of `more` that are not there yet: two variants, or two compilers, may refuse a file for the same
// reason.
void add_new(std::vector<hlsl::Diagnostic>& said, const std::vector<hlsl::Diagnostic>& more);

CostModules compile_modules(const CostRequest& request, Compiler compiler);

}  // namespace penumbra::cost
