// finemote diff: what changed between two robots, models or generated folders: first in words, then as text.
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"
#include "generator/output/folder.hpp"
#include "generator/output/unified_diff.hpp"
#include "generator/schedule/period.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One side: facts of the model by subject (`device 'imu'`) and property, and texts by file name.
struct Side {
  std::map<std::string, std::map<std::string, std::string>> facts;
  std::map<std::string, std::string> texts;
};

void add_device(const Loaded& loaded, std::size_t index, Side& side) {
  const Robot& robot = loaded.robot;
  const Device& device = robot.devices[index];
  auto& facts = side.facts[fmt::format("device '{}'", device.name.text)];
  facts["type"] = device.type->name;
  facts["parent"] = device.parent ? robot.devices[*device.parent].name.text : "none";
  facts["period"] = period_text(device.period_ns);
  facts["place"] = device_comment(loaded.plan(), index);
  facts["position in the schedule"] = std::to_string(loaded.forest.rank[index] + 1);
  facts["wcet"] = fmt::format("update {} ns, handle {} ns", device.wcet.update_ns, device.wcet.handle_ns);
  for (const Param& param : device.params) {
    facts["param '" + param.spec->name + "'"] =
        std::visit([](const auto& value) { return fmt::format("{}", value); }, param.value);
  }
}

Side robot_side(const Loaded& loaded, const std::vector<OutputFile>& files) {
  Side side;
  const Robot& robot = loaded.robot;
  side.facts["robot"] = {{"name", robot.name.text}, {"board", robot.board->name}, {"tick", period_text(robot.tick_ns)}};
  for (const Bus& bus : robot.buses) {
    side.facts[fmt::format("bus '{}'", bus.name.text)] = {{"port", bus.port}, {"rate", std::to_string(bus.rate)}};
  }
  for (std::size_t device = 0; device < robot.devices.size(); ++device) add_device(loaded, device, side);
  for (const OutputFile& file : files) side.texts[file.name] = file.text;
  return side;
}

std::optional<Side> folder_side(Context& context, const std::string& folder) {
  const files::Access& access = context.sources.access();
  const auto text = access.read(folder + "/" + kManifestName, xml::kMaxFileSize);
  const auto manifest = text ? parse_manifest(*text) : std::nullopt;
  if (!manifest) {
    context.diagnostics.error(code::broken_manifest, {},
                              fmt::format("'{}' is no folder that finemote generated", folder));
    return std::nullopt;
  }
  Side side;
  for (const HashedFile& file : manifest->outputs)
    side.texts[file.name] = access.read(folder + "/" + file.name, xml::kMaxFileSize).value_or("");
  return side;
}

/// A `.json` model: every device and bus member is a fact, the document itself the text.
std::optional<Side> model_side(Context& context, const std::string& path) {
  const auto text = context.sources.access().read(path, xml::kMaxFileSize);
  const Json json = Json::parse(text.value_or(""), nullptr, false);
  if (!text || json.is_discarded() || !json.is_object()) {
    context.diagnostics.error(code::unreadable_file, {}, fmt::format("'{}' is no model", path));
    return std::nullopt;
  }
  const Json& model = json.contains("model") ? json["model"] : json;
  Side side;
  side.texts["model.json"] = model.dump(2) + "\n";
  for (const char* list : {"buses", "devices"}) {
    if (!model.contains(list) || !model[list].is_array()) continue;
    for (const Json& entry : model[list]) {
      if (!entry.is_object()) continue;
      const std::string kind = std::string_view(list) == "buses" ? "bus" : "device";
      auto& facts = side.facts[fmt::format("{} '{}'", kind, entry.value("name", ""))];
      for (const auto& [key, value] : entry.items()) {
        if (key != "name") facts[key] = value.dump();
      }
    }
  }
  return side;
}

std::optional<Side> read_side(Context& context, const std::string& operand) {
  if (fs::is_directory(operand)) return folder_side(context, operand);
  if (fs::path(operand).extension() == ".json") return model_side(context, operand);
  Options options = context.options;
  options.input = operand;
  Context side_context{options, context.sources, context.diagnostics, context.out, context.err};
  const auto loaded = load_robot(side_context);
  if (!loaded) return std::nullopt;
  const auto files = render_robot(context, *loaded);
  if (context.diagnostics.has_errors()) return std::nullopt;
  return robot_side(*loaded, files);
}

std::vector<std::string> changes(const Side& a, const Side& b) {
  std::vector<std::string> lines;
  if (a.facts.empty() || b.facts.empty()) return lines;  // a folder: texts alone
  for (const auto& [subject, facts] : a.facts) {
    const auto other = b.facts.find(subject);
    if (other == b.facts.end()) {
      lines.push_back(subject + ": removed");
      continue;
    }
    for (const auto& [property, value] : facts) {
      const auto now = other->second.find(property);
      const std::string after = now == other->second.end() ? "none" : now->second;
      if (after != value) lines.push_back(fmt::format("{}: {} {} -> {}", subject, property, value, after));
    }
    for (const auto& [property, value] : other->second) {
      if (facts.count(property) == 0) lines.push_back(fmt::format("{}: {} none -> {}", subject, property, value));
    }
  }
  for (const auto& [subject, facts] : b.facts) {
    if (a.facts.count(subject) == 0) lines.push_back(subject + ": added");
  }
  return lines;
}

/// The text with the line that names the input like that of `other`: two inputs are two names, and no difference.
std::string with_source_of(std::string text, const std::string& other) {
  const std::string line = std::string(kGeneratedHeader) + "\n// Source: ";
  if (text.rfind(line, 0) != 0 || other.rfind(line, 0) != 0) return text;
  const auto name_of = [&](const std::string& whole) {
    return whole.substr(line.size(), whole.find('\n', line.size()) - line.size());
  };
  return text.replace(line.size(), name_of(text).size(), name_of(other));
}

std::string text_diff(const Side& a, const Side& b) {
  std::map<std::string, std::pair<std::string, std::string>> pairs;
  for (const auto& [name, text] : a.texts) pairs[name].first = text;
  for (const auto& [name, text] : b.texts) pairs[name].second = text;
  std::string diff;
  for (const auto& [name, texts] : pairs)
    diff += unified_diff("a/" + name, texts.first, "b/" + name, with_source_of(texts.second, texts.first));
  return diff;
}

}  // namespace

int run_diff(Context& context) {
  const auto a = read_side(context, context.options.input);
  const auto b = read_side(context, context.options.other);
  if (!a || !b) return finish(context, kExitInvalid);
  const std::vector<std::string> lines = changes(*a, *b);
  const std::string diff = text_diff(*a, *b);
  if (context.options.format == Format::text) {
    for (const std::string& line : lines) context.out << line << "\n";
    context.out << diff;
  }
  const bool same = lines.empty() && diff.empty();
  return finish(context, same ? kExitYes : kExitNo,
                Json{{"schema", "finemote.diff/1"}, {"same", same}, {"changes", lines}, {"diff", diff}});
}

}  // namespace finemote::gen
