#include "generator/xacro/world.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <ostream>

#include "generator/diagnostic/printable.hpp"

namespace finemote::gen::xacro {

const SourceFile* World::open_yaml(const std::string& file) {
  return parts_.files.open_yaml(absolute_name(file), parts_.piece.position());
}

std::optional<std::string> World::environment(const std::string& name) {
  if (hides_environment()) return std::nullopt;
  const char* value = std::getenv(name.c_str());
  return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
}

void World::say(MessageKind kind, const std::string& text, bool with_location) {
  if (kind != MessageKind::message) {
    parts_.warnings.add(code::xacro_message, parts_.piece.position(),
                        kind == MessageKind::error ? "error: " + text : text);
    return;
  }
  if (parts_.messages == nullptr) return;
  std::ostream& out = *parts_.messages;
  // In a sandbox it is a stranger's text for the log of a CI: one line that no terminal and no runner takes for a
  // command.
  if (!text.empty() || !with_location) out << (hides_environment() ? "message: " + printable(text) : text) << '\n';
  if (!with_location) return;
  for (const std::string& line : parts_.trail.lines()) out << line << '\n';
}

void World::deprecated(std::string_view name, std::string_view name_space) {
  parts_.warnings.add(code::xacro_deprecated, parts_.piece.position(),
                      fmt::format("Using {0}() directly is deprecated. Use {1}.{0}() instead.", name, name_space));
}

std::string World::package_folder(const std::string& name) {
  const auto found = parts_.packages.find(name, parts_.access);
  if (!found) {
    Failure failure{code::xacro_package, fmt::format("package '{}' not found", name)};
    const auto places = parts_.packages.places();
    failure.hints.push_back(places.empty() ? fmt::format("say where it is: --package {}=FOLDER{}", name,
                                                         hides_environment() ? "" : ", or set ROS_PACKAGE_PATH")
                                           : fmt::format("searched: {}; say where it is: --package {}=FOLDER",
                                                         fmt::join(places, ", "), name));
    throw failure;
  }
  if (!found->others.empty()) {
    Diagnostic* warning =
        parts_.warnings.add(code::xacro_duplicate_package, parts_.piece.position(),
                            fmt::format("package '{}' is in {} places", name, found->others.size() + 1));
    if (warning != nullptr) {
      warning->note(fmt::format("used: {}", found->folder));
      for (const std::string& other : found->others) warning->note(fmt::format("ignored: {}", other));
    }
  }
  return found->folder;
}

}  // namespace finemote::gen::xacro
