#include "generator/emit/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace finemote::gen {
namespace {

constexpr unsigned kFormat = 1;                         // of the frames: link.hpp of the runtime
constexpr unsigned kMaxPayload = 117;                   // a frame of 128 bytes
constexpr unsigned kTimeSize = 8;                       // every block of states begins with the robot's time
constexpr unsigned kMaxBlocks = 16;                     // a nibble
constexpr unsigned kStateStamp = 9, kCommandStamp = 1;  // origin and validity; validity

struct Scalar {
  const char* type;  ///< in the interface table
  const char* kind;  ///< enumerator of the runtime
  const char* cpp;   ///< on the computer
  unsigned size;
};

const Scalar& scalar(const std::string& type) {
  static constexpr Scalar kScalars[] = {
      {"bool", "kBool", "bool", 1},         {"uint8", "kU8", "std::uint8_t", 1},
      {"int16", "kI16", "std::int16_t", 2}, {"uint16", "kU16", "std::uint16_t", 2},
      {"int32", "kI32", "std::int32_t", 4}, {"uint32", "kU32", "std::uint32_t", 4},
      {"float", "kF32", "float", 4},        {"int64", "kI64", "std::int64_t", 8},
  };
  const auto found =
      std::find_if(std::begin(kScalars), std::end(kScalars), [&](const Scalar& s) { return type == s.type; });
  if (found == std::end(kScalars)) throw std::logic_error("the interface table has a type '" + type + "'");
  return *found;
}

unsigned size_of(const std::vector<LinkField>& fields) {
  unsigned size = 0;
  for (const LinkField& field : fields) size += scalar(field.type).size * std::max(1U, field.count);
  return size;
}

/// What an interface's State or Command holds: as the descriptor of the device says, else as the table of the shipped
/// interfaces does. None: only its Stamp is known.
std::optional<std::vector<LinkField>> fields_of(const DeviceType& type, const InterfaceTable& shipped,
                                                std::optional<std::vector<LinkField>> InterfaceFields::*what) {
  if (type.provides.empty()) return std::nullopt;
  const Interface& provided = type.provides.front();
  if (provided.fields.*what) return provided.fields.*what;
  const auto known = shipped.find(provided.name);
  return known == shipped.end() ? std::nullopt : known->second.*what;
}

class Planner {
 public:
  Planner(const Plan& plan, const InterfaceTable& interfaces, Diagnostics& diagnostics)
      : plan_(plan), interfaces_(interfaces), diagnostics_(diagnostics) {}

  DeviceLink link_of(DeviceId device) {
    DeviceLink link;
    link.device = device;
    const DeviceType& type = *plan_.robot.devices[device].type;
    for (std::size_t role = 0; role < type.roles.size(); ++role) {
      if (type.roles[role].name != type.link_role) continue;
      for (const Binding& binding : plan_.schedule.roles[device][role].bindings) add(link, binding);
    }
    link.up_blocks = cut(link, link.up, kTimeSize, kStateStamp);
    link.down_blocks = cut(link, link.down, 0, kCommandStamp);
    link.number = number(link);
    return link;
  }

 private:
  /// A device that is read twice goes over the link once.
  void add(DeviceLink& link, const Binding& binding) {
    const Device& device = plan_.robot.devices[binding.device];
    const std::string target = device_reference(plan_, link.device, binding.device);
    LinkItem item;
    item.name = device.name.cpp;
    const auto is_here = [&](const LinkItem& other) { return other.name == item.name; };
    if (std::any_of(link.up.begin(), link.up.end(), is_here)) return;
    item.interface = device.type->provides.empty() ? "" : device.type->provides.front().name;
    item.fields = fields_of(*device.type, interfaces_, &InterfaceFields::state).value_or(std::vector<LinkField>{});
    item.expression = binding.state_crossing ? plan_.schedule.crossings[*binding.state_crossing].name
                                             : target + "." + binding.state_member;
    link.up.push_back(item);
    const auto fields = fields_of(*device.type, interfaces_, &InterfaceFields::command);
    if (!binding.has_command || binding.sink || !fields) return;
    item.fields = *fields;
    item.expression = binding.command_crossing ? plan_.schedule.crossings[*binding.command_crossing].name
                                               : target + "." + binding.command_member;
    link.down.push_back(item);
  }

