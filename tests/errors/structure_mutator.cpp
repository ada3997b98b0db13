#include "errors/structure_mutator.hpp"

#include <algorithm>

#include "generator/descriptor/read_param.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen {
namespace {

using xml::Node;
using Words = std::vector<std::string>;

/// Stands for a line break in an attribute, which has to be written as a character reference.
constexpr char kLineBreak = '\x01';

const Words kPeriods{"1ms", "2ms", "3ms", "5ms", "7ms", "10ms", "20ms", "100ms", "2500us", "1s"};
const Words kNames{"c",         "Config",      "Stage",        "stage",    "kOrder",   "kBuckets", "run",
                   "update",    "handle",      "state",        "command",  "x-y",      "a b",      "3rd",
                   "\xc3\xa4x", "emit\\",      "two\x01lines", "q\"q",     "*/x",      "// x",     "_x",
                   "x_",        "start",       "supervise",    "ports",    "schedule", "bounds",   "buckets",
                   "trees",     "host",        "int32_t",      "Time",     "Duration", "now",      "View",
                   "Port",      "exact",       "pin_number",   "complete", "x_latch",  "buses",    "flush",
                   "safe",      "update_10ms", "records",      "uart",     "detail",   "\\"};
const Words kNumbers{"0 0 0",    "1 0 0",         "0 1 0",       "0 0 1",       "0 0 -1",
                     "1e30 0 0", "1e-30 1e-30 0", "0.6 0.8 0",   "1 1 1",       "1e300 1e300 1e300",
                     "0 1e-7 1", "-1 0 0",        "0.1 0.2 0.3", "1e7 1e7 1e7", "0 0.7853981 0"};
const Words kWild{"",        " ",         "0",      "-1",  "1",     "2",      "7",      "15",
                  "0x40",    "0x76",      "1e9",    "1ns", "0.5us", "1kHz",   "400kHz", "100%",
                  "1Mbit/s", "base_link", "remote", "imu", "i2c2",  "usart1", "usart6", "can1",
                  "pwm1",    "spi1",      "NaN",    "inf", "true",  "1e-40",  "3.5e38", "18446744073709551616"};
const Words kTypes{"sim_load", "group",           "pwm_esc",    "pwm_servo", "led",        "buzzer",
                   "key",      "battery",         "dji_m3508",  "dji_m2006", "dji_gm6020", "dr16",
                   "sbus",     "ms5837",          "h30_imu",    "ist8310",   "bmi088",     "host_link",
                   "gimbal",   "mecanum_chassis", "serial_arm", "probe",     "late",       "frame"};

std::string* value_of(Node& node, std::string_view name) {
  for (xml::Attribute& attribute : node.attributes) {
    if (attribute.name == name) return &attribute.value;
  }
  return nullptr;
}

void set(Node& node, const std::string& name, const std::string& value) {
  if (std::string* present = value_of(node, name)) {
    *present = value;
  } else {
    node.attributes.push_back({name, value, {}, {}});
  }
}

Node element(const std::string& name, const std::vector<std::pair<std::string, std::string>>& attributes,
             const std::string& text = {}) {
  Node node;
  node.name = name;
  for (const auto& [key, value] : attributes) set(node, key, value);
  if (text.empty()) return node;
  Node content;
  content.kind = Node::Kind::text;
  content.text = text;
  node.children.push_back(content);
  return node;
}

/// One mutant in the making. Pointers to nodes are looked up anew for every change: changes move nodes.
class Mutation {
 public:
  Mutation(xml::Document document, const StructureMutator::FindType& find_type, std::mt19937& random)
      : document_(std::move(document)), find_type_(find_type), random_(random) {}

  void apply() {
    using Change = void (Mutation::*)();
    static constexpr Change kChanges[] = {
        &Mutation::change_period, &Mutation::change_period,   &Mutation::rename,        &Mutation::rename,
        &Mutation::change_param,  &Mutation::change_param,    &Mutation::change_param,  &Mutation::move_device,
        &Mutation::copy_device,   &Mutation::copy_device,     &Mutation::remove_device, &Mutation::add_reads,
        &Mutation::add_reads,     &Mutation::add_reads,       &Mutation::swap_siblings, &Mutation::wrap_device,
        &Mutation::change_joint,  &Mutation::change_joint,    &Mutation::change_board,  &Mutation::add_wcet,
        &Mutation::add_device,    &Mutation::exchange_values, &Mutation::wild_value,    &Mutation::wild_element};
    (this->*kChanges[pick(std::size(kChanges))])();
  }

  xml::Document& document() { return document_; }

 private:
  struct Place {
    Node* parent;
    std::size_t index;
    [[nodiscard]] Node& node() const { return parent->children[index]; }
  };

  std::size_t pick(std::size_t size) { return static_cast<std::size_t>(random_() % size); }
  bool chance(unsigned one_in) { return pick(one_in) == 0; }
  const std::string& any(const Words& words) { return words[pick(words.size())]; }
  std::string fresh(const std::string& stem) { return stem + "_n" + std::to_string(pick(1000)); }

