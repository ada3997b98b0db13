// The functions of the `xacro.` namespace.
#include <algorithm>

#include "generator/expression/builtins.hpp"
#include "generator/expression/failure.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

Value load_yaml(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "load_yaml", {"filename"}, 1);
  return runtime.host.load_yaml(p.text(0));
}

Value abs_filename(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "abs_filename", {"filename_spec"}, 1);
  return runtime.host.absolute_name(p.text(0));
}

/// A dictionary whose items are reached by attributes too.
Value dotify(Runtime& runtime, CallArguments& arguments) {
  auto dict = std::make_shared<Dict>();
  dict->table = table_of(runtime, arguments, "dotify");
  dict->is_dotted = true;
  return dict;
}

Value arg(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "arg", {"name"}, 1);
  const std::string* value = runtime.host.argument(p.text(0));
  if (value == nullptr) fail_eval("'" + p.text(0) + "'");
  return *value;
}

/// Cuts a text at any of the separators.
Value tokenize(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "tokenize", {"s", "sep", "skip_empty"}, 1);
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

std::string joined(Runtime& runtime, const CallArguments& arguments) {
  std::string text;
  for (const Value& value : arguments.positional) {
    if (!text.empty()) text += ' ';
    text += to_text(runtime, value);
  }
  return text;
}

template <MessageKind Kind>
Value say(Runtime& runtime, CallArguments& arguments) {
  bool with_location = Kind != MessageKind::message;
  for (const auto& [name, value] : arguments.named) {
    if (name == "print_location") with_location = is_true(value);
  }
  runtime.host.say(Kind, joined(runtime, arguments), with_location);
  return "";
}

Value print_location(Runtime& runtime, CallArguments& /*arguments*/) {
  runtime.host.say(MessageKind::message, "", true);
  return "";
}

Value fatal(Runtime& runtime, CallArguments& arguments) { fail(code::xacro_fatal, joined(runtime, arguments)); }

constexpr Builtin kOld[] = {
    {"load_yaml", load_yaml, "xacro"}, {"abs_filename", abs_filename, "xacro"}, {"dotify", dotify, "xacro"}};
constexpr Builtin kXacro[] = {{"load_yaml", load_yaml},
                              {"abs_filename", abs_filename},
                              {"dotify", dotify},
                              {"arg", arg},
                              {"tokenize", tokenize},
                              {"message", say<MessageKind::message>},
                              {"warning", say<MessageKind::warning>},
                              {"error", say<MessageKind::error>},
                              {"print_location", print_location},
                              {"fatal", fatal}};

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
