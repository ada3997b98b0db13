// finemote schema: the schemas that editors and other tools use.
#include <fmt/format.h>

#include <map>

#include "generator/cli/commands.hpp"
#include "generator/cli/data_dir.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {

int run_schema(Context& context) {
  static const std::map<std::string, std::string> kFiles{{"xsd", "finemote.xsd"},
                                                         {"json", "device.schema.json"},
                                                         {"board", "board.schema.json"},
                                                         {"expander", "expander.schema.json"}};
  const std::string data_dir = find_data_dir(context.options, context.diagnostics);
  if (data_dir.empty()) return finish(context, kExitInvalid);
  const auto file = kFiles.find(context.options.input);
  if (file == kFiles.end()) {
    context.diagnostics.error(code::usage, {}, fmt::format("there is no schema '{}'", context.options.input))
        .hint("valid here: 'xsd', 'json', 'board', 'expander'");
    return finish(context, kExitInvalid);
  }
  context.out << read_bytes(data_dir + "/schemas/" + file->second).value_or("");
  return finish(context, kExitYes);
}

}  // namespace finemote::gen
