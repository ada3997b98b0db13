// The functions of the `xacro.` namespace.
#include <algorithm>

#include "generator/expression/builtins.hpp"
#include "generator/expression/failure.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/yaml.hpp"

namespace finemote::gen::expression {
namespace {

Value load_yaml(Runtime& runtime, const Parameters& p) {
  const SourceFile* file = runtime.services.open_yaml(p.text(0));
  return file != nullptr ? read_yaml(runtime, *file) : Value();
}

Value abs_filename(Runtime& runtime, const Parameters& p) { return runtime.services.absolute_name(p.text(0)); }

/// A dictionary whose items are reached by attributes too.
Value dotify(Runtime& runtime, const Parameters& p) {
  auto dict = std::make_shared<Dict>();
  dict->table = table_of(runtime, p.all(), p.function());
  dict->is_dotted = true;
  return dict;
}

Value arg(Runtime& runtime, const Parameters& p) {
  const std::string* value = runtime.services.argument(p.text(0));
  if (value == nullptr) fail_eval("'" + p.text(0) + "'");
  return *value;
}

/// Cuts a text at any of the separators.
Value tokenize(Runtime& runtime, const Parameters& p) {
  const std::string separators = p[1] != nullptr ? p.text(1) : ",; ";
  const bool skip_empty = p[2] == nullptr || is_true(p.at(2));
  Values parts;
  std::string_view rest = p.text(0);
  runtime.budget.spend(rest.size() + rest.size() / 64 * separators.size());
  for (;;) {
    const auto end = std::min(rest.find_first_of(separators), rest.size());
    if (end > 0 || !skip_empty) parts.emplace_back(rest.substr(0, end));
    if (end == rest.size()) return make_list(std::move(parts));
    rest.remove_prefix(end + 1);
  }
}

std::string joined(Runtime& runtime, const Values& values) {
  std::string text;
  for (const Value& value : values) {
    if (!text.empty()) text += ' ';
    text += to_text(runtime, value);
  }
  return text;
}

template <MessageKind Kind>
Value say(Runtime& runtime, const Parameters& p) {
  bool with_location = Kind != MessageKind::message;
  for (const auto& [name, value] : p.all().named) {
    if (name == "print_location") with_location = is_true(value);
  }
  runtime.services.say(Kind, joined(runtime, p.positional()), with_location);
  return "";
}

Value print_location(Runtime& runtime, const Parameters& /*any*/) {
  runtime.services.say(MessageKind::message, "", true);
  return "";
}

Value fatal(Runtime& runtime, const Parameters& p) { fail(code::xacro_fatal, joined(runtime, p.positional())); }

constexpr Signature kFile({"filename"}, 1);
constexpr Signature kFileSpecification({"filename_spec"}, 1);

constexpr Builtin kOld[] = {{"load_yaml", kFile, load_yaml, "xacro"},
                            {"abs_filename", kFileSpecification, abs_filename, "xacro"},
                            {"dotify", Signature::free(), dotify, "xacro"}};
constexpr Builtin kXacro[] = {{"load_yaml", kFile, load_yaml},
                              {"abs_filename", kFileSpecification, abs_filename},
                              {"dotify", Signature::free(), dotify},
                              {"arg", {{"name"}, 1}, arg},
                              {"tokenize", {{"s", "sep", "skip_empty"}, 1}, tokenize},
                              {"message", Signature::free(), say<MessageKind::message>},
                              {"warning", Signature::free(), say<MessageKind::warning>},
                              {"error", Signature::free(), say<MessageKind::error>},
                              {"print_location", Signature::free(), print_location},
                              {"fatal", Signature::free(), fatal}};

}  // namespace

Symbols xacro_symbols() {
  Symbols symbols;
  for (const Builtin& function : kXacro) symbols.emplace_back(std::string(function.name), &function);
  return symbols;
}

Symbols deprecated_xacro_symbols() {
  Symbols symbols;
  for (const Builtin& function : kOld) symbols.emplace_back(std::string(function.name), &function);
  return symbols;
}

}  // namespace finemote::gen::expression
