#include "generator/emit/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "generator/emit/file_names.hpp"
#include "generator/emit/scope.hpp"

namespace finemote::gen {
namespace {

constexpr unsigned kFormat = 1;                         // of the frames: link.hpp of the runtime
constexpr unsigned kMaxPayload = 117;                   // a frame of 128 bytes
constexpr unsigned kTimeSize = 8;                       // every block of states begins with the robot's time
constexpr unsigned kMaxBlocks = 16;                     // a nibble
constexpr unsigned kMaxCommandBlocks = 1;               // bounds count on a frame for every sample
constexpr unsigned kStateStamp = 9, kCommandStamp = 1;  // origin and validity; validity

struct Scalar {
  const char* type;  ///< in the interface table
  const char* kind;  ///< enumerator of the runtime
  const char* cpp;   ///< on the computer
  unsigned size;
  char letter;  ///< of CommandFrame::values
};

const Scalar& scalar(const std::string& type) {
  static constexpr Scalar kScalars[] = {
      {"bool", "kBool", "bool", 1, '?'},         {"uint8", "kU8", "std::uint8_t", 1, 'B'},
      {"int16", "kI16", "std::int16_t", 2, 'h'}, {"uint16", "kU16", "std::uint16_t", 2, 'H'},
      {"int32", "kI32", "std::int32_t", 4, 'i'}, {"uint32", "kU32", "std::uint32_t", 4, 'I'},
      {"float", "kF32", "float", 4, 'f'},        {"int64", "kI64", "std::int64_t", 8, 'q'},
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
    const Scope scope = Scope(plan_, device).ports();
    for (std::size_t role = 0; role < type.roles.size(); ++role) {
      if (type.roles[role].name != type.link_role) continue;
      for (const Binding& binding : plan_.schedule.roles[device][role].bindings) add(link, scope, binding);
    }
    link.up_blocks = cut(link, link.up, kTimeSize, kStateStamp);
    if (link.up_blocks > kMaxBlocks) report(link, fmt::format("states fill {} frames", link.up_blocks));
    link.down_blocks = cut(link, link.down, 0, kCommandStamp);
    if (link.down_blocks > kMaxCommandBlocks) report(link, fmt::format("commands fill {} frames", link.down_blocks));
    link.number = number(link);
    return link;
  }

 private:
  /// A device that is read twice goes over the link once.
  void add(DeviceLink& link, const Scope& scope, const Binding& binding) {
    const Device& device = plan_.robot.devices[binding.device];
    const std::string target = scope.device(binding.device);
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
      if (used > head && used + size > kMaxPayload) {
        ++block;
        used = head;
      }
      item.block = block;
      used += size;
    }
    return block + 1;
  }
  void report(const DeviceLink& link, const std::string& what) {
    const Device& device = plan_.robot.devices[link.device];
    diagnostics_
        .error(code::link_too_large, device.at,
               fmt::format("device '{}' cannot carry all this: {}", device.name.text, what))
        .note(fmt::format("a frame holds {} bytes, states have at most {} frames, and commands have one", kMaxPayload,
                          kMaxBlocks))
        .hint("put fewer devices under one link, or add a second link");
  }