  void collect(Node& parent, std::string_view name, std::vector<Place>& found) const {
    for (std::size_t i = 0; i < parent.children.size(); ++i) {
      Node& child = parent.children[i];
      if (!child.is_element()) continue;
      if (name.empty() || child.name == name) found.push_back({&parent, i});
      collect(child, name, found);
    }
  }
  std::vector<Place> all(std::string_view name = {}) {
    std::vector<Place> found;
    collect(document_.root, name, found);
    return found;
  }
  std::optional<Place> one(std::string_view name = {}) {
    const auto found = all(name);
    if (found.empty()) return {};
    return found[pick(found.size())];
  }
  static std::string text_of(const Node& node, std::string_view attribute) {
    const xml::Attribute* found = node.attribute(attribute);
    return found != nullptr ? found->value : "";
  }
  std::string some_device() {
    const auto place = one("device");
    return place ? text_of(place->node(), "name") : "";
  }
  void remove(const Place& place) {
    place.parent->children.erase(place.parent->children.begin() + static_cast<std::ptrdiff_t>(place.index));
  }
  static void insert(Node& parent, std::size_t index, Node child) {
    parent.children.insert(
        parent.children.begin() + static_cast<std::ptrdiff_t>(std::min(index, parent.children.size())),
        std::move(child));
  }

  void change_period() {
    if (const auto place = one("device")) set(place->node(), "period", any(kPeriods));
  }

  /// Everything that named the old name names the new one, as a rule.
  void rename() {
    const char* kinds[] = {"device", "device", "device", "bus", "link", "joint", "expander", "channel"};
    const auto place = one(kinds[pick(std::size(kinds))]);
    if (!place) return;
    const std::string old = text_of(place->node(), "name");
    const std::string name =
        chance(3) ? some_device() + "_" +
                        any({"children", "link", "latch", "slots", "up", "up_0", "down", "layout", "yaw", "use_line"})
                  : any(kNames);
    const bool everywhere = !chance(5);
    if (!everywhere) return set(place->node(), "name", name);
    for (const Place& other : all()) {
      for (xml::Attribute& attribute : other.node().attributes) {
        if (attribute.value == old && attribute.name != "type" && attribute.name != "role") attribute.value = name;
      }
    }
  }

  std::string param_value(const ParamSpec& spec) {
    if (!spec.values.empty()) return any(spec.values);
    switch (spec.kind) {
      case ParamKind::boolean:
        return chance(2) ? "true" : "false";
      case ParamKind::text:
        return any(kNames);
      default:
        break;
    }
    const double low = spec.min.value_or(0), high = spec.max.value_or(1e30);
    const std::size_t kind = pick(6);
    if (kind == 5) return any(kWild);
    const double value = kind == 0 ? low : kind == 1 ? high : low + (std::min(high, 1e6) - low) * (kind - 1) / 7;
    return number_text(spec,
                       spec.kind == ParamKind::integer ? static_cast<double>(static_cast<long long>(value)) : value);
  }
  void change_param() {
    const auto place = one("device");
    if (!place) return;
    Node& device = place->node();
    const DeviceType* type = find_type_(text_of(device, "type"));
    if (type == nullptr || type->params.empty()) return;
    const ParamSpec& spec = type->params[pick(type->params.size())];
    auto& children = device.children;
    children.erase(
        std::remove_if(children.begin(), children.end(),
                       [&](const Node& n) { return n.is_element("param") && text_of(n, "name") == spec.name; }),
        children.end());
    children.push_back(element("param", {{"name", spec.name}}, param_value(spec)));
  }

  void move_device() {
    const auto place = one("device");
    if (!place) return;
    Node device = place->node();
    remove(*place);
    const auto target = one(chance(4) ? "finemote" : "device");
    if (!target) return;
    device.attributes.erase(
        std::remove_if(device.attributes.begin(), device.attributes.end(),
                       [&](const xml::Attribute& a) { return a.name == "role" || a.name == "parent"; }),
        device.attributes.end());
    if (value_of(device, "period") == nullptr) set(device, "period", any(kPeriods));
    if (target->node().is_element("device") && chance(3)) {
      set(device, "parent", text_of(target->node(), "name"));
      if (const auto block = one("finemote")) insert(block->node(), pick(9), std::move(device));
      return;
    }
    insert(target->node(), pick(9), std::move(device));
  }

