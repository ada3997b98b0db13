// What expressions and substitutions may ask of the expansion around them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "generator/xacro/expander.hpp"
#include "generator/xacro/source_failure.hpp"

namespace finemote::gen::xacro {

void Expander::define_builtins() {
  for (auto& [name, value] : expression::global_symbols()) builtins_.set(name, {std::move(value), false, {}});
  define_name_space("python", expression::python_symbols());
  define_name_space("math", expression::math_symbols());
  define_name_space("xacro", expression::xacro_symbols());
}

void Expander::define_name_space(const char* name, expression::Symbols symbols) {
  auto scope = std::make_unique<Scope>(Scope::Kind::name_space, nullptr);
  for (auto& [symbol, value] : symbols) scope->set(symbol, {std::move(value), false, {}});
  builtins_.set(name, {NamespaceRef{scope.get()}, false, {}});
  kept_scopes_.push_back(std::move(scope));
}

Value Expander::load_yaml(const std::string& name) {
  const std::string file = absolute_name(name);
  add_dependency(file);
  const SystemError missing = why_unreadable(file, sources_, current_piece());
  if (missing.number != 0) {
    fail(code::xacro_yaml, fmt::format("[Errno {}] {}: '{}'", missing.number, missing.text, file));
  }
  constexpr std::size_t none = 0;
  if (sources_.access().read(file, none) == "") return {};
  const SourceFile* source = read_text(file, sources_, current_piece());
  return expression::read_yaml(runtime_, *source,
                               [&](const std::string& text) { return evaluate_source(text, builtins_); });
}

std::string Expander::absolute_name(const std::string& file) {
  if (file.starts_with('/')) return file;
  const std::string& current = files_.back();
  const auto slash = current.rfind('/');
  return slash == std::string::npos ? file : current.substr(0, slash + 1) + file;
}

std::optional<std::string> Expander::environment(const std::string& name) {
  if (sources_.access().is_sandbox()) return std::nullopt;
  const char* value = std::getenv(name.c_str());
  return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
}

bool Expander::hides_environment() const { return sources_.access().is_sandbox(); }

const std::string* Expander::argument(const std::string& name) {
  asked_.insert(name);
  const auto found = arguments_.find(name);
  return found != arguments_.end() ? &found->second : nullptr;
}

namespace {

/// A stranger's words for the log of a CI: one line that no terminal and no runner takes for a command.
std::string harmless(std::string text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return "message: " + text;
}

}  // namespace

void Expander::say(MessageKind kind, const std::string& text, bool with_location) {
  if (kind != MessageKind::message) {
    warn(code::xacro_message, current_piece(), kind == MessageKind::error ? "error: " + text : text);
    return;
  }
  if (messages_ == nullptr) return;
  if (!text.empty() || !with_location) *messages_ << (hides_environment() ? harmless(text) : text) << '\n';
  if (!with_location) return;
  for (const std::string& line : location()) *messages_ << line << '\n';
}

void Expander::deprecated(std::string_view name, std::string_view name_space) {
  warn(code::xacro_deprecated, current_piece(),
       fmt::format("Using {0}() directly is deprecated. Use {1}.{0}() instead.", name, name_space));
}

std::optional<Value> Expander::look_up(Scope& scope, const std::string& name) {
  const auto found = scope.find(name);
  if (!found) return std::nullopt;
  return property_value(found, name);
}

void Expander::keep(Scope& scope) {
  for (Scope* s = &scope; s != nullptr && !s->is_kept; s = s->parent()) s->is_kept = true;
}

std::string Expander::package_folder(const std::string& name) {
  const auto found = packages_.find(name, sources_.access());
  if (!found) {
    Failure failure{code::xacro_package, fmt::format("package '{}' not found", name)};
    const auto places = packages_.places();
    failure.hints.push_back(places.empty() ? fmt::format("say where it is: --package {}=FOLDER{}", name,
                                                         hides_environment() ? "" : ", or set ROS_PACKAGE_PATH")
                                           : fmt::format("searched: {}; say where it is: --package {}=FOLDER",
                                                         fmt::join(places, ", "), name));
    throw failure;
  }
  if (!found->others.empty()) {
    Diagnostic* warning = warn(code::xacro_duplicate_package, current_piece(),
                               fmt::format("package '{}' is in {} places", name, found->others.size() + 1));
    if (warning != nullptr) {
      warning->note(fmt::format("used: {}", found->folder));
      for (const std::string& other : found->others) warning->note(fmt::format("ignored: {}", other));
    }
  }
  return found->folder;
}

std::string Expander::evaluate(const std::string& expression) {
  if (expression.find("__") != std::string::npos) {
    fail(code::xacro_substitution, "$(eval ...) may not contain double underscore expressions");
  }
  Scope scope(Scope::Kind::builtins, nullptr);
  for (const auto& [name, value] : arguments_) {
    if (expression.find(name) != std::string::npos) asked_.insert(name);
  }
  for (const auto& [name, value] : arguments_) scope.set(name, {expression::argument_literal(value), false, {}});
  for (auto& [name, value] : expression::math_symbols()) scope.set(name, {std::move(value), false, {}});
  for (const auto& [name, type] :
       {std::pair("list", expression::Type::list), std::pair("dict", expression::Type::dict),
        std::pair("map", expression::Type::map), std::pair("str", expression::Type::text),
        std::pair("float", expression::Type::real), std::pair("int", expression::Type::integer)}) {
    scope.set(name, {type, false, {}});
  }
  scope.set("true", {true, false, {}});
  scope.set("false", {false, false, {}});
  return to_text(runtime_, evaluate_source(expression, scope));
}

}  // namespace finemote::gen::xacro
