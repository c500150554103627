// The cycles of the library's techniques in the report of `penumbra cost` that it ships.
#include "cli/static_cycles.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace penumbra::cli {
namespace {

const std::filesystem::path kRoot = PENUMBRA_SOURCE_DIR;

const cost::CostReport& report() {
  static const cost::CostReport read = cost::read_cost_report(kRoot / "Documentation~/results/cost.json");
  return read;
}

const study::FactsOfTechniques& facts() {
  static const study::FactsOfTechniques all = [] {
    const techniques::TechniqueList list = techniques::read_technique_list(kRoot);
    study::FactsOfTechniques made = study::facts_of(list);
    add_cycles(made, list, report());
    return made;
  }();
  return all;
}

study::ProgramCycles of(const std::string& technique) {
  return facts().techniques.at(technique).cycles.value();
}

// The row of one program found in another way: a variant with this one keyword.
double row(const std::string& technique, const std::string& entry) {
  for (const cost::CostRow& each : report().rows) {
    if (each.family != "navi21" || each.entry != entry) continue;
    for (const cost::CostVariant& variant : each.variants)
      if (variant == cost::CostVariant{technique, {"UNITY_REVERSED_Z"}})
        return static_cast<double>(each.measured.figures.inverse_throughput_cycles.value());
  }
  ADD_FAILURE() << "no row of " << technique << ": " << entry;
  return 0.0;
}

TEST(StaticCycles, AreThoseOfAFilterAlone) {
  EXPECT_EQ(facts().cycles_of, "RADV, navi21");
  EXPECT_EQ(of("tent-5").visibility, row("tent-5", "Fragment"));
  EXPECT_EQ(of("tent-5").others, 0.0);
}

TEST(StaticCycles, AddThePassesOverTheMap) {
  EXPECT_EQ(of("variance-32").visibility, row("variance-32", "Fragment"));
  EXPECT_EQ(of("variance-32").others, row("variance-32", "MapRows") + row("variance-32", "MapColumns"));
}

TEST(StaticCycles, KnowEveryTechnique) {
  const techniques::TechniqueList list = techniques::read_technique_list(kRoot);
  for (const techniques::Technique& technique : list.techniques)
    EXPECT_TRUE(facts().techniques.at(technique.name).cycles) << technique.name;
}

TEST(StaticCycles, AreOfTheFamilyThatThereIs) {
  const techniques::TechniqueList list = techniques::read_technique_list(kRoot);
  cost::CostReport other = report();
  std::erase_if(other.families, [](const cost::RadvFamily& family) { return family.name != "polaris10"; });
  study::FactsOfTechniques older = study::facts_of(list);
  add_cycles(older, list, other);
  EXPECT_EQ(older.cycles_of, "RADV, polaris10");
  EXPECT_GT(older.techniques.at("tent-5").cycles->visibility, of("tent-5").visibility);
}

}  // namespace
}  // namespace penumbra::cli