  /// Puts the items into as few frames as their order allows; returns how many.
  unsigned cut(const DeviceLink& link, std::vector<LinkItem>& items, unsigned head, unsigned stamp) {
    if (items.empty()) return 0;
    unsigned block = 0, used = head;
    for (LinkItem& item : items) {
      const unsigned size = stamp + size_of(item.fields);
      if (head + size > kMaxPayload) report(link, fmt::format("'{}' needs {} bytes", item.name, size));
      if (used + size > kMaxPayload) {
        ++block;
        used = head;
      }
      item.block = block;
      used += size;
    }
    if (block >= kMaxBlocks) report(link, fmt::format("there are {} frames' worth of data", block + 1));
    return block + 1;
  }
  void report(const DeviceLink& link, const std::string& what) {
    const Device& device = plan_.robot.devices[link.device];
    diagnostics_
        .error(code::link_too_large, device.at,
               fmt::format("device '{}' cannot carry all this: {}", device.name.text, what))
        .note(fmt::format("a frame holds {} bytes, and there are at most {} frames each way", kMaxPayload, kMaxBlocks))
        .hint("put fewer devices under one link, or add a second link");
  }

  /// FNV-1a of everything that decides where a byte stands.
  static std::uint32_t number(const DeviceLink& link) {
    std::string text = fmt::format("finemote.link/{}\n", kFormat);
    const auto tell = [&](const char* way, const std::vector<LinkItem>& items) {
      for (const LinkItem& item : items) {
        text += fmt::format("{} {} {} {}:", way, item.block, item.name, item.interface);
        for (const LinkField& field : item.fields)
          text += fmt::format(" {} {} {}", field.name, field.type, field.count);
        text += '\n';
      }
    };
    tell("up", link.up);
    tell("down", link.down);
    std::uint32_t hash = 0x811C9DC5U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193U;
    return hash;
  }

  const Plan& plan_;
  const InterfaceTable& interfaces_;
  Diagnostics& diagnostics_;
};

// ------------------------------------------------------------------------------------------------------ on the robot

void add_table(std::string& text, const std::string& name, const LinkItem& item, bool is_up) {
  if (item.fields.empty()) return;
  text += fmt::format("inline constexpr finemote::{} {}[] = {{  // {}\n", is_up ? "LinkField" : "LinkSlot", name,
                      item.name);
  for (const LinkField& field : item.fields) {
    for (unsigned i = 0; i < std::max(1U, field.count); ++i) {
      const std::string index = field.count > 0 ? fmt::format("[{}]", i) : "";
      text += fmt::format("    finemote::{}<finemote::LinkKind::{}>({}.{}{}),\n", is_up ? "link_up" : "link_down",
                          scalar(field.type).kind, item.expression, field.name, index);
    }
  }
  text += "};\n";
}

/// The items' tables, then the list of items; returns what stands for it in the layout.
std::string add_items(std::string& text, const std::string& prefix, const std::vector<LinkItem>& items, bool is_up) {
  if (items.empty()) return "nullptr";
  const auto table = [&](std::size_t i) {
    return items[i].fields.empty() ? std::string("nullptr") : fmt::format("{}_{}", prefix, i);
  };
  for (std::size_t i = 0; i < items.size(); ++i) add_table(text, table(i), items[i], is_up);
  text += fmt::format("inline constexpr finemote::{} {}[] = {{\n", is_up ? "LinkSource" : "LinkTarget", prefix);
  for (std::size_t i = 0; i < items.size(); ++i)
    text += fmt::format("    {{{}, {}, /*block*/ {}}},\n", items[i].expression, table(i), items[i].block);
  text += "};\n";
  return prefix;
}

// --------------------------------------------------------------------------------------------------- on the computer

std::vector<std::string> members(const std::vector<LinkItem>& items, bool is_up) {
  std::vector<std::string> lines;
  for (const LinkItem& item : items) {
    lines.push_back(
        fmt::format("  struct {{  // {}", item.interface.empty() ? "known by its age alone" : item.interface));
    if (is_up) lines.emplace_back("    std::int64_t origin = 0;  ///< robot's time of the oldest data in it [ns]");
    lines.push_back(
        fmt::format("    bool valid = false;{}", is_up ? "" : "  ///< false: the device is told to go safe"));
    for (const LinkField& field : item.fields) {
      lines.push_back(field.count > 0
                          ? fmt::format("    {} {}[{}] = {{}};", scalar(field.type).cpp, field.name, field.count)
                      : field.type == "bool" ? fmt::format("    bool {} = false;", field.name)
                                             : fmt::format("    {} {} = 0;", scalar(field.type).cpp, field.name));
    }
    lines.push_back(fmt::format("  }} {};", item.name));
  }
  return lines;
}

/// One line per value: `bytes.get(to.imu.roll);`.
std::vector<std::string> moves(const std::vector<LinkItem>& items, bool is_up, const std::string& call,
                               const std::string& object) {
  std::vector<std::string> lines;
  unsigned block = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const LinkItem& item = items[i];
    if (i == 0 || item.block != block) {
      if (i != 0) lines.emplace_back("      break;");
      block = item.block;
      lines.push_back(fmt::format("    case {}:", block));
    }
    const auto move = [&](const std::string& member) {
      lines.push_back(fmt::format("      {}({}.{}.{});", call, object, item.name, member));
    };
    if (is_up) move("origin");
    move("valid");
    for (const LinkField& field : item.fields) {
      for (unsigned k = 0; k < std::max(1U, field.count); ++k)
        move(field.name + (field.count > 0 ? fmt::format("[{}]", k) : ""));
    }
  }
  if (!items.empty()) lines.emplace_back("      break;");
  return lines;
}

}  // namespace

