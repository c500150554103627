// The figures of a compiled shader, by names of our own. They mean the same on every AMD family.
//
// Each is one of the driver's statistics (VK_KHR_pipeline_executable_properties) or of FXC's
// (fxc/bytecode.h), without change, or is counted in the bytecode. A figure that is not available stays
// empty. Documentation~/cost.md says what each means.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace penumbra::cost {

using Figure = std::optional<std::uint64_t>;

struct Figures {
  Figure instructions;
  Figure vgprs;  // vector registers a subgroup is given
  Figure sgprs;  // scalar registers
  Figure spilled_vgprs;
  Figure spilled_sgprs;
  Figure code_size_bytes;
  Figure occupancy;                  // most subgroups a SIMD unit keeps in flight
  Figure latency_cycles;             // issue and stalls, estimated
  Figure inverse_throughput_cycles;  // busy cycles per 64 lanes, estimated
  Figure lds_bytes;                  // shared memory of a workgroup
  Figure scratch_bytes;              // private memory of a subgroup
  Figure arithmetic;                 // Direct3D's bytecode: instructions on numbers,
  Figure textures;                   // instructions that sample, gather or load,
  Figure branches;                   // instructions of dynamic flow control;
  Figure temporaries;                // registers of four components

  bool operator==(const Figures&) const = default;
};

struct FigureName {
  const char* key;          // key in JSON and CSV
  const char* heading;      // heading of a table's column
  const char* driver_name;  // name of the driver's statistic
  Figure Figures::*value;
  bool more_is_better = false;
};

std::span<const FigureName> figure_names();  // figures in the order of tables

struct DriverStatistic {
  std::string name;  // the driver's own
  std::uint64_t value = 0;

  bool operator==(const DriverStatistic&) const = default;
};

Figures figures_of(const std::vector<DriverStatistic>& statistics);

}  // namespace penumbra::cost
