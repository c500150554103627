// Messages of `measure` and `render` about a study, on standard error, besides figures and pictures.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "cli/subcommand.h"
#include "study/results.h"

namespace penumbra::cli {

// Writes to standard error. A full disk there ends no run.
template <class... Values>
void say(fmt::format_string<Values...> form, Values&&... values) {
  (void)std::fputs(fmt::format(form, std::forward<Values>(values)...).c_str(), stderr);
}

// It prints nothing with --quiet.
void tell_notes(const std::vector<std::string>& notes, const Context& context);

// Prints a line for each technique, scene and light with results that are not a visibility; such a command
// ends with findings.
void tell_invalid_results(const std::vector<study::Record>& records, Context& context);

}  // namespace penumbra::cli
