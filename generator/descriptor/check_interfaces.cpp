#include "generator/descriptor/check_interfaces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {
namespace {

class InterfaceNames {
 public:
  InterfaceNames(const InterfaceTable& shipped, const Contradictions& found) : found_(found), names_{"Any", "any"} {
    for (const auto& [name, fields] : shipped) names_.push_back(name);
  }

  void check(const std::string& named, const JsonPath& path) const {
    constexpr std::string_view kOurs = "finemote::";
    const std::string name = named.starts_with(kOurs) ? named.substr(kOurs.size()) : named;
    const bool is_users = !named.starts_with(kOurs) && name.find("::") != std::string::npos;
    if (is_users || std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    Diagnostic& finding = found_.add(path, fmt::format("finemote has no interface '{}'", name));
    suggest(finding, name, names_);
    finding.note("one of your own has its namespace in front of it: 'my::Gripper'");
  }

 private:
  const Contradictions& found_;
  std::vector<std::string> names_;
};

}  // namespace

void check_interfaces(const DeviceType& type, const InterfaceTable& shipped, const Contradictions& found) {
  const InterfaceNames names(shipped, found);
  for (std::size_t i = 0; i < type.provides.size(); ++i)
    names.check(type.provides[i].name, {"provides", std::to_string(i), "interface"});
  for (std::size_t i = 0; i < type.roles.size(); ++i)
    names.check(type.roles[i].interface, {"roles", std::to_string(i), "interface"});
}

}  // namespace finemote::gen
