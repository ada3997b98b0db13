#include "generator/cli/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "generator/diagnostic/code_project.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/file/inside.hpp"
#include "generator/input/input.hpp"
#include "generator/json/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using json::Value;
using Pairs = std::vector<std::pair<std::string, std::string>>;

/// What a member of the file is, and where its value goes.
struct Member {
  enum class Is { text, texts, folders, arguments, packages };
  const char* name;
  Is kind;
  std::variant<std::monostate, std::string Options::*, std::vector<std::string> Options::*> target;
  const char* example;
};

const Member kMembers[] = {
    {"board", Member::Is::text, &Options::board, R"("robomaster_type_c")"},
    {"device-path", Member::Is::folders, &Options::device_paths, R"(["parts"])"},
    {"package", Member::Is::packages, {}, R"({"my_parts": "my_parts"})"},
    {"arguments", Member::Is::arguments, {}, R"({"period": "20ms"})"},
    {"chain", Member::Is::texts, &Options::chains, R"(["imu -> thruster_1"])"},
    {"profile", Member::Is::text, &Options::profile, R"("target")"},
    {"assume-wcet", Member::Is::text, &Options::assume_wcet, R"("50us")"},
    {"allow", Member::Is::texts, &Options::allow, R"(["FM3153"])"},
    {"deny", Member::Is::texts, &Options::deny, R"(["FM3151"])"},
};

/// Options that a file of a stranger must not bring.
constexpr const char* kCommandLineOnly[] = {"force", "data-dir", "output", "sandbox"};

/// Reads one file over the options of a command line.
class Reader {
 public:
  Reader(const Options& given, const SourceFile& file, Diagnostics& diagnostics)
      : given_(given), file_(file), diagnostics_(diagnostics), folder_(input_folder(given.input)) {}

  Settings run(const Value& document) {
    settings_.options = given_;
    if (!document.is(Value::Kind::object)) {
      report(document, "settings are an object").hint("write for example { \"board\": \"robomaster_type_c\" }");
      return std::move(settings_);
    }
    for (const json::Member& member : document.members) {
      if (is_known(member)) read(*find(member.key), member.value);
    }
    return std::move(settings_);
  }

 private:
  static const Member* find(const std::string& name) {
    const auto found = std::find_if(std::begin(kMembers), std::end(kMembers),
                                    [&](const Member& member) { return member.name == name; });
    return found == std::end(kMembers) ? nullptr : found;
  }

  bool is_known(const json::Member& member) {
    if (find(member.key) != nullptr) return true;
    if (member.key == "$schema") return false;  // for editors
    const bool is_refused = std::count(std::begin(kCommandLineOnly), std::end(kCommandLineOnly), member.key) > 0;
    auto& finding = diagnostics_.error(code::project_settings, member.at,
                                       is_refused ? fmt::format("'{}' cannot be set in {}", member.key, kSettingsName)
                                                  : fmt::format("there is no setting '{}'", member.key));
    std::vector<std::string> names;
    for (const Member& known : kMembers) names.emplace_back(known.name);
    if (is_refused)
      finding.hint("give it on the command line");
    else
      suggest(finding, member.key, names);
    return false;
  }

  Diagnostic& report(const Value& value, std::string message) {
    Diagnostic& finding = diagnostics_.error(code::project_settings, value.at, std::move(message));
    finding.length = value.length;
    return finding;
  }

  void refuse(const Member& member, const Value& value) {
    report(value, fmt::format("'{}' cannot be {}", member.name, json::describe(value.kind)))
        .hint(fmt::format("write for example \"{}\": {}", member.name, member.example));
  }

  void read(const Member& member, const Value& value) {
    switch (member.kind) {
      case Member::Is::text:
        return read_text(member, value);
      case Member::Is::texts:
      case Member::Is::folders:
        return read_texts(member, value);
      case Member::Is::arguments:
        return read_pairs(member, value, arguments());
      case Member::Is::packages:
        return read_pairs(member, value, packages());
    }
  }

  void read_text(const Member& member, const Value& value) {
    if (!value.is(Value::Kind::string)) return refuse(member, value);
    std::string& option = settings_.options.*std::get<std::string Options::*>(member.target);
    if (!option.empty()) return;
    option = value.text;
    add(member.name, value.text, value);
  }

  void read_texts(const Member& member, const Value& value) {
    if (!value.is(Value::Kind::array)) return refuse(member, value);
    auto& option = settings_.options.*std::get<std::vector<std::string> Options::*>(member.target);
    const bool is_given = !option.empty();
    std::vector<std::string> texts;
    for (const Value& item : value.items) {
      if (!item.is(Value::Kind::string)) return refuse(member, item);
      const auto text = member.kind == Member::Is::folders ? inside(item) : item.text;
      if (text) texts.push_back(*text);
    }
    if (is_given) return;
    option = texts;
    add(member.name, fmt::format("{}", fmt::join(texts, ", ")), value);
  }

