#include "generator/descriptor/frames.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "generator/descriptor/member.hpp"

namespace finemote::gen {
namespace {

constexpr std::array<std::pair<const char*, FrameStage>, 4> kStages{{{"update", FrameStage::update},
                                                                     {"handle", FrameStage::handle},
                                                                     {"flush", FrameStage::flush},
                                                                     {"autonomous", FrameStage::autonomous}}};

FrameStage stage_of(const std::string& text) {
  const auto found =
      std::find_if(kStages.begin(), kStages.end(), [&](const auto& entry) { return text == entry.first; });
  return found == kStages.end() ? FrameStage::update : found->second;
}

std::vector<SharedFrame> read_shared(const Json& frame) {
  const std::uint32_t width = frame.value("width", SharedFrame().width);
  const auto by_id = [&](const Json& entry) {
    const Json& ids = entry.at("ids");
    return SharedFrame{entry.at("identifier").get<std::uint32_t>(), ids.at(0).get<std::uint32_t>(),
                       ids.at(1).get<std::uint32_t>(), width};
  };
  std::vector<SharedFrame> shared = read_list<SharedFrame>(frame, "identifiers", by_id);
  if (const auto identifier = optional_member<std::uint32_t>(frame, "identifier"))
    shared.insert(shared.begin(), {*identifier, 0, UINT32_MAX, width});
  return shared;
}

Frame read_frame(const Json& value) {
  Frame frame;
  frame.stage = stage_of(value.at("stage").get<std::string>());
  frame.write_bytes = value.value("write", std::int64_t{0});
  frame.read_bytes = value.value("read", std::int64_t{0});
  frame.use = value.value("use", std::string());
  frame.unit = value.value("unit", 0);
  frame.min_interval = duration_member(value, "min_interval_ns");
  frame.shared = read_shared(value);
  frame.has_sample = value.value("has_sample", frame.has_sample);
  frame.in_dma_memory = value.value("in_dma_memory", false);
  frame.summary = value.value("summary", std::string());
  return frame;
}

Exchange read_exchange(const Json& value) {
  return {value.value("write", std::int64_t{0}), value.value("read", std::int64_t{0})};
}

}  // namespace

const char* to_string(FrameStage stage) {
  const auto found =
      std::find_if(kStages.begin(), kStages.end(), [&](const auto& entry) { return stage == entry.second; });
  return found->first;
}

std::vector<Frame> read_frames(const Json& list) {
  std::vector<Frame> frames;
  for (const Json& entry : list) frames.push_back(read_frame(entry));
  return frames;
}

ExpanderFrames read_expander_frames(const Json& value) {
  ExpanderFrames frames;
  frames.per_flush = read_exchange(value.value("per_flush", Json::object()));
  frames.per_channel = read_exchange(value.value("per_channel", Json::object()));
  if (const auto check = value.find("check"); check != value.end()) {
    frames.check = read_exchange(*check);
    frames.checked_every = check->value("every", std::string());
  }
  return frames;
}

}  // namespace finemote::gen
