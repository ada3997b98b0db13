// finemote schema: the schemas that editors and other tools use.
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
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
    {"xsd", "finemote.xsd", "the <finemote> elements of a URDF (XML Schema)"},
    {"json", "device.schema.json", "another name of 'device'"},
};

using Json = nlohmann::ordered_json;

int list_schemas(Context& context) {
  Json list = Json::array();
  for (const Schema& schema : kSchemas) {
    list.push_back({{"name", schema.name}, {"of", schema.of}});
    if (context.options.format == Format::text) context.out << fmt::format("{:<9} {}\n", schema.name, schema.of);
  }
  return finish(context, kExitYes, Json{{"schema", "finemote.schemas/1"}, {"schemas", list}});
}

/// As text, and where it is JSON by itself, as it is; else inside a document.
int print_schema(Context& context, const Schema& schema, const std::string& text) {
  const Format format = context.options.format;
  const bool is_json = Json::accept(text);
  if (format == Format::text || (format == Format::json && is_json)) {
    context.out << text;
    return finish(context, kExitYes);
  }
  return finish(context, kExitYes, Json{{"schema", "finemote.schema/1"}, {"name", schema.name}, {"text", text}});
}

}  // namespace

int run_schema(Context& context) {
  if (context.options.input.empty()) return list_schemas(context);
  const std::string data_dir = find_data_dir(context.options, context.diagnostics);
  if (data_dir.empty()) return finish(context, kExitInvalid);
  std::vector<std::string> names;
  for (const Schema& schema : kSchemas) {
    names.emplace_back(schema.name);
    if (context.options.input != schema.name) continue;
    const auto text = read_data_file(data_dir + "/schemas/" + schema.file, context.diagnostics);
    return text ? print_schema(context, schema, *text) : finish(context, kExitInvalid);
  }
  context.diagnostics.error(code::usage, {}, fmt::format("there is no schema '{}'", context.options.input))
      .hint(did_you_mean(context.options.input, names));
  return finish(context, kExitInvalid);
}

}  // namespace finemote::gen
