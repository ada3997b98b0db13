// The `<finemote>` blocks of a robot as flat lists of tags that hold only what version 1 knows.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/index/ids.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

struct DeviceTag {
  const xml::Node* node = nullptr;
  std::optional<DeviceId> nested_in;  ///< the device around it
};

/// All blocks merged, in document order.
struct Tags {
  std::vector<const xml::Node*> blocks;
  std::vector<const xml::Node*> boards;
  Table<BusId, const xml::Node*> buses;
  Table<ExpanderId, const xml::Node*> expanders;
  std::vector<const xml::Node*> requirements;
  Table<DeviceId, DeviceTag> devices;  ///< by start tag
  /// A <bus> whose type is a model of <expander>, and the names of buses that go with it: what names them is right.
  std::vector<const xml::Node*> misnamed_expanders;
  std::vector<std::string> lost_buses;
  bool has_xacro = false;  ///< xacro is left over: what else is wrong may follow from it

  /// Attributes that an unknown one was probably meant to be: they are not missing as well.
  std::set<std::pair<const xml::Node*, std::string>> misspelt;
  [[nodiscard]] bool is_misspelt(const xml::Node& node, std::string_view attribute) const {
    return !misspelt.empty() && misspelt.contains({&node, std::string(attribute)});
  }
};

/// What hints name, looked up when one does.
struct Suggested {
  std::function<std::string()> board, mux;
};

/// Collects the tags below `<robot>`, which has to outlive them. Reports FM3008 (unknown elements), FM3009 and FM3010
/// (unknown and missing attributes), FM3028 (text where none belongs), FM1002 (xacro left over).
/// `suggested` is asked for what a hint names.
Tags read_tags(const xml::Node& robot, bool from_xacro, const std::vector<std::string>& expander_models,
               const Suggested& suggested, Diagnostics& diagnostics);

}  // namespace finemote::gen
