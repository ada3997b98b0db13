#include "generator/descriptor/check_provides.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/descriptor/cpp_words.hpp"

namespace finemote::gen {
namespace {

class InterfaceCheck {
 public:
  InterfaceCheck(std::size_t index, const Contradictions& found) : index_(std::to_string(index)), found_(found) {}

  void check(const Interface& interface) const {
    check_member(interface.state, "state_member");
    check_member(interface.command, "command_member");
    if (interface.has_command && interface.state == interface.command) {
      const bool is_given = found_.has({"provides", index_, "command_member"});
      found_.add({"provides", index_, is_given ? "command_member" : "state_member"},
                 fmt::format("'{}' cannot hold both the State and the Command", interface.state));
    }
    if (interface.fields.state) check_fields(*interface.fields.state, "state_fields");
    if (interface.fields.command) check_fields(*interface.fields.command, "command_fields");
    if (interface.fields.command && !interface.has_command) {
      found_.add({"provides", index_, "command_fields"}, "there are fields of a Command that the device does not take")
          .hint("\"command\": true");
    }
  }

 private:
  void check_member(const std::string& name, const char* member) const {
    if (const auto fault = invalid_name(name))
      found_.add({"provides", index_, member}, fmt::format("'{}' {}, so no member can have it", name, *fault));
  }
  void check_fields(const std::vector<LinkField>& fields, const char* list) const {
    std::set<std::string> seen{"origin", "valid"};  // of the stamp
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string& name = fields[i].name;
      const JsonPath path{"provides", index_, list, std::to_string(i), "name"};
      if (const auto fault = invalid_name(name)) {
        found_.add(path, fmt::format("'{}' {}, so no field can have it", name, *fault));
      } else if (!seen.insert(name).second) {
        const bool is_stamp = name == "origin" || name == "valid";
        found_.add(path, is_stamp ? fmt::format("'{}' is in every State and Command, and needs no field", name)
                                  : fmt::format("there are two fields '{}'", name));
      }
    }
  }

  std::string index_;
  const Contradictions& found_;
};

}  // namespace

void check_provides(const std::vector<Interface>& provides, const Contradictions& found) {
  for (std::size_t i = 0; i < provides.size(); ++i) InterfaceCheck(i, found).check(provides[i]);
}

}  // namespace finemote::gen
