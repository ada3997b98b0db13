#include "generator/emit/can_fields.hpp"

#include <fmt/format.h>

namespace finemote::gen {
namespace {

/// Whether the slot is the one of its device's own bus; the bus of a `<use>` is for others to receive on.
bool is_own(const Device& device, const Slot& slot) { return device.segment == slot.segment; }

/// Fields of templates/can_ids.mustache.
Data identifier_fields(const IdentifierRange& range) {
  Data data;
  set_choice(data, {"is_none", "is_one", "is_range"},
             range.count == 0   ? "is_none"
             : range.count == 1 ? "is_one"
                                : "is_range");
  data.set("first", fmt::format("{:#05x}", range.first));
  data.set("count", std::to_string(range.count));
  return data;
}

/// One for each range after the first; each but the last names the next.
Data inbox_list(const std::vector<IdentifierRange>& ranges) {
  DataList inboxes;
  inboxes.reserve(ranges.size());
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    Data& inbox = inboxes.emplace_back(identifier_fields(ranges[i]));
    inbox.set("next", std::to_string(i));
  }
  return enumerated(std::move(inboxes));
}

std::string wait_value(std::optional<Duration> wait) {
  return wait ? std::to_string(wait->ns()) : "finemote::CanSlot::kAnyTime";
}

}  // namespace

void set_can(const Plan& plan, const timing::RobotBounds& bounds, const Slot& slot, Data& data) {
  const Device& device = plan.robot.devices[*slot.device];
  const std::vector<IdentifierRange> ranges =
      is_own(device, slot) ? device.type->received(slot.address) : std::vector<IdentifierRange>();
  const auto share = is_own(device, slot) ? device.type->shared_frame(slot.address) : std::nullopt;
  data.set("receives", identifier_fields(ranges.empty() ? IdentifierRange{0, 0} : ranges.front()));
  data.set("waits", ranges.empty() ? "0" : wait_value(bounds.devices[*slot.device].wait));
  data.set("has_inboxes", ranges.size() > 1);
  data.set("inboxes", inbox_list(ranges));
  data.set("inbox_count", std::to_string(ranges.empty() ? 0 : ranges.size() - 1));
  data.set("has_share", share.has_value());
  if (!share) return;
  data.set("share_identifier", fmt::format("{:#05x}", share->identifier));
  data.set("share_offset", std::to_string(share->offset(slot.address)));
  data.set("share_width", std::to_string(share->width));
}

}  // namespace finemote::gen
