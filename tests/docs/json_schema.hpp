// A validator for the subset of JSON Schema 2020-12 that docs/report.schema.json uses. A keyword outside the subset is
// an error, so no part of a schema can go unchecked.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pardel::testing {

/// Every violation of `schema` by `value`, as `PLACE: message`; empty if the value is valid. PLACE is a JSON pointer
/// into the value. References are `#/$defs/NAME`, looked up in `schema`.
[[nodiscard]] std::vector<std::string> schema_violations(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace pardel::testing
