// Reads the shadow state that the package's editor exports of a running frame with `penumbra constants`. That
// the editor writes this very file is a test of tests/csharp (ShadowStateTests).
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace penumbra {
namespace {

using ExportedState = ProgramTest;

// The constants are those of the matrices' own fit: penumbra constants --cascades 2 --light 1.5.
TEST_F(ExportedState, GivesTheFramesOwnConstants) {
  const auto file = std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/golden/exported_shadow_state.json";
  const auto exported = run({"constants", "--matrices", file.string(), "--format", "json"});
  const auto fitted = run({"constants", "--cascades", "2", "--light", "1.5", "--format", "json"});
  ASSERT_EQ(exported.exit_code, 0) << exported.errors;
  const auto found = nlohmann::json::parse(exported.output).at("cascades");
  const auto expected = nlohmann::json::parse(fitted.output).at("cascades");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found[i].at("world_to_shadow"), expected[i].at("world_to_shadow"));
    EXPECT_EQ(found[i].at("offset_scale"), expected[i].at("offset_scale"));
    // The scale is derived from matrices that were rounded to float: the error is half a unit of each entry,
    // as in the fit's own report.
    const auto radial = expected[i].at("depth_to_radial").get<double>();
    EXPECT_NEAR(found[i].at("depth_to_radial").get<double>(), radial, 1e-6 * radial);
    const auto bias = expected[i].at("bias").at("normal").get<double>();
    EXPECT_NEAR(found[i].at("bias").at("normal").get<double>(), 0.5 * bias, 1e-6 * -bias);
  }
}

}  // namespace
}  // namespace penumbra
