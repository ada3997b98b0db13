#include "generator/model/shared_frame.hpp"

namespace finemote::gen {

std::optional<SharedFrame> shared_frame_of(const Device& device) {
  if (device.type == nullptr || !device.segment || (device.type->needs_id && !device.id)) return {};
  return device.type->shared_frame(device.id.value_or(0));
}

}  // namespace finemote::gen
