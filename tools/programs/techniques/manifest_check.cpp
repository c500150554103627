// check_manifest(): valijson says where a manifest breaks the schema, and the table below says it in words.
#include "techniques/manifest_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#define VALIJSON_USE_EXCEPTIONS 1  // without it, valijson ends the program
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "input/text_line.h"

namespace penumbra::techniques {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

const json& schema_document() {
  static const json document = json::parse(kTechniqueSchema);
  return document;
}

const valijson::Schema& parsed_schema() {
  struct Parsed : valijson::Schema {
    Parsed() { valijson::SchemaParser().populateSchema(Adapter(schema_document()), *this); }
  };
  static const Parsed schema;
  return schema;
}

// The schema's conditions say which keys are there, and which constants they have.
bool holds(const json& condition, const json& value) {
  for (const json& key : condition.value("required", json::array()))
    if (!value.is_object() || !value.contains(key.get_ref<const std::string&>())) return false;
  const json members = condition.value("properties", json::object());
  for (const auto& [key, wanted] : members.items()) {
    if (!value.is_object() || !value.contains(key)) continue;
    const json choices = wanted.contains("const") ? json::array({wanted["const"]}) : wanted["enum"];
    if (std::find(choices.begin(), choices.end(), value[key]) == choices.end()) return false;
  }
  return true;
}

// All parts of the schema that are about one value.
using Rules = std::vector<const json*>;

void add_rules(const json& schema, const json& value, Rules& rules) {
  if (schema.contains("$ref"))
    return add_rules(schema_document().at(json::json_pointer(schema["$ref"].get<std::string>().substr(1))),
                     value, rules);
  rules.push_back(&schema);
  if (schema.contains("allOf"))
    for (const json& part : schema["allOf"]) add_rules(part, value, rules);
  if (!schema.contains("if")) return;
  const char* branch = holds(schema["if"], value) ? "then" : "else";
  if (schema.contains(branch)) add_rules(schema[branch], value, rules);
}

Rules rules_of_member(const Rules& rules, const std::string& key, const json& member) {
  Rules found;
  for (const json* rule : rules) {
    if (rule->contains("properties") && (*rule)["properties"].contains(key))
      add_rules((*rule)["properties"][key], member, found);
    else if (rule->contains("additionalProperties") && (*rule)["additionalProperties"].is_object())
      add_rules((*rule)["additionalProperties"], member, found);
  }
  return found;
}

Rules rules_of_items(const Rules& rules, const json& item) {
  Rules found;
  for (const json* rule : rules)
    if (rule->contains("items")) add_rules((*rule)["items"], item, found);
  return found;
}

// A value that the schema refuses, with what the schema says of it.
struct Refused {
  LocatedJson::Pointer at;
  const json* value = nullptr;
  Rules rules;
  std::string key = "manifest";  // the value's, or that of the list that it stands in
  bool is_item = false;

