#include "generator/report/data_block.hpp"

#include "generator/units/units.hpp"

namespace finemote::gen::report {
namespace {

template <class... Numbers>
void add(Json& list, Numbers... numbers) {
  (list.push_back(numbers), ...);
}

/// Each with its distance from the one before it: thousands of large numbers would be half of the page.
Json stages_of(const Timeline& timeline) {
  Json list = Json::array();
  Duration before;
  for (const Timeline::Stage& s : timeline.stages) {
    add(list, s.device.value(), s.is_handle ? 1 : 0, (s.begin - before).ns(), (s.end - s.begin).ns());
    before = s.begin;
  }
  return list;
}

Json jobs_of(const Timeline& timeline) {
  Json list = Json::array();
  for (const Timeline::Job& j : timeline.jobs) add(list, j.bucket, j.begin.ns(), (j.end - j.begin).ns());
  return list;
}

Json interrupts_of(const Timeline& timeline) {
  Json list = Json::array();
  for (const Timeline::Interrupt& i : timeline.interrupts) add(list, i.stream, i.begin.ns(), (i.end - i.begin).ns());
  return list;
}

/// A frame names its device by its place; flush i by -1 - i. Flags: 1 received, 2 asked for.
Json frames_json(const Timeline& timeline) {
  Json list = Json::array();
  for (const Timeline::Frame& f : timeline.frames) {
    const auto of = f.device ? static_cast<std::int64_t>(f.device->value()) : -1 - static_cast<std::int64_t>(f.flush);
    add(list, f.bus.value(), (f.is_received ? 1 : 0) + (f.is_asked_for ? 2 : 0), of, f.begin.ns(),
        (f.end - f.begin).ns());
  }
  return list;
}

/// The devices whose commands each flush carries.
Json flushes_json(const timing::Model& model) {
  Json list = Json::array();
  for (const timing::Flush& flush : model.flushes) {
    Json devices = Json::array();
    for (const Rank d : flush.devices) devices.push_back(d.value());
    list.push_back(std::move(devices));
  }
  return list;
}

}  // namespace

std::string script_text(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

std::string data_block(const timing::Model& model, const Timeline& timeline, const std::string& profile) {
  Json data{{"profile", profile},
            {"hyperperiod", timeline.hyperperiod ? Json(timeline.hyperperiod->ns()) : Json(nullptr)},
            {"length", timeline.length.ns()},
            {"buckets", Json::array()},
            {"streams", timeline.streams},
            {"buses", Json::array()},
            {"devices", Json::array()},
            {"bucketOf", Json::array()}};
  for (const Duration period : timeline.periods)
    data["buckets"].push_back({{"name", units::spaced_duration(period)}, {"period", period.ns()}});
  for (const timing::Bus& bus : model.buses) data["buses"].push_back(bus.name);
  for (const timing::Device& device : model.devices) {
    data["devices"].push_back(device.name);
    for (std::size_t i = 0; i < timeline.periods.size(); ++i) {
      if (timeline.periods[i] == device.period) data["bucketOf"].push_back(i);
    }
  }
  data["flushes"] = flushes_json(model);
  data["stages"] = stages_of(timeline);
  data["jobs"] = jobs_of(timeline);
  data["interrupts"] = interrupts_of(timeline);
  data["frames"] = frames_json(timeline);
  return script_text(data);
}

}  // namespace finemote::gen::report
