#include "generator/descriptor/check_can_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {
namespace {

/// Where an entry of `bus.receives` stands; of one without a list, the member.
JsonPath entry_path(std::size_t index) { return {"bus", "receives", std::to_string(index)}; }

JsonPath operator/(JsonPath path, const char* member) {
  path.emplace_back(member);
  return path;
}

class ReceivedCheck {
 public:
  ReceivedCheck(const DeviceType& type, const Contradictions& found) : type_(type), found_(found) {}

  void run() {
    bool is_right = true;
    for (std::size_t i = 0; i < type_.receives.size(); ++i) is_right = check_entry(type_.receives[i], i) && is_right;
    const std::uint64_t first = type_.id_min.value_or(0);
    // an id beyond the highest identifier is one that nothing depends on
    const std::uint64_t last = std::max(first, std::min<std::uint64_t>(type_.id_max.value_or(0), kHighestIdentifier));
    for (std::uint64_t id = first; is_right && id <= last; ++id) is_right = check_id(static_cast<std::uint32_t>(id));
  }

 private:
  [[nodiscard]] JsonPath path_of(std::size_t index, const char* member) const {
    const bool is_list = found_.has(entry_path(0));
    return (is_list ? entry_path(index) : JsonPath{"bus", "receives"}) / member;
  }
  bool check_entry(const Identifiers& entry, std::size_t index) {
    const bool is_block =
        (entry.count & (entry.count - 1)) == 0 && entry.base % entry.count == 0 && entry.per_id % entry.count == 0;
    if (!is_block) {
      found_.add(path_of(index, "count"),
                 fmt::format("{} identifiers from {:#x} on are no block that a filter accepts: the count is a "
                             "power of two that divides base and per_id",
                             entry.count, entry.base));
    }
    const std::uint64_t last = entry.of(type_.id_max.value_or(0)).last();
    const bool fits = last <= kHighestIdentifier;
    if (!fits) found_.add(path_of(index, "base"), fmt::format("the identifier {:#x} has more than 11 bits", last));
    return is_block && fits;
  }
  /// Whether the entries of a device with this id have no identifier in common.
  bool check_id(std::uint32_t id) {
    std::array<bool, kHighestIdentifier + 1> taken{};
    for (std::size_t i = 0; i < type_.receives.size(); ++i) {
      const IdentifierRange range = type_.receives[i].of(id);
      for (std::uint64_t identifier = range.first; identifier <= range.last(); ++identifier) {
        if (!taken.at(identifier)) {
          taken.at(identifier) = true;
          continue;
        }
        const std::string whose = type_.needs_id ? fmt::format(" of a device with id {}", id) : "";
        found_.add(path_of(i, "base"),
                   fmt::format("the identifier {:#x}{} is in an earlier entry too", identifier, whose));
        return false;
      }
    }
    return true;
  }

  const DeviceType& type_;
  const Contradictions& found_;
};

class SharedCheck {
 public:
  explicit SharedCheck(const Contradictions& found) : found_(found) {}

  void check(const Frame& frame, std::size_t index) {
    const JsonPath path{"frames", std::to_string(index)};
    const bool is_by_id = found_.has(path / "identifiers");
    if (is_by_id && found_.has(path / "identifier")) {
      found_.add(path / "identifier", "a frame has either \"identifier\" or \"identifiers\"");
      return;
    }
    if (!frame.shared.empty() && frame.write_bytes != SharedFrame::kBytes)
      found_.add(path / "write", "a frame that devices share has 8 bytes");
    for (std::size_t i = 0; i < frame.shared.size(); ++i) {
      if (is_by_id)
        check_ids(frame.shared[i], path / "identifiers" / std::to_string(i).c_str() / "ids");
      else
        check_ids(frame.shared[i], path / "identifier");
    }
  }

 private:
  void check_ids(const SharedFrame& shared, const JsonPath& path) {
    if (shared.id_min > shared.id_max) {
      found_.add(path, fmt::format("the ids end at {}, before {}, where they begin", shared.id_max, shared.id_min));
    } else if (shared.offset(shared.id_max) + shared.width > SharedFrame::kBytes) {
      found_.add(path, fmt::format("frame {:#x} does not hold {} bytes for each of the ids {} to {}", shared.identifier,
                                   shared.width, shared.id_min, shared.id_max));
    }
    const auto overlaps = [&](const SharedFrame& other) {
      return other.holds(shared.id_min) || shared.holds(other.id_min);
    };
    if (std::any_of(seen_.begin(), seen_.end(), overlaps))
      found_.add(path, fmt::format("id {} shares two frames", shared.id_min));
    seen_.push_back(shared);
  }

  const Contradictions& found_;
  std::vector<SharedFrame> seen_;
};

/// The driver of a CAN bus sees a frame only if its identifier is received, and what it does not see keeps the bus busy
/// behind its back: then it is unknown since when another one waited.
void check_streams(const DeviceType& type, const Contradictions& found) {
  const bool is_on_can =
      std::any_of(type.buses.begin(), type.buses.end(), [](BusKind kind) { return bus_type(kind).is_arbitrated; });
  if (!is_on_can || !type.frames) return;
  std::uint64_t left = 0;
  for (const Identifiers& entry : type.receives) left += entry.count;
  for (std::size_t i = 0; i < type.frames->size(); ++i) {
    const Frame& frame = (*type.frames)[i];
    const bool is_answer = frame.stage != FrameStage::autonomous;
    if (is_answer && (!frame.use.empty() || frame.read_bytes == 0)) continue;
    if (is_answer && !type.receives.empty()) continue;  // it may have the identifier of another frame
    if (left > 0) {
      --left;
      continue;
    }
    found.add({"frames", std::to_string(i), "stage"},
              fmt::format("the part sends this frame{}, and \"receives\" has no identifier for it: the driver of a CAN "
                          "bus stamps frames by all that keep it busy",
                          is_answer ? " when it is asked" : " by itself"));
    return;
  }
}

}  // namespace

void check_can_frames(const DeviceType& type, const Contradictions& found) {
  ReceivedCheck(type, found).run();
  check_streams(type, found);
  SharedCheck shared(found);
  for (std::size_t i = 0; type.frames && i < type.frames->size(); ++i) shared.check((*type.frames)[i], i);
}

}  // namespace finemote::gen
