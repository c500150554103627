// The JSON reports of penumbra validate, as tests read them.
#pragma once

#include <nlohmann/json.hpp>

namespace penumbra {

// Every result with the names of its variant and with its messages.
inline nlohmann::json results_of(const nlohmann::json& report) {
  nlohmann::json results = nlohmann::json::array();
  for (const char* kind : {"sources", "variants"})
    for (const nlohmann::json& variant : report.at(kind))
      for (const nlohmann::json& result : variant.at("results")) {
        nlohmann::json whole = variant;
        whole.erase("results");
        whole.update(result);
        for (nlohmann::json& message : whole["messages"])
          message = report["messages"][message.get<std::size_t>()];
        results.push_back(std::move(whole));
      }
  return results;
}

}  // namespace penumbra
