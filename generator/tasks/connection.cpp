#include "generator/tasks/connection.hpp"

namespace finemote::gen::timing {

std::vector<Connection> connections_of(const gen::Device& device) {
  std::vector<Connection> list;
  if (device.segment) list.push_back({*device.segment, nullptr});
  for (const Use& use : device.uses) {
    if (use.segment) list.push_back({*use.segment, &use});
  }
  return list;
}

std::vector<Frame> frames_over(const gen::Device& device, const Connection& connection) {
  std::vector<Frame> frames;
  const std::string role = connection.use != nullptr ? connection.use->spec->role : "";
  for (const Frame& frame : device.type->frames.value_or(std::vector<Frame>())) {
    if (frame.use == role) frames.push_back(frame);
  }
  return frames;
}

const std::string& format_over(const gen::Device& device, const Connection& connection) {
  return connection.use != nullptr ? connection.use->spec->format : device.type->format;
}

}  // namespace finemote::gen::timing
