#include "generator/model/connection.hpp"

namespace finemote::gen {

std::vector<Connection> connections_of(const Device& device) {
  std::vector<Connection> list;
  if (device.segment) list.push_back({*device.segment, nullptr});
  for (const Use& use : device.uses) {
    if (use.segment) list.push_back({*use.segment, &use});
  }
  return list;
}

std::vector<Frame> frames_over(const Device& device, const Connection& connection) {
  return device.type->frames_over(connection.use != nullptr ? connection.use->spec->role : "");
}

const std::string& format_over(const Device& device, const Connection& connection) {
  return connection.use != nullptr ? connection.use->spec->format : device.type->format;
}

}  // namespace finemote::gen
