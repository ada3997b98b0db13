#include "generator/descriptor/check_timing_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/read_param.hpp"

namespace finemote::gen {
namespace {

/// Something comes back to what stages of the device send.
bool asks_for_samples(const DeviceType& type) {
  const std::vector<Frame> frames = type.frames.value_or(std::vector<Frame>());
  return std::any_of(frames.begin(), frames.end(), [&](const Frame& frame) {
    const std::vector<BusKind>& kinds = type.buses_of(frame);
    const bool is_both_ways =
        std::any_of(kinds.begin(), kinds.end(), [](BusKind kind) { return bus_type(kind).is_both_ways; });
    const bool is_begun = frame.stage == FrameStage::update || frame.stage == FrameStage::handle;
    return is_begun && (frame.read_bytes > 0 || is_both_ways);
  });
}

class TimingCheck {
 public:
  TimingCheck(const DeviceType& type, const Contradictions& found) : type_(type), found_(found) {}

  void check() const {
    if (type_.acquisition) check_model(*type_.acquisition);
    if (type_.acquisition && type_.acquisition->conversion) check_conversion(*type_.acquisition->conversion);
    for (std::size_t i = 0; type_.frames && i < type_.frames->size(); ++i) {
      const Frame& frame = (*type_.frames)[i];
      check_interval(frame.stage == FrameStage::autonomous, type_.says_interval_of(frame),
                     {"frames", std::to_string(i)});
    }
    for (std::size_t i = 0; type_.frames && i < type_.frames->size(); ++i)
      check_stage((*type_.frames)[i], {"frames", std::to_string(i), "stage"});
    if (const auto interval = shortest_interval()) check_samples_come(*interval);
    for (std::size_t i = 0; i < type_.interrupts.size(); ++i) {
      const Interrupt& interrupt = type_.interrupts[i];
      check_interval(interrupt.is_autonomous, interrupt.min_interval.has_value(), {"interrupts", std::to_string(i)});
    }
    for (std::size_t i = 0; i < type_.uses.size(); ++i) check_line(type_.uses[i], {"uses", std::to_string(i)});
  }

 private:
  /// Of samples.
  [[nodiscard]] std::optional<Duration> shortest_interval() const {
    if (!type_.acquisition || type_.acquisition->interval_param.empty())
      return type_.acquisition ? type_.acquisition->interval : std::nullopt;
    const ParamSpec* spec = find_spec(type_.params, type_.acquisition->interval_param);
    return spec != nullptr && spec->min ? std::optional(nanoseconds(static_cast<std::int64_t>(*spec->min)))
                                        : std::nullopt;
  }

  void check_model(const Acquisition& acquisition) const {
    if (acquisition.model == Acquisition::Model::streamed) {
      check_rate(acquisition);
      check_stream();
      for (const char* member : {"periods", "begun_every", "conversion", "conversions"}) check_absent(member, "polled");
      if (!asks_for_samples(type_)) check_absent("published_every", "polled");
      return;
    }
    if (!acquisition.periods) {
      found_
          .add({"acquisition"},
               "model 'polled' needs \"periods\", from the begin of a measurement to the update() that publishes it")
          .hint("where update() begins a measurement and the next update() publishes it: \"periods\": 1");
    }
    for (const char* member : {"interval_ns", "interval_param"}) check_absent(member, "streamed");
  }

  /// The sample has to come in something.
  void check_stream() const {
    if (type_.buses.empty() || !type_.frames) return;
    const auto is_frame = [](const Frame& frame) { return frame.stage == FrameStage::autonomous; };
    const auto is_edge = [](const Interrupt& interrupt) { return interrupt.is_autonomous; };
    if (asks_for_samples(type_) || std::any_of(type_.frames->begin(), type_.frames->end(), is_frame)) return;
    if (std::any_of(type_.interrupts.begin(), type_.interrupts.end(), is_edge)) return;
    found_
        .add({"acquisition", "model"},
             "model 'streamed' is of a part that sends by itself, and no frame of stage 'autonomous' says what")
        .hint("add it to \"frames\", or write \"model\": \"polled\" where update() asks for the sample");
  }
  void check_rate(const Acquisition& acquisition) const {
    const JsonPath path{"acquisition", "interval_param"};
    const std::string& param = acquisition.interval_param;
    if (param.empty() && !acquisition.interval) {
      found_.add({"acquisition"}, "model 'streamed' needs \"interval_ns\", the nominal time between two frames")
          .hint("for a frame every 10 ms: \"interval_ns\": 10000000");
    }
    if (param.empty()) return;
    const ParamSpec* spec = find_spec(type_.params, param);
    if (acquisition.interval) {
      found_.add(path, "the interval is fixed or the value of a param, not both").hint("leave one of the two out");
    } else if (spec == nullptr) {
      found_.add(path, fmt::format("there is no param '{}'", param));
    } else if (spec->unit != Unit::time_ns || spec->min.value_or(0) < 1) {
      found_.add(path, fmt::format("param '{}' can be no interval", param))
          .hint("it needs \"unit\": \"ns\" and a \"range\" that begins above 0");
    }
  }
  void check_absent(const std::string& member, const char* model) const {
    const JsonPath path{"acquisition", member};
    if (found_.has(path)) found_.add(path, fmt::format("\"{}\" is of model '{}'", member, model));
  }

