// Parts on serial lines.
#include <numbers>

#include "emulator/outfit/bodies.hpp"
#include "emulator/parts/h30.hpp"
#include "emulator/parts/remote.hpp"
#include "emulator/parts/serial_terminal.hpp"

namespace finemote::emulator {
namespace {

SerialFormat format_of(const Json& part) {
  SerialFormat format;
  format.baud = need<std::uint32_t>(part, "baud");
  format.even_parity = maybe(part, "even_parity", false);
  format.stop_bits = maybe(part, "stop_bits", 1U);
  if (format.baud == 0) refuse(part, "'baud' is 0");
  return format;
}

Time period_of_part(const Json& part, std::uint64_t fallback_ns) {
  const auto period = maybe(part, "period_ns", fallback_ns);
  if (period == 0) refuse(part, "'period_ns' is 0");
  return from_ns(period);
}

class H30Element : public Element {
 public:
  H30Element(Outfit& outfit, const Json& part, const std::string& name)
      : outfit_(outfit),
        seat_(part),
        format_(format_of(part)),
        model_(outfit.board().world(), outfit.usart_of(part), format_, period_of_part(part, 5'000'000),
               from_ns(maybe<std::uint64_t>(part, "phase_ns", 0)), [this, name](Time now) { return feel(now, name); }) {
    on("silent", [this](const Json& event) { model_.silent = maybe(event, "on", true); });
    on("damage", [this](const Json& event) { model_.damaged_frames = need<unsigned>(event, "frames"); });
    on("move", [this](const Json& event) { seat_.move(outfit_.now(), event); });
    show("frames", [this] { return model_.frames(); });
  }

  void connect(Outfit& outfit) override { seat_.connect(outfit); }

 private:
  Attitude feel(Time now, const std::string& name) {
    const Time arrival = now + h30_frame(0, {}).size() * format_.byte_time();
    outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(now), to_ns(arrival), 0});
    const Motion motion = seat_.motion(now);
    const Angles angles = angles_of(motion.attitude);
    constexpr double kDegree = std::numbers::pi / 180;
    Attitude attitude;
    attitude.roll = angles.roll / kDegree;
    attitude.pitch = angles.pitch / kDegree;
    attitude.yaw = angles.yaw / kDegree;
    for (unsigned i = 0; i < 3; ++i) {
      attitude.rate[i] = motion.rate[i] / kDegree;
      attitude.acceleration[i] = motion.force[i];
    }
    return attitude;
  }

  Outfit& outfit_;
  Seat seat_;
  SerialFormat format_;
  H30 model_;
};

class TerminalElement : public Element, public Hearing {
 public:
  TerminalElement(Outfit& outfit, const Json& part)
      : model_(outfit.board().world(), outfit.usart_of(part), format_of(part)) {
    on("send", [this](const Json& event) { model_.send(need<std::string>(event, "text")); });
    show("heard", [this] { return static_cast<double>(model_.heard().size()); });
  }
  SerialTerminal& terminal() override { return model_; }

 private:
  SerialTerminal model_;
};

Hands::Switch switch_of(const Json& event, const char* key, Hands::Switch fallback) {
  const auto word = maybe<std::string>(event, key, "");
  return word == "up" ? Hands::kUp : word == "middle" ? Hands::kMiddle : word == "down" ? Hands::kDown : fallback;
}

void change(Hands& hands, const Json& event) {
  hands.right_x = maybe(event, "right_x", hands.right_x);
  hands.right_y = maybe(event, "right_y", hands.right_y);
  hands.left_x = maybe(event, "left_x", hands.left_x);
  hands.left_y = maybe(event, "left_y", hands.left_y);
  hands.wheel = maybe(event, "wheel", hands.wheel);
  hands.left_switch = switch_of(event, "left_switch", hands.left_switch);
  hands.right_switch = switch_of(event, "right_switch", hands.right_switch);
  hands.keys = maybe(event, "keys", hands.keys);
}

class RemoteElement : public Element {
 public:
  RemoteElement(Outfit& outfit, const Json& part, const std::string& name, RemoteReceiver::Encode encode)
      : model_(outfit.board().world(), outfit.usart_of(part), format_of(part), encode, period_of_part(part, 14'000'000),
               from_ns(maybe<std::uint64_t>(part, "phase_ns", 0))) {
    // Neither has a length: the end of a frame is known by the silence of one byte after it.
    model_.on_frame = [&outfit, name, byte = format_of(part).byte_time()](Time begin, Time end) {
      outfit.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(begin), to_ns(end + byte), 0});
    };
    on("silent", [this](const Json& event) { model_.silent = maybe(event, "on", true); });
    on("damage", [this](const Json& event) { model_.damaged_frames = need<unsigned>(event, "frames"); });
    on("move", [this](const Json& event) { change(model_.hands, event); });
    if (encode == sbus_frame)
      on("failsafe", [this](const Json& event) { model_.hands.failsafe = maybe(event, "on", true); });
  }

 private:
  RemoteReceiver model_;
};

}  // namespace

std::unique_ptr<Element> make_h30(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<H30Element>(outfit, part, name);
}
std::unique_ptr<Element> make_host_terminal(Outfit& outfit, const Json& part, const std::string&) {
  return std::make_unique<TerminalElement>(outfit, part);
}
std::unique_ptr<Element> make_dbus_receiver(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<RemoteElement>(outfit, part, name, dbus_frame);
}
std::unique_ptr<Element> make_sbus_receiver(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<RemoteElement>(outfit, part, name, sbus_frame);
}

}  // namespace finemote::emulator