  /// Where the pairs of an object go that the command line has none of.
  struct Target {
    std::vector<std::string> given;  ///< their names
    bool are_folders;
    void (*add)(Options& options, const std::string& name, const std::string& value);
  };

  [[nodiscard]] Target arguments() const {
    Target target{{}, false, [](Options& options, const std::string& name, const std::string& value) {
                    if (is_xacro(options.input)) options.arguments.emplace_back(name, value);
                  }};
    for (const auto& [name, value] : given_.arguments) target.given.push_back(name);
    return target;
  }

  [[nodiscard]] Target packages() const {
    Target target{{}, true, [](Options& options, const std::string& name, const std::string& value) {
                    options.packages.push_back(name + "=" + value);
                  }};
    for (const std::string& word : given_.packages) {
      if (const auto package = package_of(word)) target.given.push_back(package->first);
    }
    return target;
  }

  void read_pairs(const Member& member, const Value& value, const Target& target) {
    if (!value.is(Value::Kind::object)) return refuse(member, value);
    for (const json::Member& pair : value.members) {
      if (!pair.value.is(Value::Kind::string)) return refuse(member, pair.value);
      const auto text = target.are_folders ? inside(pair.value) : pair.value.text;
      if (!text || std::count(target.given.begin(), target.given.end(), pair.key) > 0) continue;
      target.add(settings_.options, pair.key, *text);
      add(fmt::format("{}.{}", member.name, pair.key), *text, pair.value);
    }
  }

  /// A folder below that of the file, as seen from the working directory.
  std::optional<std::string> inside(const Value& value) {
    std::error_code failed;
    const fs::path folder = fs::weakly_canonical(folder_, failed);
    const fs::path named = fs::weakly_canonical(folder / value.text, failed);
    if (!failed && !fs::path(value.text).is_absolute() && gen::inside(named, folder))
      return (fs::path(folder_) / value.text).lexically_normal().generic_string();
    report(value, fmt::format("'{}' lies outside the folder of {}", value.text, kSettingsName))
        .hint("name a folder below it, or give the folder on the command line");
    return std::nullopt;
  }

  void add(const std::string& name, const std::string& text, const Value& value) {
    settings_.list.push_back({name, text, fmt::format("{}:{}", file_.name, value.at.line)});
  }

  const Options& given_;
  const SourceFile& file_;
  Diagnostics& diagnostics_;
  std::string folder_;
  Settings settings_;
};

/// Every setting there is: those of the file, those of the command line, and the others.
void complete(const Options& given, std::vector<Setting>& list) {
  std::vector<Setting> all;
  const auto from_file = [&](const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const Setting& setting) { return setting.name == name; });
  };
  const auto add_group = [&](const std::string& name, const Pairs& pairs) {
    for (const auto& [key, value] : pairs) all.push_back({name + "." + key, value, "command line"});
    for (const Setting& setting : list) {
      if (setting.name.starts_with(name + ".")) all.push_back(setting);
    }
  };
  for (const Member& member : kMembers) {
    std::string text;
    if (const auto* one = std::get_if<std::string Options::*>(&member.target)) text = given.*(*one);
    if (const auto* many = std::get_if<std::vector<std::string> Options::*>(&member.target))
      text = fmt::format("{}", fmt::join(given.*(*many), ", "));
    if (member.kind == Member::Is::arguments) {
      add_group(member.name, given.arguments);
    } else if (member.kind == Member::Is::packages) {
      Pairs pairs;
      for (const std::string& word : given.packages) {
        if (auto package = package_of(word)) pairs.push_back(std::move(*package));
      }
      add_group(member.name, pairs);
    } else if (const auto found = from_file(member.name); found != list.end()) {
      all.push_back(*found);
    } else {
      all.push_back({member.name, text, text.empty() ? "default" : "command line"});
    }
  }
  list = std::move(all);
}

/// The file beside the robot; null where there is none, or the input has no folder.
const SourceFile* read_file_of(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  if (options.input == "-" || is_timing_model(options.input)) return nullptr;
  const fs::path path = fs::path(input_folder(options.input)) / kSettingsName;
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(path, ignored))) return nullptr;
  return xml::read_source(path.lexically_normal().generic_string(), sources, diagnostics);
}

}  // namespace

Settings settings_of(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  Settings settings{options, {}};
  if (const SourceFile* file = read_file_of(options, sources, diagnostics)) {
    const auto document = json::parse(*file, diagnostics);
    if (document) settings = Reader(options, *file, diagnostics).run(*document);
  }
  complete(options, settings.list);
  return settings;
}

Answer settings_answer(const Settings& settings) {
  Answer answer{kExitYes};
  auto list = nlohmann::ordered_json::array();
  for (const auto& [name, value, from] : settings.list) {
    answer.text += fmt::format("{:<20} {:<28} {}\n", name, value.empty() ? "-" : value, from);
    list.push_back({{"name", name}, {"value", value}, {"from", from}});
  }
  answer.document = {{"schema", "finemote.settings/1"}, {"settings", list}};
  return answer;
}

}  // namespace finemote::gen
