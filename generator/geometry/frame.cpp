#include "generator/geometry/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace finemote::gen {
namespace {

/// From the root to the link itself.
std::vector<std::string> links_to(const Mechanism& mechanism, const std::string& link) {
  const auto way = mechanism.way_to(link);
  if (!way) return {};
  std::vector<std::string> links{way->empty() ? link : way->front()->parent_link};
  for (const Joint* joint : *way) links.push_back(joint->child_link);
  return links;
}

/// The last link that is on the ways to all; empty without any.
std::string nearest_common(const Mechanism& mechanism, const std::vector<std::string>& links) {
  std::vector<std::string> common;
  for (const std::string& link : links) {
    const std::vector<std::string> way = links_to(mechanism, link);
    if (&link == &links.front()) common = way;
    const auto shared = std::mismatch(common.begin(), common.end(), way.begin(), way.end());
    common.erase(shared.first, common.end());
  }
  return common.empty() ? std::string() : common.back();
}

}  // namespace

std::string carrier(const Mechanism& mechanism, const std::vector<std::string>& joints) {
  std::map<std::string, std::size_t> carried;
  for (const std::string& name : joints) {
    if (const Joint* joint = mechanism.joint(name)) ++carried[joint->parent_link];
  }
  std::size_t most = 0;
  for (const auto& [link, count] : carried) most = std::max(most, count);
  std::vector<std::string> links;
  for (const auto& [link, count] : carried) {
    if (count == most) links.push_back(link);
  }
  return nearest_common(mechanism, links);
}

bool is_about_body(const GeometrySpec& geometry) { return geometry.kind == "allocation" || geometry.kind == "rolling"; }

std::string geometry_link(const Mechanism& mechanism, const std::string& device_link, const GeometrySpec& geometry,
                          const std::vector<std::string>& joints) {
  if (geometry.role.empty()) return {};
  if (!device_link.empty()) return device_link;
  if (is_about_body(geometry)) return carrier(mechanism, joints);
  return geometry.kind == "chain" ? mechanism.base() : mechanism.body();
}

std::string body_problem(const Mechanism& mechanism, const std::string& link, const std::vector<std::string>& joints) {
  const bool is_root = link == mechanism.root();
  const std::vector<std::string> way = links_to(mechanism, link);
  const bool moves = std::find(way.begin(), way.end(), mechanism.base()) != way.end();
  if ((is_root && is_world_name(link)) || !moves)
    return fmt::format("link '{}' is the world, which does not move", link);
  for (const std::string& name : joints) {
    const Joint* joint = mechanism.joint(name);
    if (joint != nullptr && std::find(way.begin(), way.end(), joint->child_link) != way.end())
      return fmt::format("joint '{}' moves link '{}' against the body", name, link);
  }
  return {};
}

}  // namespace finemote::gen
