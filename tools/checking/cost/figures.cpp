#include "cost/figures.h"

#include <array>

namespace penumbra::cost {

std::span<const FigureName> figure_names() {
  static constexpr std::array names{
      FigureName{"instructions", "instructions", "Instructions", &Figures::instructions},
      FigureName{"vgprs", "VGPRs", "VGPRs", &Figures::vgprs},
      FigureName{"sgprs", "SGPRs", "SGPRs", &Figures::sgprs},
      FigureName{"spilled_vgprs", "spilled VGPRs", "Spilled VGPRs", &Figures::spilled_vgprs},
      FigureName{"spilled_sgprs", "spilled SGPRs", "Spilled SGPRs", &Figures::spilled_sgprs},
      FigureName{"code_size_bytes", "code bytes", "Code size", &Figures::code_size_bytes},
      FigureName{"occupancy", "occupancy", "Subgroups per SIMD", &Figures::occupancy, true},
      FigureName{"latency_cycles", "latency", "Latency", &Figures::latency_cycles},
      FigureName{"inverse_throughput_cycles", "inverse throughput", "Inverse Throughput",
                 &Figures::inverse_throughput_cycles},
      FigureName{"lds_bytes", "LDS bytes", "LDS size", &Figures::lds_bytes},
      FigureName{"scratch_bytes", "scratch bytes", "Scratch size", &Figures::scratch_bytes},
      FigureName{"arithmetic", "arithmetic", "Arithmetic instructions", &Figures::arithmetic},
      FigureName{"textures", "texture reads", "Texture instructions", &Figures::textures},
      FigureName{"branches", "branches", "Dynamic branches", &Figures::branches},
      FigureName{"temporaries", "temporaries", "Temporary registers", &Figures::temporaries},
  };
  return names;
}

Figures figures_of(const std::vector<DriverStatistic>& statistics) {
  Figures figures;
  for (const FigureName& name : figure_names())
    for (const DriverStatistic& statistic : statistics)
      if (statistic.name == name.driver_name) figures.*name.value = statistic.value;
  return figures;
}

}  // namespace penumbra::cost
