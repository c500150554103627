// Checks logs against the schema that OASIS publishes; scripts/setup fetches it where it can.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "validation/report_fixture.h"

namespace penumbra::validation {
namespace {

using nlohmann::json;

class SarifSchema : public testing::Test {
 protected:
  SarifSchema() {
    std::ifstream file(PENUMBRA_SARIF_SCHEMA);
    const json document = json::parse(file);
    valijson::SchemaParser(valijson::SchemaParser::kDraft4)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }

  std::string fault(const json& log) const {
    valijson::ValidationResults results;
    valijson::Validator validator;
    if (validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(log), &results)) return {};
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
      for (const std::string& part : error.context) text += part;
      text += ": " + error.description + "\n";
    }
    return text.empty() ? "refused without a reason" : text;
  }

 private:
  valijson::Schema schema_;
};

TEST_F(SarifSchema, HoldsForEveryKindOfFinding) {
  ReportStyle style;
  style.root = "/project";
  EXPECT_EQ(fault(json::parse(report_sarif(mixed_report(), style))), "");
}

TEST_F(SarifSchema, HoldsForAnEmptyReport) {
  EXPECT_EQ(fault(json::parse(report_sarif({}))), "");
}

TEST_F(SarifSchema, FailsForALogThatBreaksIt) {
  const json good = json::parse(report_sarif(mixed_report()));
  const auto with = [&](const char* pointer, const json& value) {
    json bad = good;
    bad[json::json_pointer(pointer)] = value;
    return fault(bad);
  };
  EXPECT_NE(with("/runs/0/results/0/level", "fatal"), "");
  EXPECT_NE(with("/runs/0/results/0/locations/0/physicalLocation/region/startLine", 0), "");
  EXPECT_NE(with("/runs/0/columnKind", "bytes"), "");
  EXPECT_NE(with("/runs/0/artifacts/1", good.at("runs").at(0).at("artifacts").at(0)), "") << "unique items";
}

}  // namespace
}  // namespace penumbra::validation
