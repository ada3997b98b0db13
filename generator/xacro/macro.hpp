// Macro definitions, and the tables that names of macros are looked up in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "generator/xacro/engine.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

struct Parameter {
  std::string name;                         ///< with its `*` or `**` for a block
  bool is_forwarded = false;                ///< `^`: the property of the caller with that name
  std::optional<std::string> default_text;  ///< evaluated at each call that needs it

  [[nodiscard]] bool is_block() const { return name.starts_with('*'); }
  [[nodiscard]] bool has_default() const { return is_forwarded || default_text.has_value(); }
};

struct Macro {
  std::string name;
  std::string file;  ///< it is defined in
  std::shared_ptr<const xml::Node> body;
  std::vector<Parameter> parameters;
};

/// Reads the `params` attribute: names separated by white space, each with `:=default`, `=default`, `:=^` or
/// `:=^|default`. A default is one `${...}`, one `$(...)`, a concatenation of words and quoted texts, or empty.
std::vector<Parameter> parse_parameters(std::string_view text);

/// One level of macro names: a macro call opens one, a namespace is one.
class MacroScope {
 public:
  explicit MacroScope(MacroScope* parent = nullptr) : parent_(parent) {}

  void set_fallback(MacroScope* fallback) { fallback_ = fallback; }
  void define(std::shared_ptr<const Macro> macro);
  void define(const std::string& name_space, MacroScope* scope) { entries_[name_space] = scope; }

  [[nodiscard]] std::shared_ptr<const Macro> find_macro(std::string_view name) const;
  [[nodiscard]] MacroScope* find_namespace(std::string_view name) const;
  /// Names of all macros visible here, sorted: for suggestions.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  using Entry = std::variant<std::shared_ptr<const Macro>, MacroScope*>;
  [[nodiscard]] const Entry* find(std::string_view name) const;

  MacroScope* parent_;
  MacroScope* fallback_ = nullptr;
  std::unordered_map<std::string, Entry, expression::TextHash, std::equal_to<>> entries_;
};

}  // namespace finemote::gen::xacro