  const json* rule_with(const char* keyword) const {
    const auto found =
        std::find_if(rules.begin(), rules.end(), [&](const json* rule) { return rule->contains(keyword); });
    return found == rules.end() ? nullptr : *found;
  }
  std::string subject() const { return (is_item ? "each of '" : "'") + key + "'"; }
  std::string title() const {  // what the schema calls the value in messages, its key otherwise
    const json* titled = rule_with("title");
    return titled == nullptr ? key : (*titled)["title"].get<std::string>();
  }
};

// `context` is valijson's: "<root>", then "[key]" or "[index]".
LocatedJson::Pointer place_of(const std::vector<std::string>& context) {
  LocatedJson::Pointer at;
  for (std::size_t i = 1; i < context.size(); ++i) at /= context[i].substr(1, context[i].size() - 2);
  return at;
}

Refused refused_at(const std::vector<std::string>& context, const json& manifest) {
  Refused refused;
  refused.at = place_of(context);
  refused.value = &manifest;
  add_rules(schema_document(), manifest, refused.rules);
  for (std::size_t i = 1; i < context.size(); ++i) {
    const std::string token = context[i].substr(1, context[i].size() - 2);
    refused.is_item = refused.value->is_array();
    if (refused.is_item) {
      refused.value = &(*refused.value)[std::stoul(token)];
      refused.rules = rules_of_items(refused.rules, *refused.value);
    } else {
      refused.value = &(*refused.value)[token];
      refused.rules = rules_of_member(refused.rules, token, *refused.value);
      refused.key = token;
    }
  }
  return refused;
}

struct Finding {
  std::string problem;
  std::string remedy{};
  std::string member{};  // the message is about this member of the value; about the value itself if empty
};

std::string shown(const json& value) {
  return value.is_string() ? "'" + value.get<std::string>() + "'" : value.dump();
}

// "a", "a or b", "a, b or c"
std::string either(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string in_words(const std::string& type) {
  if (type == "object") return "an object { ... }";
  if (type == "array") return "an array";
  if (type == "integer") return "a whole number";
  if (type == "boolean") return "true or false";
  return "a " + type;
}

std::optional<Finding> unknown_key(const Refused& refused) {
  for (const json* rule : refused.rules) {
    if (!rule->contains("additionalProperties") || (*rule)["additionalProperties"].is_object()) continue;
    const json& properties = (*rule)["properties"];
    for (const auto& [key, member] : refused.value->items()) {
      if (properties.contains(key)) continue;
      if (rule->contains("errorMessage"))
        return Finding{"'" + key + "': " + (*rule)["errorMessage"].get<std::string>(), "leave it out", key};
      std::vector<std::string> known;
      for (const auto& property : properties.items()) known.push_back(property.key());
      return Finding{"unknown key '" + key + "'", unknown_name_remedy(key, known), key};
    }
  }
  return std::nullopt;
}

std::optional<Finding> wrong_type(const Refused& refused) {
  const json* rule = refused.rule_with("type");
  if (rule == nullptr) return std::nullopt;
  const json types = (*rule)["type"].is_array() ? (*rule)["type"] : json::array({(*rule)["type"]});
  std::vector<std::string> names;
  for (const json& type : types) names.push_back(in_words(type));
  const bool is_number = refused.value->is_number();
  return Finding{refused.subject() + " must be " + either(names) + ", found " +
                 (is_number && types[0] == "integer" ? shown(*refused.value) : json_type(*refused.value))};
}

std::optional<Finding> unknown_choice(const Refused& refused) {
  const json* rule = refused.rule_with("enum");
  if (rule == nullptr) return std::nullopt;
  std::vector<std::string> known;
  for (const json& choice : (*rule)["enum"])
    known.push_back(choice.is_string() ? choice.get<std::string>() : choice.dump());
  if (!refused.value->is_string())
    return Finding{refused.subject() + " must be " + either(known) + ", not " + shown(*refused.value)};
  return Finding{"unknown " + refused.title() + " " + shown(*refused.value),
                 unknown_name_remedy(refused.value->get<std::string>(), known)};
}

std::optional<Finding> unfit_text(const Refused& refused) {
  const json* rule = refused.rule_with("patternErrorMessage");
  if (rule == nullptr) return std::nullopt;
  return Finding{"'" + refused.key + "': " + shown(*refused.value) + " " +
                 (*rule)["patternErrorMessage"].get<std::string>()};
}

std::optional<Finding> empty_text(const Refused& refused) {
  return Finding{refused.is_item ? "one of '" + refused.key + "' is empty" : refused.subject() + " is empty"};
}

std::string range_text(const json& rule) {
  const bool has_least = rule.contains("minimum");
  const bool has_most = rule.contains("maximum");
  if (has_least && has_most) return " from " + rule["minimum"].dump() + " to " + rule["maximum"].dump();
  if (has_least) return " of at least " + rule["minimum"].dump();
  const std::string most = has_most ? "at most " + rule["maximum"].dump() : "";
  if (!rule.contains("exclusiveMinimum")) return " of " + most;
  return " above " + rule["exclusiveMinimum"].dump() + (has_most ? " and " + most : "");
}

std::optional<Finding> out_of_range(const Refused& refused) {
  const double value = refused.value->get<double>();
  for (const json* rule : refused.rules) {
    const bool is_within =
        (!rule->contains("minimum") || value >= (*rule)["minimum"].get<double>()) &&
        (!rule->contains("maximum") || value <= (*rule)["maximum"].get<double>()) &&
        (!rule->contains("exclusiveMinimum") || value > (*rule)["exclusiveMinimum"].get<double>());
    if (is_within) continue;
    return Finding{refused.subject() + " must be " + in_words(rule->value("type", "number")) +
                   range_text(*rule) + ", not " + shown(*refused.value)};
  }
  return std::nullopt;
}

// Returns the message for a list of a fixed length, such as a range or a size.
std::optional<Finding> wrong_length(const Refused& refused, const json& rule) {
  if (rule.value("minItems", 0) != rule.value("maxItems", -1)) return std::nullopt;
  const std::string type = rule["items"].value("type", "value");
  return Finding{refused.subject() + " must be an array of " + rule["maxItems"].dump() +
                 (type == "integer" ? " whole number" : " " + type) + "s, found " +
                 std::to_string(refused.value->size())};
}

std::optional<Finding> too_few(const Refused& refused) {
  const json* rule = refused.rule_with("minItems");
  if (rule == nullptr) return std::nullopt;
  if (std::optional<Finding> finding = wrong_length(refused, *rule)) return finding;
  return Finding{refused.subject() + " is empty"};
}

std::optional<Finding> too_many(const Refused& refused) {
  for (const char* keyword : {"maxItems", "maxProperties"}) {
    const json* rule = refused.rule_with(keyword);
    if (rule == nullptr) continue;
    if (std::optional<Finding> finding = wrong_length(refused, *rule)) return finding;
    return Finding{"there are " + std::to_string(refused.value->size()) + " " + refused.title() +
                       ", and at most " + (*rule)[keyword].dump() + " can be checked",
                   "leave some out, or split them"};
  }
  return std::nullopt;
}

std::optional<Finding> missing_companion(const Refused& refused) {
  const json* rule = refused.rule_with("dependencies");
  if (rule == nullptr) return std::nullopt;
  for (const auto& [key, companions] : (*rule)["dependencies"].items())
    for (const json& companion : companions)
      if (refused.value->contains(key) && !refused.value->contains(companion.get_ref<const std::string&>()))
        return Finding{"'" + key + "' needs " + shown(companion) + ", which is missing", "", key};
  return std::nullopt;
}

std::optional<Finding> forbidden_key(const Refused& refused) {
  for (const json* rule : refused.rules) {
    if (!rule->contains("not")) continue;
    const auto key = (*rule)["not"]["required"][0].get<std::string>();
    if (refused.value->contains(key))
      return Finding{"'" + key + "': " + (*rule)["errorMessage"].get<std::string>(), "leave it out", key};
  }
  return std::nullopt;
}

std::optional<Finding> no_choice(const Refused& refused) {
  const json* rule = refused.rule_with("oneOf");
  if (rule == nullptr) return std::nullopt;
  return Finding{(*rule)["errorMessage"]};
}

std::optional<Finding> missing_key(const Refused& refused) {
  for (const json* rule : refused.rules)
    for (const json& key : rule->value("required", json::array()))
      if (!refused.value->contains(key.get_ref<const std::string&>()))
        return Finding{shown(key) + " is missing"};
  return std::nullopt;
}

// A row has a keyword of the schema, valijson's words for a value that breaks it, and the message. Where a
// value breaks several keywords, the first row counts: a misspelt key is also a missing one.
struct Message {
  const char* keyword;
  const char* phrase;
  std::optional<Finding> (*finding)(const Refused&);
};

constexpr std::array kMessages{
    Message{"additionalProperties", "'additionalProperties' constraints", unknown_key},
    Message{"type", "'type' constraint", wrong_type},
    Message{"enum", "any enum values", unknown_choice},
    Message{"minLength", "String should be no fewer", empty_text},
    Message{"pattern", "'pattern' constraint", unfit_text},
    Message{"minimum", "Expected number greater", out_of_range},
    Message{"maximum", "Expected number less", out_of_range},
    Message{"minItems", "Array should contain no fewer", too_few},
    Message{"maxItems", "Array should contain no more", too_many},
    Message{"maxProperties", "Object should have no more", too_many},
    Message{"dependencies", "Missing dependency", missing_companion},
    Message{"not", "'not' constraint", forbidden_key},
    Message{"oneOf", "allowed by oneOf", no_choice},
    Message{"oneOf", "exactly one child schema", no_choice},
    Message{"required", "Missing required property", missing_key}};

// A regular expression of the standard library uses the stack for each character of a text, and valijson
// keeps an error for each value.
constexpr std::size_t kLongestText = 1000;
constexpr std::size_t kMostValues = 500'000;

// The check covers every text and every key: they become code, comments and documents of several languages.
// `name` is the name in messages of a text that is no key's value.
void require_lines(const LocatedJson& manifest, const json& value, const LocatedJson::Pointer& at,
                   const std::string& name, std::size_t& values) {
  if (++values > kMostValues)
    throw InputError(manifest.where(at), "a manifest has at most " + std::to_string(kMostValues) + " values",
                     "split it");
  const auto require = [&](const LocatedJson::Pointer& place, const std::string& text) {
    if (!is_one_line(text))
      throw InputError(manifest.where(place),
                       "'" + name + "' is one line, without control characters and marks of direction",
                       "write spaces in their place");
    if (text.size() > kLongestText)
      throw InputError(manifest.where(place), "a text of a manifest has at most " +
                                                  std::to_string(kLongestText) + " bytes, and this one " +
                                                  std::to_string(text.size()));
  };
  if (value.is_string()) require(at, value.get_ref<const std::string&>());
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) require_lines(manifest, value[i], at / i, name, values);
  if (!value.is_object()) return;
  for (const auto& [key, member] : value.items()) {
    require(at / key, key);
    require_lines(manifest, member, at / key, key, values);
  }
}

// An error of valijson's that a row of the table is for.
struct Violation {
  std::uint32_t place = 0;
  std::size_t row = 0;
  const valijson::ValidationResults::Error* error = nullptr;
};

}  // namespace

