#include <nlohmann/json.hpp>

#include "cost/cost_report.h"
#include "input/input_error.h"
#include "input/located_json.h"

namespace penumbra::cost {
namespace {

using Json = nlohmann::ordered_json;

// Hashes identify pipelines and differ between builds of one Mesa version; they are no cost figures.
bool is_identity(const std::string& statistic) {
  return statistic.ends_with("Hash") || statistic.ends_with("hash");
}

Json figures_json(const Figures& figures) {
  Json json = Json::object();
  for (const FigureName& name : figure_names())
    if (const Figure& figure = figures.*name.value) json[name.key] = *figure;
  return json;
}

Json row_json(const CostRow& row) {
  Json json{{"family", row.family}, {"file", row.file}, {"entry", row.entry}, {"stage", row.stage}};
  json["variants"] = Json::array();
  for (const CostVariant& variant : row.variants) {
    Json of_variant = Json::object();
    if (!variant.technique.empty()) of_variant["technique"] = variant.technique;
    of_variant["keywords"] = variant.keywords;
    json["variants"].push_back(std::move(of_variant));
  }
  if (!row.measured.failure.empty()) {
    json["failure"] = row.measured.failure;
    return json;
  }
  json["subgroup_size"] = row.measured.subgroup_size;
  json["figures"] = figures_json(row.measured.figures);
  json["statistics"] = Json::object();
  for (const DriverStatistic& statistic : row.measured.statistics)
    if (!is_identity(statistic.name)) json["statistics"][statistic.name] = statistic.value;
  return json;
}

// A user's file name and a driver's message may be in any encoding.
std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string lines(const std::vector<Json>& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) text += (i == 0 ? "\n" : ",\n") + line(list[i]);
  return text + "\n]";
}

std::uint64_t read_count(JsonObject& json, const std::string& key) {
  const double number = json.number(key, 0.0);
  if (number < 0 || number > 9007199254740992.0 ||
      number != static_cast<double>(static_cast<std::uint64_t>(number)))
    json.fail(key, "'" + key + "' is not a non-negative integer");
  return static_cast<std::uint64_t>(number);
}

Figures read_figures(JsonObject json) {
  Figures figures;
  for (const FigureName& name : figure_names())
    if (json.has(name.key)) figures.*name.value = read_count(json, name.key);
  json.finish();
  return figures;
}

std::vector<CostVariant> read_variants(std::vector<JsonObject> list) {
  std::vector<CostVariant> variants;
  for (JsonObject& json : list) {
    variants.push_back({json.text("technique", ""), json.texts("keywords")});
    json.finish();
  }
  return variants;
}

CostRow read_row(JsonObject json) {
  CostRow row;
  row.family = json.text("family", "");
  row.file = json.text("file", "");
  row.entry = json.text("entry", "");
  row.stage = json.text("stage", "");
  row.variants = read_variants(json.objects("variants"));
  row.measured.failure = json.text("failure", "");
  row.measured.subgroup_size = static_cast<std::uint32_t>(read_count(json, "subgroup_size"));
  row.measured.figures = read_figures(json.object("figures"));
  JsonObject statistics = json.object("statistics");
  for (const std::string& name : statistics.keys())
    row.measured.statistics.push_back({name, read_count(statistics, name)});
  json.finish();
  return row;
}

}  // namespace

// The JSON has one line per row, so that a change of one shader changes one line.
std::string cost_json(const CostReport& report) {
  std::vector<Json> families;
  for (const RadvFamily& family : report.families)
    families.push_back({{"name", family.name}, {"device", family.device}, {"driver", family.driver}});
  std::vector<Json> rows;
  for (const CostRow& row : report.rows) rows.push_back(row_json(row));
  return "{\n\"command\": " + line(report.command) + ",\n\"driver\": " + line(report.driver) +
         ",\n\"compiler\": " + line(report.compiler) + ",\n\"families\": " + lines(families) +
         ",\n\"rows\": " + lines(rows) + "\n}\n";
}

CostReport read_cost_report(const std::filesystem::path& file) {
  const LocatedJson document = LocatedJson::read(file);
  JsonObject json(document);
  CostReport report;
  report.command = json.text("command", "");
  report.driver = json.text("driver", "");
  report.compiler = json.text("compiler", "");
  if (report.driver.empty() || !json.has("rows"))
    throw InputError(file.string(), "is not a report of penumbra cost: it has no driver or no rows",
                     "write one with penumbra cost --format json -o FILE");
  for (JsonObject& family : json.objects("families")) {
    report.families.push_back(
        {family.text("name", ""), family.text("device", ""), family.text("driver", "")});
    family.finish();
  }
  for (const JsonObject& row : json.objects("rows")) report.rows.push_back(read_row(row));
  json.finish();
  return report;
}

}  // namespace penumbra::cost
