#include <nlohmann/json.hpp>
#include <utility>

#include "input/json_table.h"
#include "parameters/settings_input.h"
#include "study/record_fields.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order in which a person wants to read the keys

// The archive (record_fields.h) that writes one object. Ranges hold already.
class RecordWriter {
 public:
  static constexpr bool reads = false;

  Json json;

  bool present(const char* /*key*/, bool is_given) { return is_given; }
  void require(bool /*holds*/, const char* /*key*/, const std::string& /*problem*/) {}

  void text(const char* key, const std::string& value) { json[key] = value; }
  void texts(const char* key, const std::vector<std::string>& values) { json[key] = values; }
  void constant(const char* key, std::string_view value, const char* /*reason*/) { json[key] = value; }
  void boolean(const char* key, bool value) { json[key] = value; }
  void either(const char* key, bool value, const char* yes, const char* no) { json[key] = value ? yes : no; }
  template <typename Integer>
  void count(const char* key, Integer value) {
    json[key] = value;
  }
  void number(const char* key, double value, double /*least*/, double /*most*/) { json[key] = value; }
  void numbers(const char* key, const std::vector<double>& values, std::size_t /*count*/) {
    json[key] = values;
  }
  void number_lists(const char* key, const std::map<std::string, std::vector<double>>& lists) {
    json[key] = Json::object();
    for (const auto& [name, values] : lists) json[key][name] = values;
  }
  void vector(const char* key, const glm::dvec3& value) { json[key] = {value.x, value.y, value.z}; }
  void soft_quality(const char* key, parameters::SoftQuality value) {
    json[key] = parameters::name_of(value);
  }
  void light_fit(const char* key, parameters::LightFit value) { json[key] = parameters::name_of(value); }
  void figure(const char* key, const std::optional<double>& value, double /*least*/, double /*most*/) {
    json[key] = value ? Json(*value) : Json(nullptr);
  }
  void nullable(const char* key, const std::optional<std::string>& value) {
    json[key] = value ? Json(*value) : Json(nullptr);
  }
  void optional(const char* key, const std::optional<std::string>& value) {
    if (value) json[key] = *value;
  }
  void optional(const char* key, const std::optional<double>& value, double /*least*/, double /*most*/) {
    if (value) json[key] = *value;
  }

  // The nested object of a struct with fields() of its own; `with`: what these take besides.
  template <typename Value, typename... With>
  void object(const char* key, const Value& value, const With&... with) {
    json[key] = json_of(value, with...);
  }
  template <typename Value, typename... With>
  void nullable(const char* key, const std::optional<Value>& value, const With&... with) {
    json[key] = value ? json_of(*value, with...) : Json(nullptr);
  }
  template <typename Value>
  void optional(const char* key, const std::optional<Value>& value) {
    if (value) object(key, *value);
  }
  template <typename Value, typename... With>
  void list(const char* key, const std::vector<Value>& values, const With&... with) {
    json[key] = Json::array();
    for (const Value& value : values) json[key].push_back(json_of(value, with...));
  }

 private:
  template <typename Value, typename... With>
  static Json json_of(const Value& value, const With&... with) {
    RecordWriter writer;
    fields(writer, value, with...);
    return std::move(writer.json);
  }
};

// Indented JSON whose short objects and arrays stand on one line.
class LineWriter {
 public:
  std::string text_of(const Json& json) {
    write(json, 0);
    return text_ + "\n";
  }

 private:
  static constexpr std::size_t kLineEnd = 110;

  // Names come from files and devices: an invalid UTF-8 byte becomes U+FFFD instead of an exception.
  static std::string leaf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  static std::string one_line(const Json& json) {
    if (!json.is_structured()) return leaf(json);
    std::string text;
    for (const auto& [key, value] : json.items()) {
      text += text.empty() ? "" : ", ";
      text += (json.is_object() ? leaf(key) + ": " : "") + one_line(value);
    }
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
  }

  void write(const Json& json, std::size_t indent) {
    if (!json.is_structured() || json.empty()) {
      text_ += one_line(json);
      return;
    }
    if (indent > 0 && (json.is_array() || indent > 4)) {
      const std::string line = one_line(json);
      if (indent + line.size() <= kLineEnd) {
        text_ += line;
        return;
      }
    }
    const std::string margin(indent + 2, ' ');
    text_ += json.is_object() ? "{" : "[";
    std::string comma;
    for (const auto& [key, value] : json.items()) {
      text_ += comma + "\n" + margin + (json.is_object() ? leaf(key) + ": " : "");
      write(value, indent + 2);
      comma = ",";
    }
    text_ += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
  }

  std::string text_;
};

Json json_of(const Results& results) {
  RecordWriter writer;
  writer.count("schema_version", kResultsSchemaVersion);
  fields(writer, results);
  return writer.json;
}

}  // namespace

std::string to_json(const Results& results) {
  return LineWriter().text_of(json_of(results));
}

std::string to_table(const Results& results) {
  const auto digits = [](const std::string& path) {
    for (const char* setting : {"parameters/", "light_degrees", "settings/"})
      if (path.starts_with(setting)) return kAllDigits;
    // Pages show four digits at most; means of several figures, and differences, keep their last one. Of a
    // single cascade they show three.
    const int fewer = path.starts_with("per_cascade/") ? 2 : 0;
    return (path.find("intervals/") == std::string::npos ? 7 : 5) - fewer;
  };
  return json_table(json_of(results).dump(-1, ' ', false, Json::error_handler_t::replace), "records", digits);
}

}  // namespace penumbra::study
