#include "cost/families.h"

#include <array>

namespace penumbra::cost {

std::span<const KnownFamily> known_families() {
  static constexpr std::array families{
      KnownFamily{"tahiti", "GCN 1"},      KnownFamily{"pitcairn", "GCN 1"},
      KnownFamily{"verde", "GCN 1"},       KnownFamily{"oland", "GCN 1"},
      KnownFamily{"hainan", "GCN 1"},      KnownFamily{"bonaire", "GCN 2"},
      KnownFamily{"kaveri", "GCN 2"},      KnownFamily{"kabini", "GCN 2"},
      KnownFamily{"hawaii", "GCN 2"},      KnownFamily{"tonga", "GCN 3"},
      KnownFamily{"iceland", "GCN 3"},     KnownFamily{"carrizo", "GCN 3"},
      KnownFamily{"fiji", "GCN 3"},        KnownFamily{"stoney", "GCN 3"},
      KnownFamily{"polaris10", "GCN 4"},   KnownFamily{"polaris11", "GCN 4"},
      KnownFamily{"polaris12", "GCN 4"},   KnownFamily{"vegam", "GCN 4"},
      KnownFamily{"vega10", "GCN 5"},      KnownFamily{"vega12", "GCN 5"},
      KnownFamily{"vega20", "GCN 5"},      KnownFamily{"raven", "GCN 5"},
      KnownFamily{"raven2", "GCN 5"},      KnownFamily{"renoir", "GCN 5"},
      KnownFamily{"arcturus", "CDNA 1"},   KnownFamily{"aldebaran", "CDNA 2"},
      KnownFamily{"navi10", "RDNA 1"},     KnownFamily{"navi12", "RDNA 1"},
      KnownFamily{"navi14", "RDNA 1"},     KnownFamily{"navi21", "RDNA 2"},
      KnownFamily{"navi22", "RDNA 2"},     KnownFamily{"navi23", "RDNA 2"},
      KnownFamily{"navi24", "RDNA 2"},     KnownFamily{"vangogh", "RDNA 2"},
      KnownFamily{"rembrandt", "RDNA 2"},  KnownFamily{"gfx1036", "RDNA 2"},
      KnownFamily{"gfx1100", "RDNA 3"},    KnownFamily{"gfx1101", "RDNA 3"},
      KnownFamily{"gfx1102", "RDNA 3"},    KnownFamily{"gfx1103_r1", "RDNA 3"},
      KnownFamily{"gfx1103_r2", "RDNA 3"},
  };
  return families;
}

std::vector<std::string> known_family_names() {
  std::vector<std::string> names;
  for (const KnownFamily& family : known_families()) names.emplace_back(family.name);
  return names;
}

std::vector<std::string> default_families() {
  return {"polaris10", "navi21", "gfx1100"};
}

}  // namespace penumbra::cost
