#include <algorithm>
#include <cmath>
#include <limits>

#include "input/input_error.h"
#include "input/located_json.h"
#include "input/nearest_name.h"

namespace penumbra {

std::string json_type(const nlohmann::json& value) {
  if (value.is_number()) return "a number";
  if (value.is_string()) return "a string";
  if (value.is_boolean()) return "true or false";
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  return "null";
}

JsonObject::JsonObject(const LocatedJson& document, LocatedJson::Pointer at)
    : document_(&document), at_(std::move(at)) {
  const nlohmann::json& value = document.at(at_);
  if (!value.is_object()) {
    throw InputError(document.where(at_), "expected an object { ... }, found " + json_type(value));
  }
}

const nlohmann::json* JsonObject::find(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  if (!present_) return nullptr;
  const nlohmann::json& object = document_->at(at_);
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

bool JsonObject::has(const std::string& key) {
  return find(key) != nullptr;
}

double JsonObject::number(const std::string& key, double fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_number()) fail(key, "'" + key + "' must be a number, found " + json_type(*value));
  const double result = value->get<double>();
  if (!std::isfinite(result)) fail(key, "'" + key + "' is too large for a number");
  return result;
}

int JsonObject::integer(const std::string& key, int fallback) {
  const double value = number(key, fallback);
  if (value != std::floor(value)) fail(key, "'" + key + "' must be a whole number");
  if (std::abs(value) > std::numeric_limits<int>::max()) fail(key, "'" + key + "' is too large");
  return static_cast<int>(value);
}

bool JsonObject::boolean(const std::string& key, bool fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_boolean()) fail(key, "'" + key + "' must be true or false, found " + json_type(*value));
  return value->get<bool>();
}

std::string JsonObject::text(const std::string& key, const std::string& fallback) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_string()) fail(key, "'" + key + "' must be a string, found " + json_type(*value));
  return value->get<std::string>();
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t count) {
  const nlohmann::json* value = find(key);
  const std::string wanted = "'" + key + "' must be an array of " + std::to_string(count) + " numbers";
  if (value == nullptr) fail(key, wanted + ", but it is missing");
  if (!value->is_array()) fail(key, wanted + ", found " + json_type(*value));
  if (value->size() != count) fail(key, wanted + ", found " + std::to_string(value->size()));
  std::vector<double> result;
  for (const nlohmann::json& element : *value) {
    if (!element.is_number()) fail(key, wanted + ", one element is " + json_type(element));
    result.push_back(element.get<double>());
    if (!std::isfinite(result.back())) fail(key, wanted + ", one element is too large");
  }
  return result;
}

std::vector<std::size_t> JsonObject::indices(const std::string& key, std::size_t end) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return {};
  const auto is_index = [end](const nlohmann::json& element) {
    return element.is_number_unsigned() && element.get<std::uint64_t>() < end;
  };
  if (!value->is_array() || !std::all_of(value->begin(), value->end(), is_index))
    fail(key, "'" + key + "' must be an array of whole numbers from 0 to below " + std::to_string(end));
  return value->get<std::vector<std::size_t>>();
}

std::vector<std::string> JsonObject::texts(const std::string& key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_array()) fail(key, "'" + key + "' must be an array of strings, found " + json_type(*value));
  std::vector<std::string> result;
  for (const nlohmann::json& element : *value) {
    if (!element.is_string()) fail(key, "'" + key + "' must hold only strings, one is " + json_type(element));
    result.push_back(element.get<std::string>());
  }
  return result;
}

JsonObject JsonObject::object(const std::string& key) {
  const nlohmann::json* value = find(key);
  if (value != nullptr) {
    if (!value->is_object()) fail(key, "'" + key + "' must be an object { ... }, found " + json_type(*value));
    return JsonObject(*document_, at_ / key);
  }
  JsonObject empty = *this;
  empty.at_ = at_ / key;
  empty.present_ = false;
  empty.asked_.clear();
  return empty;
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_array()) fail(key, "'" + key + "' must be an array of objects, found " + json_type(*value));
  std::vector<JsonObject> result;
  for (std::size_t i = 0; i < value->size(); ++i) result.emplace_back(*document_, at_ / key / i);
  return result;
}

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> result;
  if (!present_) return result;
  const nlohmann::json& object = document_->at(at_);
  for (auto item = object.begin(); item != object.end(); ++item) result.push_back(item.key());
  return result;
}

void JsonObject::finish() const {
  for (const std::string& key : keys()) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    fail(key, "unknown key '" + key + "'", unknown_name_remedy(key, asked_));
  }
}

std::string JsonObject::where(const std::string& key) const {
  const bool there = present_ && document_->at(at_).contains(key);
  return document_->where(there ? at_ / key : at_);
}

void JsonObject::fail(const std::string& key, const std::string& problem, const std::string& remedy) const {
  throw InputError(where(key), problem, remedy);
}

}  // namespace penumbra
