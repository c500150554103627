// Does work again with each of its calls failing in turn.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <new>
#include <optional>
#include <string>

#include "faults/injected_fault.h"

namespace penumbra::faults {

enum class End { done, out_of_memory, refused };  // refused: an InputError

// Runs prepare, work (with faults) and check, until a work in which nothing failed. The end of the last one
// is `done`.
struct Trial {
  std::function<void()> prepare;
  std::function<void()> work;
  std::function<void(End, bool failed)> check;
};

// Returns how many calls were made to fail, one after the other.
std::size_t with_every_fault(Kind kind, Extent extent, const Trial& trial);

// Runs with memory and both kinds of file errors, once and lasting.
void with_every_fault(const Trial& trial);

std::optional<std::string> content_of(const std::filesystem::path& file);  // nothing when it is not there
std::size_t files_in(const std::filesystem::path& folder);                 // files below it count, too

}  // namespace penumbra::faults
