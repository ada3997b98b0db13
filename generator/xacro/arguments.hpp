// The arguments of a document: what the command line gives, and what xacro:arg declares.
#pragma once

#include <map>
#include <set>
#include <string>

#include "generator/diagnostic/source.hpp"
#include "generator/xacro/warnings.hpp"

namespace finemote::gen::xacro {

/// Values of `name:=value`.
using Arguments = std::map<std::string, std::string>;

/// Values by name, and which of them somebody asked for.
class ArgumentTable {
 public:
  explicit ArgumentTable(const Arguments& given) : given_(given), values_(given) {}

  /// The value, or null.
  const std::string* ask(const std::string& name);
  /// All values, for an expression that may use those whose names it holds.
  const Arguments& ask_for(const std::string& expression);
  /// Gives an argument without a value the default one.
  void set_default(const std::string& name, std::string value) { values_.emplace(name, std::move(value)); }

  /// Warns of the arguments of the command line that nobody asked for: ROS xacro is silent about them, and they are
  /// mostly slips of the pen.
  void warn_of_unknown(const SourceFile& entry, Warnings& warnings) const;

 private:
  Arguments given_;
  Arguments values_;
  std::set<std::string> asked_;
};

}  // namespace finemote::gen::xacro