void check_manifest(const LocatedJson& manifest) {
  std::size_t values = 0;
  require_lines(manifest, manifest.value(), LocatedJson::Pointer(), "manifest", values);
  const Adapter adapter(manifest.value());
  valijson::Validator validator;
  if (validator.validate(parsed_schema(), adapter, nullptr)) return;
  valijson::ValidationResults results;
  validator.validate(parsed_schema(), adapter, &results);
  std::vector<Violation> violations;
  for (const valijson::ValidationResults::Error& error : results)
    for (std::size_t row = 0; row < kMessages.size(); ++row)
      if (error.description.find(kMessages[row].phrase) != std::string::npos)
        violations.push_back({manifest.order(place_of(error.context)), row, &error});
  std::sort(violations.begin(), violations.end(), [](const Violation& a, const Violation& b) {
    return std::tie(a.place, a.row) < std::tie(b.place, b.row);
  });
  for (const Violation& violation : violations) {
    const Refused refused = refused_at(violation.error->context, manifest.value());
    const std::optional<Finding> finding = kMessages[violation.row].finding(refused);
    if (finding)
      throw InputError(manifest.where(finding->member.empty() ? refused.at : refused.at / finding->member),
                       finding->problem, finding->remedy);
  }
  throw InputError(manifest.where(LocatedJson::Pointer()), "the manifest is not what its schema says",
                   results.begin()->description);
}

}  // namespace penumbra::techniques
