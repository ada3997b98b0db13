#include "generator/descriptor/schema_check.hpp"

// Of a schema that is none, valijson throws; without this it aborts.
#define VALIJSON_USE_EXCEPTIONS 1

#include <cctype>
#include <exception>
#include <optional>
#include <set>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "generator/diagnostic/suggest.hpp"
#include "generator/file/installed_file.hpp"

namespace finemote::gen {
namespace {

using Plain = nlohmann::json;

struct SchemaViolation {
  JsonPath path;
  std::string words;
  bool is_unknown = false;  ///< the path ends in a member that should not be there
  bool is_missing = false;  ///< the object at the path lacks one
  std::string note, hint;
  std::string meant;
};

/// What a schema says of the values at a path: walks `properties`, `items` and `$ref` into its definitions.
class SchemaView {
 public:
  explicit SchemaView(const Plain& schema) : root_(schema) {}

  /// Null where the schema says nothing.
  [[nodiscard]] const Plain* at(const JsonPath& path) const {
    const Plain* node = follow(&root_);
    for (const std::string& step : path) node = node == nullptr ? nullptr : follow(below(*node, step));
    return node;
  }
  /// Names of the members an object at the path can have.
  [[nodiscard]] std::vector<std::string> members(const JsonPath& path) const {
    std::vector<std::string> names;
    const Plain* node = at(path);
    if (node == nullptr || !node->contains("properties")) return names;
    for (const auto& [name, value] : (*node)["properties"].items()) names.push_back(name);
    return names;
  }

 private:
  [[nodiscard]] static const Plain* below(const Plain& node, const std::string& step) {
    const auto properties = node.find("properties");
    if (properties != node.end() && properties->contains(step)) return &(*properties)[step];
    for (const char* rest : {"items", "additionalProperties"}) {
      const auto found = node.find(rest);
      if (found != node.end() && found->is_object()) return &*found;
    }
    return nullptr;
  }
  [[nodiscard]] const Plain* follow(const Plain* node) const {
    constexpr std::string_view kLocal = "#/definitions/";
    for (int steps = 0; node != nullptr && node->is_object() && node->contains("$ref") && steps < 8; ++steps) {
      const std::string target = (*node)["$ref"].get<std::string>();
      if (target.compare(0, kLocal.size(), kLocal) != 0) return nullptr;
      const auto& definitions = root_["definitions"];
      const auto found = definitions.find(target.substr(kLocal.size()));
      node = found == definitions.end() ? nullptr : &*found;
    }
    return node != nullptr && node->is_object() ? node : nullptr;
  }