std::vector<DeviceLink> plan_links(const Plan& plan, const InterfaceTable& interfaces, Diagnostics& diagnostics) {
  std::vector<DeviceLink> links;
  Planner planner(plan, interfaces, diagnostics);
  for (const DeviceId device : plan.forest.order) {
    if (!plan.robot.devices[device].type->link_role.empty()) links.push_back(planner.link_of(device));
  }
  return links;
}

Constant link_constant(const Plan& plan, const DeviceLink& link) {
  const std::string name = plan.robot.devices[link.device].name.cpp;
  std::string text = "// What goes over the link, in this order; host/" + name + "_link.hpp is its other end.\n";
  const std::string up = add_items(text, name + "_up", link.up, true);
  const std::string down = add_items(text, name + "_down", link.down, false);
  text += fmt::format("inline constexpr finemote::LinkLayout {}_layout{{{:#010x}, {}, {}, /*blocks*/ {}, {}}};", name,
                      link.number, up, down, link.up_blocks, link.down_blocks);
  return {link.device, name + "_layout", text, true, {}};
}

Data link_header(const Plan& plan, const DeviceLink& link) {
  const Device& device = plan.robot.devices[link.device];
  Data data = common_data(plan);
  data.set("device", device.name.text);
  data.set("space", device.name.cpp + "_link");
  data.set("layout", fmt::format("{:#010x}", link.number));
  data.set("up_blocks", std::to_string(link.up_blocks));
  data.set("down_blocks", std::to_string(link.down_blocks));
  data.set("states", text_list(members(link.up, true)));
  data.set("commands", text_list(members(link.down, false)));
  data.set("takes", text_list(moves(link.up, true, "bytes.take", "states")));
  data.set("puts", text_list(moves(link.down, false, "bytes.put", "commands")));
  return data;
}

std::vector<std::string> link_header_names(const Robot& robot, const Forest& forest) {
  std::vector<std::string> names;
  for (const DeviceId device : forest.order) {
    if (!robot.devices[device].type->link_role.empty())
      names.push_back("host/" + robot.devices[device].name.cpp + "_link.hpp");
  }
  return names;
}

}  // namespace finemote::gen
