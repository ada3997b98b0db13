#include "generator/descriptor/schema_check.hpp"

#include <algorithm>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace finemote::gen {
namespace {

struct Violation {
  JsonPath path;
  std::string words;
};

/// valijson writes a step as `["key"]` or `[index]`, the first one is `<root>`.
JsonPath to_path(const std::vector<std::string>& context) {
  JsonPath path;
  for (const std::string& step : context) {
    if (step.size() < 2 || step.front() != '[') continue;
    const bool is_key = step.size() >= 4 && step[1] == '"';
    path.push_back(is_key ? step.substr(2, step.size() - 4) : step.substr(1, step.size() - 2));
  }
  return path;
}

bool is_ancestor(const JsonPath& above, const JsonPath& below) {
  return above.size() < below.size() && std::equal(above.begin(), above.end(), below.begin());
}

/// Lower case at the begin, no full stop at the end.
std::string tidy(std::string words) {
  if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z') words[0] = static_cast<char>(words[0] - 'A' + 'a');
  while (!words.empty() && words.back() == '.') words.pop_back();
  return words;
}

std::vector<Violation> collect(valijson::ValidationResults& results) {
  std::vector<Violation> all;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) all.push_back({to_path(error.context), tidy(error.description)});
  std::vector<Violation> precise;
  for (const Violation& candidate : all) {
    const bool is_vague = std::any_of(all.begin(), all.end(),
                                      [&](const Violation& other) { return is_ancestor(candidate.path, other.path); });
    const bool is_known = std::any_of(precise.begin(), precise.end(),
                                      [&](const Violation& other) { return other.path == candidate.path; });
    if (!is_vague && !is_known) precise.push_back(candidate);
  }
  return precise;
}

std::string shown(const JsonPath& path) {
  std::string text;
  for (const std::string& step : path) text += "/" + step;
  return text.empty() ? "/" : text;
}

}  // namespace

bool check_schema(const Json& value, const std::string& schema_text, const SourceFile& source,
                  Diagnostics& diagnostics) {
  // valijson knows nlohmann's unordered values only
  const auto schema_json = nlohmann::json::parse(schema_text);
  const auto plain = nlohmann::json::parse(value.dump());
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(plain), &results)) return true;
  const std::string title = schema_json.value("title", "its schema");
  for (const Violation& violation : collect(results)) {
    const Extent extent = find_value(source, violation.path);
    diagnostics.error(code::descriptor_schema, extent.at, "'" + shown(violation.path) + "' is not what " + title + " allows")
        .underline(extent.length)
        .note(violation.words);
  }
  return false;
}

}  // namespace finemote::gen