  /// A name, channel, id or address of its own for each device of a copy.
  void make_unique(Node& node) {
    if (node.is_element("device")) {
      set(node, "name", fresh(text_of(node, "name")));
      for (const char* number : {"channel", "id", "address"}) {
        if (std::string* value = value_of(node, number)) *value = std::to_string(pick(16));
      }
    }
    for (Node& child : node.children) make_unique(child);
  }
  void copy_device() {
    const auto place = one(chance(8) ? "" : "device");
    if (!place) return;
    Node copy = place->node();
    if (!chance(6)) make_unique(copy);
    insert(*place->parent, place->index + pick(2), std::move(copy));
  }
  void remove_device() {
    if (const auto place = one(chance(4) ? "" : "device")) remove(*place);
  }
  void add_reads() {
    const auto place = one("device");
    if (!place) return;
    const DeviceType* type = find_type_(text_of(place->node(), "type"));
    const std::string role =
        type == nullptr || type->roles.empty() ? "children" : type->roles[pick(type->roles.size())].name;
    insert(place->node(), 0, element("reads", {{"device", some_device()}, {"role", role}}));
  }
  void swap_siblings() {
    const auto place = one();
    if (!place) return;
    auto& siblings = place->parent->children;
    std::swap(siblings[place->index], siblings[pick(siblings.size())]);
  }
  void wrap_device() {
    const auto place = one("device");
    if (!place) return;
    Node device = place->node();
    Node group = element("device",
                         {{"name", fresh("g")}, {"type", chance(2) ? "group" : "sim_load"}, {"period", any(kPeriods)}});
    for (const char* kept : {"role", "parent"}) {
      if (const std::string* value = value_of(device, kept); value != nullptr && chance(2)) set(group, kept, *value);
    }
    device.attributes.erase(
        std::remove_if(device.attributes.begin(), device.attributes.end(),
                       [&](const xml::Attribute& a) { return a.name == "role" || a.name == "parent"; }),
        device.attributes.end());
    group.children.push_back(std::move(device));
    place->node() = std::move(group);
  }
  void change_joint() {
    const auto place = one("joint");
    if (!place) return;
    Node& joint = place->node();
    const std::size_t kind = pick(4);
    if (kind == 0) {
      const char* types[] = {"revolute", "continuous", "fixed", "prismatic", "floating", "planar"};
      return set(joint, "type", types[pick(std::size(types))]);
    }
    const std::string name = kind == 1 ? "axis" : "origin";
    auto found =
        std::find_if(joint.children.begin(), joint.children.end(), [&](const Node& n) { return n.is_element(name); });
    if (found == joint.children.end()) found = joint.children.insert(found, element(name, {}));
    set(*found, kind == 3 ? "rpy" : "xyz", any(kNumbers));
  }
  void change_board() {
    const auto place = one("board");
    if (!place) return;
    if (chance(2)) return set(place->node(), "tick", any(kPeriods));
    set(place->node(), "name", any({"robomaster_type_c", "qemu_f405", "host"}));
  }
  void add_wcet() {
    const auto place = one("device");
    if (!place) return;
    const Words times{"0us", "1ns", "3us", "200us", "2ms"};
    insert(
        place->node(), 0,
        element("wcet",
                {{"update", any(times)}, {"handle", any(times)}, {"source", any({"budget", "measured", "static"})}}));
  }
  void add_device() {
    const auto place = one(chance(3) ? "finemote" : "device");
    if (!place) return;
    Node device = element(
        "device", {{"name", fresh("d")}, {"type", chance(2) ? "sim_load" : any(kTypes)}, {"period", any(kPeriods)}});
    const auto bus = one("bus");
    if (bus && chance(2)) {
      set(device, "bus", text_of(bus->node(), "name"));
      if (chance(2)) set(device, any({"channel", "id", "address"}), std::to_string(pick(16)));
    }
    insert(place->node(), pick(9), std::move(device));
  }
  void exchange_values() {
    const auto a = one(), b = one();
    if (!a || !b || a->node().attributes.empty()) return;
    xml::Attribute& mine = a->node().attributes[pick(a->node().attributes.size())];
    if (std::string* other = value_of(b->node(), mine.name)) std::swap(mine.value, *other);
  }
  void wild_value() {
    const auto place = one();
    if (!place || place->node().attributes.empty()) return;
    auto& attributes = place->node().attributes;
    const std::size_t index = pick(attributes.size());
    if (chance(4)) {
      attributes.erase(attributes.begin() + static_cast<std::ptrdiff_t>(index));
    } else {
      attributes[index].value = attributes[index].name == "name" ? any(kNames) : chance(2) ? any(kWild) : any(kNumbers);
    }
  }
  /// Any element below any other.
  void wild_element() {
    const auto place = one(), target = one();
    if (!place || !target) return;
    const Node copy = place->node();
    insert(target->node(), pick(9), copy);
  }

  xml::Document document_;
  const StructureMutator::FindType& find_type_;
  std::mt19937& random_;
};

}  // namespace

std::string StructureMutator::operator()(std::mt19937& random, unsigned number) const {
  Mutation mutation(document_, find_type_, random);
  for (auto changes = 1 + random() % 4; changes > 0; --changes) mutation.apply();
  Node& root = mutation.document().root;
  const xml::Attribute* before = document_.root.attribute("name");
  std::string* name = value_of(root, "name");
  if (name != nullptr && before != nullptr && *name == before->value) *name += "_" + std::to_string(number);
  std::string text = xml::write(mutation.document());
  for (auto at = text.find(kLineBreak); at != std::string::npos; at = text.find(kLineBreak))
    text.replace(at, 1, "&#10;");
  return text;
}

}  // namespace finemote::gen
