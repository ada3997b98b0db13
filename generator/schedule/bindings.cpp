#include "generator/schedule/bindings.hpp"
#include "generator/schedule/name_clash.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <tuple>

namespace finemote::gen {
namespace {

/// The interface of `type` that serves a role asking for `wanted`; `any` takes the first one.
/// Null when a type provides nothing: then it is known by its Stamp alone.
const Interface* provided(const DeviceType& type, const std::string& wanted) {
  for (const Interface& interface : type.provides) {
    if (wanted == "any" || interface.name == wanted) return &interface;
  }
  return nullptr;
}

class Binder {
 public:
  Binder(const Robot& robot, const Forest& forest, Schedule& schedule, Diagnostics& diagnostics)
      : robot_(robot), forest_(forest), schedule_(schedule), diagnostics_(diagnostics) {
    for (const DeviceId d : robot.devices.ids()) tree_names_.emplace(forest.tree_of[d], robot.devices[d].name.cpp);
  }

  void bind_all() {
    schedule_.roles.resize(robot_.devices.size());
    for (DeviceId device : forest_.order) bind_device(device);
  }

 private:
  const Device& device(DeviceId id) const { return robot_.devices[id]; }

  void bind_device(DeviceId owner) {
    const auto& specs = device(owner).type->roles;
    for (std::size_t role = 0; role < specs.size(); ++role) {
      RoleBinding bound;
      bound.single = specs[role].min == 1 && specs[role].max == 1u;
      bound.interface = interface_name(specs[role]);
      for (DeviceId child : device(owner).children) {
        if (device(child).role == role) add(bound, owner, specs[role], child, false);
      }
      for (const Read& read : device(owner).reads) {
        if (read.role == role) add(bound, owner, specs[role], read.device, true);
      }
      if (!bound.single && !bound.bindings.empty()) {
        bound.array = claim(owner, device(owner).name.cpp + "_" + specs[role].name);
      }
      schedule_.roles[owner].push_back(std::move(bound));
    }
    claim_others(owner);
  }

  /// What the emitter puts into `ports` besides: objects for optional uses, and the tables of a link.
  void claim_others(DeviceId owner) {
    const Device& d = device(owner);
    for (const Use& use : d.uses) {
      if (!use.spec->required) claim(owner, d.name.cpp + "_use_" + use.spec->role);
    }
    if (d.type->link_role.empty()) return;
    claim(owner, d.name.cpp + "_layout");
    for (const char* way : {"_up", "_down"}) {
      claim(owner, d.name.cpp + way);
      for (std::size_t i = 0; i < d.children.size() + d.reads.size(); ++i)
        claim(owner, fmt::format("{}{}_{}", d.name.cpp, way, i));
    }
  }

  static std::string interface_name(const RoleSpec& spec) {
    if (spec.interface == "any") return "finemote::Any";
    return spec.interface.find("::") == std::string::npos ? "finemote::" + spec.interface : spec.interface;
  }

  void add(RoleBinding& bound, DeviceId owner, const RoleSpec& spec, DeviceId target, bool is_read) {
    const Interface* interface = provided(*device(target).type, spec.interface);
    const bool takes_command = interface != nullptr && interface->has_command;
    const std::string tag = interface != nullptr ? interface->cpp : "finemote::Any";
    Binding binding;
    binding.device = target;
    binding.is_read = is_read;
    binding.state_member = interface != nullptr ? interface->state : "state";
    binding.command_member = interface != nullptr ? interface->command : "command";
    binding.has_command = spec.interface == "any" || takes_command;
    binding.sink = binding.has_command && (is_read || !takes_command);
    binding.state_crossing = crossing(Crossing::Direction::state, target, owner, owner, tag, binding.state_member);
    if (binding.sink) {
      const std::size_t index = bound.bindings.size();
      binding.sink_name = claim(owner, fmt::format("{}_{}_sink_{}", device(owner).name.cpp, spec.name, index));
    } else if (binding.has_command) {
      binding.command_crossing =
          crossing(Crossing::Direction::command, owner, target, owner, tag, binding.command_member);
    }
    bound.bindings.push_back(std::move(binding));
  }

  /// The crossing from producer to consumer, made on first use; none where a plain reference does.
  std::optional<std::size_t> crossing(Crossing::Direction direction, DeviceId producer, DeviceId consumer,
                                      DeviceId home, const std::string& tag, const std::string& member) {
    const std::size_t from = schedule_.bucket_of[producer];
    const std::size_t to = schedule_.bucket_of[consumer];
    const bool same_tree = forest_.tree_of[producer] == forest_.tree_of[consumer];
    if (from == to && same_tree) return std::nullopt;
    const auto key = std::make_tuple(direction, producer, consumer, member);
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;

    Crossing made;
    made.direction = direction;
    made.kind = from == to ? Crossing::Kind::copy : from < to ? Crossing::Kind::to_slow : Crossing::Kind::to_fast;
    made.producer = producer;
    made.consumer = consumer;
    made.home = home;
    made.type = tag + (direction == Crossing::Direction::state ? "::State" : "::Command");
    made.member = member;
    const std::string suffix = member == "state" || member == "command" ? "" : "_" + member;
    made.name = claim(home, device(producer).name.cpp + "_to_" + device(consumer).name.cpp + suffix);
    if (made.kind != Crossing::Kind::copy) claim(home, made.name + "_latch");
    schedule_.crossings.push_back(std::move(made));
    return known_[key] = schedule_.crossings.size() - 1;
  }

  /// Reserves a name in namespace `ports` of the owner's tree. It must be new there, and hide no device of the tree.
  std::string claim(DeviceId owner, std::string name) {
    const std::pair<std::size_t, std::string> key{forest_.tree_of[owner], name};
    const bool fresh = claimed_.insert(key).second && tree_names_.count(key) == 0;
    if (!fresh) {
      std::vector<const Device*> holders;
      for (const Device& other : robot_.devices) {
        if (other.name.cpp == name) holders.push_back(&other);
      }
      report_name_clash(name, device(owner), holders, diagnostics_);
    }
    return name;
  }

  const Robot& robot_;
  const Forest& forest_;
  Schedule& schedule_;
  Diagnostics& diagnostics_;
  std::map<std::tuple<Crossing::Direction, DeviceId, DeviceId, std::string>, std::size_t> known_;
  std::set<std::pair<std::size_t, std::string>> tree_names_;  ///< (tree, C++ name of a device)
  std::set<std::pair<std::size_t, std::string>> claimed_;     ///< (tree, name in `ports`)
};

}  // namespace

void bind_roles(const Robot& robot, const Forest& forest, Schedule& schedule, Diagnostics& diagnostics) {
  Binder(robot, forest, schedule, diagnostics).bind_all();
}

}  // namespace finemote::gen
