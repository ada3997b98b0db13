#include "generator/emit/scope.hpp"

#include "generator/model/names.hpp"

namespace finemote::gen {

Scope::Scope(const Plan& plan, DeviceId inside) : plan_(plan), tree_(plan.forest.tree_of[inside]) {
  Names declared;
  for (const DeviceId device : plan.forest.trees[*tree_].devices) declared.insert(plan.robot.devices[device].name.cpp);
  declared_ = std::make_shared<const Names>(std::move(declared));
}

Scope Scope::in_slots(const Plan& plan) {
  Names declared;
  for (const Slot& slot : plan.schedule.slots) declared.insert(slot.name);
  Scope scope(plan);
  scope.declared_ = std::make_shared<const Names>(std::move(declared));
  return scope;
}

Scope Scope::ports() const {
  Scope scope = *this;
  scope.in_ports_ = true;
  return scope;
}

std::string Scope::of_robot(const std::string& cpp_name) const {
  const std::size_t end = cpp_name.find(':');
  const std::string first = cpp_name.substr(0, end);
  // `slots` and `constants` of the robot are among the names that no tree declares for this very reason.
  const bool is_generated = tree_ && end == std::string::npos && reserved_name(first, NameScope::in_tree);
  return is_generated || hides(first) ? "::" + plan_.robot.name.cpp + "::" + cpp_name : cpp_name;
}

std::string Scope::device(DeviceId device) const {
  const std::string& name = plan_.robot.devices[device].name.cpp;
  return is_here(device) ? name : of_robot(tree_of(device).space + "::" + name);
}

std::string Scope::port(DeviceId home, const std::string& name) const {
  if (!is_here(home)) return of_robot(tree_of(home).space + "::ports::" + name);
  return in_ports_ ? name : "ports::" + name;
}

bool Scope::hides(const std::string& name) const {
  if (declared_->count(name) != 0) return true;
  if (!in_ports_) return false;
  for (std::size_t end = name.find('_'); end != std::string::npos; end = name.find('_', end + 1)) {
    for (const Device& device : plan_.robot.devices) {
      if (device.name.cpp == std::string_view(name).substr(0, end)) return true;
    }
  }
  return false;
}

const Tree& Scope::tree_of(DeviceId device) const { return plan_.forest.trees[plan_.forest.tree_of[device]]; }

bool Scope::is_here(DeviceId device) const { return plan_.forest.tree_of[device] == tree_; }

}  // namespace finemote::gen
