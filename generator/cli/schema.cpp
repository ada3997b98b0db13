// finemote schema: the schemas that editors and other tools use.
#include <fmt/format.h>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/descriptor/schema_file.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

struct Schema {
  const char *name, *file, *of;
};
constexpr Schema kSchemas[] = {
    {"device", "device.schema.json", "device descriptors (JSON Schema)"},
    {"expander", "expander.schema.json", "expander descriptors (JSON Schema)"},
    {"board", "board.schema.json", "board files (JSON Schema)"},
    {"scenario", "scenario.schema.json", "scenarios of the emulated board (JSON Schema)"},
    {"settings", "settings.schema.json", "finemote.json beside a robot (JSON Schema)"},
    {"xsd", "finemote.xsd", "the <finemote> elements of a URDF (XML Schema)"},
    {"json", "device.schema.json", "another name of 'device'"},
};

using Json = nlohmann::ordered_json;

Answer list_schemas() {
  Answer answer{kExitYes};
  Json list = Json::array();
  for (const Schema& schema : kSchemas) {
    list.push_back({{"name", schema.name}, {"of", schema.of}});
    answer.text += fmt::format("{:<9} {}\n", schema.name, schema.of);
  }
  answer.document = {{"schema", "finemote.schemas/1"}, {"schemas", list}};
  return answer;
}

/// As it is, and inside a document where one is asked for and it is none by itself.
Answer print_schema(const Schema& schema, const std::string& text) {
  Answer answer{kExitYes, text};
  if (!Json::accept(text)) answer.document = {{"schema", "finemote.schema/1"}, {"name", schema.name}, {"text", text}};
  return answer;
}

}  // namespace

Answer run_schema(const Options& options, Sources& /*sources*/, Diagnostics& diagnostics) {
  if (options.input.empty()) return list_schemas();
  const std::string data_dir = find_data_dir(options.data_dir, diagnostics);
  if (data_dir.empty()) return no_answer();
  std::vector<std::string> names;
  for (const Schema& schema : kSchemas) {
    names.emplace_back(schema.name);
    if (options.input != schema.name) continue;
    const std::string folder = data_dir + "/schemas";
    const auto text = std::string_view(schema.file).ends_with(".json")
                          ? read_schema(folder, schema.file, diagnostics)
                          : read_data_file(folder + "/" + schema.file, diagnostics);
    return text ? print_schema(schema, *text) : no_answer();
  }
  diagnostics.error(code::usage, {}, fmt::format("there is no schema '{}'", options.input))
      .hint(did_you_mean(options.input, names));
  return no_answer();
}

}  // namespace finemote::gen
