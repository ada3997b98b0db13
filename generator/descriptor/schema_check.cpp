#include "generator/descriptor/schema_check.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
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

bool starts_with(const std::string& text, std::string_view prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

/// What stands between the last pair of quotes, as a member's name.
std::string last_quoted(const std::string& words) {
  const std::size_t end = words.rfind('\'');
  const std::size_t begin = end == std::string::npos || end == 0 ? std::string::npos : words.rfind('\'', end - 1);
  return begin == std::string::npos ? std::string() : words.substr(begin + 1, end - begin - 1);
}

/// valijson's words to ours; a violation that only says that something below is wrong has none.
std::optional<Violation> reword(const valijson::ValidationResults::Error& error) {
  Violation violation{to_path(error.context), error.description};
  const std::string& words = error.description;
  if (starts_with(words, "Failed to validate")) return {};
  if (starts_with(words, "Missing required property")) {
    violation.words = "the member '" + last_quoted(words) + "' is missing";
  } else if (starts_with(words, "Object contains a property")) {
    violation.path.push_back(last_quoted(words));
    violation.words = "there is no member of this name";
  } else if (starts_with(words, "Value type")) {
    violation.words = "the value is of another type";
  } else if (starts_with(words, "Failed to match regex")) {
    violation.words = "the text is not of the right form";
  } else if (starts_with(words, "Failed to match against any enum")) {
    violation.words = "the value is not one of those possible";
  } else {
    violation.words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(violation.words[0])));
    while (violation.words.back() == '.') violation.words.pop_back();
  }
  return violation;
}

std::vector<Violation> collect(valijson::ValidationResults& results) {
  std::vector<Violation> all;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    auto violation = reword(error);
    const bool is_known = violation && std::any_of(all.begin(), all.end(), [&](const Violation& other) {
                            return other.path == violation->path && other.words == violation->words;
                          });
    if (violation && !is_known) all.push_back(std::move(*violation));
  }
  if (all.empty()) all.push_back({{}, "it is not of the form the schema describes"});
  return all;
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
  for (const Violation& violation : collect(results)) {
    const Extent extent = find_value(source, violation.path);
    diagnostics.error(code::descriptor_schema, extent.at, "'" + shown(violation.path) + "': " + violation.words)
        .underline(extent.length);
  }
  return false;
}

}  // namespace finemote::gen
