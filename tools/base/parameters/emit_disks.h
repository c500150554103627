// The disk tables as a table to read, JSON, or source. The checked-in ShaderLibrary/Core/DiskTables.hlsl is
// this text.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parameters/disk.h"
#include "parameters/disk_quality.h"
#include "parameters/source_text.h"

namespace penumbra::parameters {

struct Disk {
  std::string kind;  // "fibonacci" (uniform law), "vogel" or "poisson"
  DiskPoints points;
};

struct DiskSet {
  DiskPoints fibonacci_directions;
  std::vector<Disk> disks;  // Fibonacci 1 .. 64, then Vogel, then Poisson
};

// If `generate` is true, the Poisson disks are made anew instead of taking the checked-in ones; before_start
// is that of generate_poisson_disk().
DiskSet disk_set(bool generate, const std::function<void()>& before_start = {});

std::string disks_table(const DiskSet& set);
std::string disks_json(const DiskSet& set);
std::string disks_source(const DiskSet& set, Language language);

}  // namespace penumbra::parameters
