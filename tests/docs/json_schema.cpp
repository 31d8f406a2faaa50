#include "json_schema.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace pardel::testing {
namespace {

using Json = nlohmann::json;

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

bool has_any_type(const Json& value, const Json& types) {
  if (types.is_string()) return has_type(value, types);
  return std::any_of(types.begin(), types.end(), [&](const Json& type) { return has_type(value, type); });
}

class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  void validate(const Json& schema, const Json& value, const std::string& place) {
    static const std::set<std::string> known = {"$schema",
                                                "$id",
                                                "$defs",
                                                "$ref",
                                                "title",
                                                "description",
                                                "type",
                                                "const",
                                                "enum",
                                                "minimum",
                                                "pattern",
                                                "items",
                                                "minItems",
                                                "maxItems",
                                                "properties",
                                                "required",
                                                "additionalProperties",
                                                "propertyNames"};
    for (const auto& [keyword, ignored] : schema.items()) {
      if (!known.contains(keyword)) fail(place, "the schema uses " + keyword + ", which this validator does not know");
    }
    if (schema.contains("$ref")) validate(referenced(schema["$ref"]), value, place);
    if (schema.contains("type") && !has_any_type(value, schema["type"])) {
      return fail(place, "expected " + schema["type"].dump() + ", found " + value.dump());
    }
    if (schema.contains("const") && value != schema["const"]) fail(place, "expected " + schema["const"].dump());
    if (schema.contains("enum")) {
      const Json& choices = schema["enum"];
      if (std::find(choices.begin(), choices.end(), value) == choices.end()) fail(place, "is not in the enumeration");
    }
    if (value.is_number() && schema.contains("minimum") && value < schema["minimum"]) fail(place, "is too small");
    if (value.is_string() && schema.contains("pattern") &&
        !std::regex_search(value.get<std::string>(), std::regex(schema["pattern"].get<std::string>()))) {
      fail(place, "does not match the pattern");
    }
    if (value.is_array()) validate_array(schema, value, place);
    if (value.is_object()) validate_object(schema, value, place);
  }

  std::vector<std::string> violations;

 private:
  void fail(const std::string& place, const std::string& message) { violations.push_back(place + ": " + message); }

  const Json& referenced(const std::string& reference) const {
    return root_.at(Json::json_pointer(reference.substr(1)));
  }

  void validate_array(const Json& schema, const Json& value, const std::string& place) {
    if (schema.contains("minItems") && value.size() < schema["minItems"]) fail(place, "has too few items");
    if (schema.contains("maxItems") && value.size() > schema["maxItems"]) fail(place, "has too many items");
    for (std::size_t i = 0; schema.contains("items") && i < value.size(); ++i) {
      validate(schema["items"], value[i], place + "/" + std::to_string(i));
    }
  }

  void validate_object(const Json& schema, const Json& value, const std::string& place) {
    for (const Json& key : schema.value("required", Json::array())) {
      if (!value.contains(key)) fail(place, "lacks " + key.dump());
    }
    const Json properties = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    for (const auto& [key, member] : value.items()) {
      const std::string inside = place + "/" + key;
      if (schema.contains("propertyNames")) validate(schema["propertyNames"], key, inside);
      if (properties.contains(key)) {
        validate(properties[key], member, inside);
      } else if (others == false) {
        fail(inside, "is an unknown key");
      } else if (others.is_object()) {
        validate(others, member, inside);
      }
    }
  }

  const Json& root_;
};

}  // namespace

std::vector<std::string> schema_violations(const Json& schema, const Json& value) {
  Validator validator(schema);
  validator.validate(schema, value, "");
  return validator.violations;
}

}  // namespace pardel::testing