  /// FNV-1a of everything that decides where a byte stands.
  static std::uint32_t number(const DeviceLink& link) {
    constexpr char kEnd = '\n';
    std::string text = fmt::format("finemote.link/{}", kFormat) + kEnd;
    const auto tell = [&](const char* way, const std::vector<LinkItem>& items) {
      for (const LinkItem& item : items) {
        text += fmt::format("{} {} {} {}:", way, item.block, item.name, item.interface);
        for (const LinkField& field : item.fields)
          text += fmt::format(" {} {} {}", field.name, field.type, field.count);
        text += kEnd;
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

/// `roll`, `rate[0]`, `rate[1]`: every value of an item, with what `set` says of its type.
template <class Set>
Data value_list(const LinkItem& item, const Set& set) {
  Data list(Data::type::list);
  for (const LinkField& field : item.fields) {
    for (unsigned i = 0; i < std::max(1U, field.count); ++i) {
      Data value;
      value.set("member", field.count > 0 ? fmt::format("{}[{}]", field.name, i) : field.name);
      set(scalar(field.type), value);
      list.push_back(value);
    }
  }
  return list;
}

/// The robot's end: templates/link_layout.mustache.
Data layout_items(const std::vector<LinkItem>& items) {
  Data list(Data::type::list);
  for (std::size_t i = 0; i < items.size(); ++i) {
    Data entry;
    entry.set("item", items[i].name);
    entry.set("index", std::to_string(i));
    entry.set("place", items[i].expression);
    entry.set("block", std::to_string(items[i].block));
    entry.set("has_table", !items[i].fields.empty());
    entry.set("values",
              value_list(items[i], [](const Scalar& scalar, Data& value) { value.set("kind", scalar.kind); }));
    list.push_back(entry);
  }
  return list;
}

Data member_list(const LinkItem& item) {
  Data list(Data::type::list);
  for (const LinkField& field : item.fields) {
    Data member;
    member.set("member", field.name);
    member.set("type", scalar(field.type).cpp);
    member.set("count", std::to_string(field.count));
    set_choice(member, {"is_array", "is_flag", "is_number"},
               field.count > 0        ? "is_array"
               : field.type == "bool" ? "is_flag"
                                      : "is_number");
    list.push_back(member);
  }
  return list;
}

/// The computer's end, by device: templates/link.hpp.mustache.
Data struct_items(const std::vector<LinkItem>& items) {
  Data list(Data::type::list);
  for (const LinkItem& item : items) {
    Data entry;
    entry.set("item", item.name);
    entry.set("has_interface", !item.interface.empty());
    entry.set("interface", item.interface);
    entry.set("members", member_list(item));
    list.push_back(entry);
  }
  return list;
}

/// The computer's end, by frame.
Data frame_blocks(const std::vector<LinkItem>& items, unsigned blocks) {
  Data list(Data::type::list);
  for (unsigned block = 0; block < blocks; ++block) {
    Data entry, in_block(Data::type::list);
    for (const LinkItem& item : items) {
      if (item.block != block) continue;
      Data moved;
      moved.set("item", item.name);
      moved.set("values", value_list(item, [](const Scalar&, Data&) {}));
      in_block.push_back(moved);
    }
    entry.set("block", std::to_string(block));
    entry.set("items", in_block);
    list.push_back(entry);
  }
  return list;
}

void set_layout(const DeviceLink& link, Data& data) {
  data.set("layout", fmt::format("{:#010x}", link.number));
  data.set("up_blocks", std::to_string(link.up_blocks));
  data.set("down_blocks", std::to_string(link.down_blocks));
}

}  // namespace

std::optional<CommandFrame> command_frame(const DeviceLink& link) {
  if (link.down.empty()) return std::nullopt;
  CommandFrame frame{link.number, {}};
  for (const LinkItem& item : link.down) {
    frame.values += 'v';
    for (const LinkField& field : item.fields)
      frame.values.append(std::max(1U, field.count), scalar(field.type).letter);
  }
  return frame;
}

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
  Data data;
  data.set("link", name);
  set_layout(link, data);
  data.set("has_up", !link.up.empty());
  data.set("up", layout_items(link.up));
  data.set("has_down", !link.down.empty());
  data.set("down", layout_items(link.down));
  return {link.device, name + "_layout", data, true, {}};
}

Data link_header(const Plan& plan, const DeviceLink& link) {
  const Device& device = plan.robot.devices[link.device];
  Data data = common_data(plan);
  data.set("device", device.name.text);
  data.set("space", device.name.cpp + "_link");
  set_layout(link, data);
  data.set("states", struct_items(link.up));
  data.set("commands", struct_items(link.down));
  data.set("takes", frame_blocks(link.up, link.up_blocks));
  data.set("puts", frame_blocks(link.down, link.down_blocks));
  return data;
}

std::vector<std::string> link_header_names(const Robot& robot, const Forest& forest) {
  std::vector<std::string> names;
  for (const DeviceId device : forest.order) {
    if (!robot.devices[device].type->link_role.empty()) names.push_back(link_header_name(robot.devices[device]));
  }
  return names;
}

}  // namespace finemote::gen