  const Plain& root_;
};

/// The value at a path, null when there is none.
const Plain* value_at(const Plain& root, const JsonPath& path) {
  const Plain* node = &root;
  for (const std::string& step : path) {
    if (node->is_object() && node->contains(step)) {
      node = &(*node)[step];
    } else if (node->is_array() && !step.empty() && step.find_first_not_of("0123456789") == std::string::npos &&
               std::stoul(step) < node->size()) {
      node = &(*node)[std::stoul(step)];
    } else {
      return nullptr;
    }
  }
  return node;
}

std::string as_text(const Plain& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// The only name that is near; empty when there is none, or several.
std::string only_near(const std::string& word, const std::vector<std::string>& candidates) {
  const std::vector<std::string> near = nearest_names(word, candidates);
  return near.size() == 1 ? near.front() : std::string();
}

/// Adds what the schema says of the place: the values or the type it wants, and its description.
void add_advice(SchemaViolation& violation, const SchemaView& schema, const Plain& document) {
  if (violation.is_unknown) {
    const JsonPath parent(violation.path.begin(), violation.path.end() - 1);
    violation.hint = did_you_mean(violation.path.back(), schema.members(parent));
    violation.meant = only_near(violation.path.back(), schema.members(parent));
    return;
  }
  if (violation.is_missing) return;
  const Plain* node = schema.at(violation.path);
  const Plain* value = value_at(document, violation.path);
  if (node == nullptr || value == nullptr) return;
  std::vector<std::string> choices;
  if (const auto list = node->find("enum"); list != node->end()) {
    for (const Plain& choice : *list) choices.push_back(as_text(choice));
  }
  if (const auto only = node->find("const"); only != node->end()) choices.push_back(as_text(*only));
  if (!choices.empty()) {
    violation.hint = did_you_mean(as_text(*value), choices);
    violation.meant = only_near(as_text(*value), choices);
  } else if (const auto type = node->find("type"); type != node->end() && type->is_string()) {
    violation.hint = "expected: " + type->get<std::string>();
  }
  violation.note = node->value("description", "");
}

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
std::optional<SchemaViolation> reword(const valijson::ValidationResults::Error& error) {
  SchemaViolation violation{to_path(error.context), error.description, false, false, {}, {}, {}};
  const std::string& words = error.description;
  if (starts_with(words, "Failed to validate")) return {};
  if (starts_with(words, "Missing required property")) {
    violation.is_missing = true;
    violation.words = "the member '" + last_quoted(words) + "' is missing";
  } else if (starts_with(words, "Object contains a property")) {
    violation.path.push_back(last_quoted(words));
    violation.is_unknown = true;
    violation.words = "unknown member";
  } else if (starts_with(words, "Value type")) {
    violation.words = "the value has the wrong type";
  } else if (starts_with(words, "Failed to match regex")) {
    violation.words = "the text does not have the right form";
  } else if (starts_with(words, "Failed to match against any enum")) {
    violation.words = "the value is not one of the allowed values";
  } else {
    violation.words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(violation.words[0])));
    while (violation.words.back() == '.') violation.words.pop_back();
    if (constexpr std::string_view kZeros = ".000000"; violation.words.ends_with(kZeros))
      violation.words.resize(violation.words.size() - kZeros.size());
  }
  return violation;
}

std::vector<SchemaViolation> collect(valijson::ValidationResults& results) {
  std::vector<SchemaViolation> all;
  std::set<std::pair<JsonPath, std::string>> known;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    auto violation = reword(error);
    if (violation && known.emplace(violation->path, violation->words).second) all.push_back(std::move(*violation));
  }
  if (all.empty()) all.push_back({{}, "it does not match the schema", false, false, {}, {}, {}});
  return all;
}

std::string shown(const JsonPath& path) {
  std::string text;
  for (const std::string& step : path) text += "/" + step;
  return text.empty() ? "/" : text;
}

}  // namespace

std::vector<SchemaMistake> check_schema(const Json& value, const std::string& schema_text, const Origin& origin,
                                        Diagnostics& diagnostics) {
  // valijson knows nlohmann's unordered values only
  const auto schema_json = Plain::parse(schema_text);
  const auto plain = Plain(value);
  valijson::Schema schema;
  try {
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
  } catch (const std::exception&) {  // all that valijson says of a schema that is none
    diagnostics.error(code::data_not_found, {}, "a JSON Schema in the data folder is damaged").hint(kInstallAgain);
    return {SchemaMistake{}};
  }
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(plain), &results)) return {};
  constexpr std::size_t kMostShown = 100;  // each is looked for from the beginning of the file
  const Origin own_text(*origin.layers().front());
  std::vector<SchemaMistake> mistakes;
  for (SchemaViolation& violation : collect(results)) {
    add_advice(violation, SchemaView(schema_json), plain);
    mistakes.push_back({violation.path, violation.is_unknown, violation.meant});
    if (mistakes.size() > kMostShown) continue;
    const Origin& shown_in = violation.is_missing ? own_text : origin;  // the file itself could have what is missing
    const Extent extent = find_value(shown_in, violation.path);
    Diagnostic& finding =
        diagnostics.error(code::descriptor_schema, extent.at, "'" + shown(violation.path) + "': " + violation.words);
    finding.underline(extent.length);
    if (!violation.note.empty()) finding.note(violation.note);
    if (!violation.hint.empty()) finding.hint(violation.hint);
    if (mistakes.size() == kMostShown) finding.note("further mistakes of this file are not shown");
  }
  return mistakes;
}

}  // namespace finemote::gen