  void check_conversion(const Conversion& conversion) const {
    const JsonPath path{"acquisition", "conversion"};
    const bool is_fixed = found_.has({"acquisition", "conversion", "ns"});
    const bool is_by_value = !conversion.param.empty() || found_.has({"acquisition", "conversion", "ns_by_value"});
    if (is_fixed == is_by_value) {
      found_
          .add(path, is_fixed ? "a conversion is fixed or by the value of a param, not both"
                              : "how long a conversion takes is missing")
          .hint("write \"ns\", or \"param\" and \"ns_by_value\"");
    }
    if (!is_by_value) return;
    const ParamSpec* spec = find_spec(type_.params, conversion.param);
    if (conversion.param.empty()) {
      found_.add(path, "\"ns_by_value\" needs \"param\", the param whose values it lists")
          .hint("where every conversion takes as long, write \"ns\" instead");
    } else if (spec == nullptr) {
      found_.add({"acquisition", "conversion", "param"}, fmt::format("there is no param '{}'", conversion.param));
    } else {
      check_values(conversion, *spec);
    }
  }
  void check_values(const Conversion& conversion, const ParamSpec& spec) const {
    if (spec.values.empty()) {
      found_
          .add({"acquisition", "conversion", "param"},
               fmt::format("param '{}' has no \"values\" to give a conversion for", spec.name))
          .hint("write the longest conversion as \"ns\"");
      return;
    }
    for (const std::string& value : spec.values) {
      if (conversion.by_value.count(value) > 0) continue;
      found_
          .add({"acquisition", "conversion", "ns_by_value"},
               fmt::format("the conversion for '{}' of param '{}' is missing", value, spec.name))
          .hint(fmt::format("add its nanoseconds, for example \"{}\": 1000000", value));
    }
    for (const auto& [value, time] : conversion.by_value) {
      if (std::find(spec.values.begin(), spec.values.end(), value) == spec.values.end())
        found_.add({"acquisition", "conversion", "ns_by_value", value},
                   fmt::format("'{}' is no value of param '{}'", value, spec.name));
    }
  }

  /// Some frame comes as often as samples do.
  void check_samples_come(Duration interval) const {
    std::optional<Duration> soonest;
    for (const Frame& frame : type_.frames.value_or(std::vector<Frame>{})) {
      if (frame.stage != FrameStage::autonomous) continue;
      const Duration apart = frame.min_interval.value_or(interval);
      soonest = std::min(apart, soonest.value_or(apart));
    }
    if (!soonest || *soonest <= interval || asks_for_samples(type_)) return;
    found_
        .add({"acquisition", "interval_ns"},
             fmt::format("no frame comes every {} ns: they are at least {} ns apart", interval.ns(), soonest->ns()))
        .hint("a frame without \"min_interval_ns\" comes once for each sample");
  }

  void check_interval(bool is_autonomous, bool is_known, const JsonPath& path) const {
    if (!is_autonomous || is_known) return;
    found_.add(path, "what comes by itself needs \"min_interval_ns\", the shortest time between two")
        .hint("for at most one in 10 ms: \"min_interval_ns\": 10000000");
  }

  /// That a frame can be sent so.
  void check_stage(const Frame& frame, const JsonPath& path) const {
    const auto is_output = [](BusKind kind) { return bus_type(kind).channels == BusType::Channels::outputs; };
    const bool is_pulse =
        frame.use.empty() && !type_.buses.empty() && std::all_of(type_.buses.begin(), type_.buses.end(), is_output);
    if (frame.stage == FrameStage::flush && frame.shared.empty() && !is_pulse) {
      found_
          .add(path, "a frame of stage 'flush' is one that several devices fill: it needs \"identifier\", on a CAN bus")
          .hint("what a device sends behind its own handle() is of stage 'handle'");
    }
    if (frame.stage == FrameStage::flush && frame.read_bytes > 0) {
      found_.add(path, "nothing comes back within a frame that several devices fill")
          .hint("what each part answers is an entry of its own: { \"stage\": \"handle\", \"read\": 8 }");
    }
    if (frame.stage != FrameStage::autonomous) return;
    const std::vector<BusKind>& kinds = type_.buses_of(frame);
    const bool asks = !kinds.empty() &&
                      std::all_of(kinds.begin(), kinds.end(), [](BusKind kind) { return bus_type(kind).is_mastered; });
    if (asks) {
      found_.add(path, fmt::format("nothing comes by itself over a bus of kind '{}'", bus_type(kinds.front()).name));
    } else if (!type_.acquisition) {
      found_.add(path, "a part that sends by itself needs \"acquisition\": how old a sample is when it is read")
          .hint(
              "for a frame every 10 ms, also where nobody looks at it: \"acquisition\": { \"model\": \"streamed\", "
              "\"interval_ns\": 10000000 }");
    }
  }

  /// Interrupts that nobody counts would be in no bound.
  void check_line(const UseSpec& use, const JsonPath& path) const {
    if (use.function != "interrupt") return;
    const bool is_counted = std::any_of(type_.interrupts.begin(), type_.interrupts.end(),
                                        [&](const Interrupt& interrupt) { return interrupt.use == use.role; });
    if (is_counted) return;
    found_.add(path, fmt::format("no entry of \"interrupts\" says how often the line '{}' interrupts", use.role))
        .hint(fmt::format("for at most one edge in 10 ms: \"interrupts\": [{{ \"source\": \"edge\", \"use\": \"{}\", "
                          "\"arrival\": \"autonomous\", \"min_interval_ns\": 10000000 }}]",
                          use.role));
  }

  const DeviceType& type_;
  const Contradictions& found_;
};

}  // namespace

void check_timing_figures(const DeviceType& type, const Contradictions& found) { TimingCheck(type, found).check(); }

}  // namespace finemote::gen
