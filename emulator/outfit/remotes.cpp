// Receivers of remote controls.
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/serial_line.hpp"
#include "emulator/parts/remote.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class RemoteElement : public Element {
 public:
  RemoteElement(Outfit& outfit, const Json& part, const std::string& name, RemoteReceiver::Encode encode)
      : Element(outfit, name),
        model(outfit.board().world(), outfit.usart_of(part), format_of(part), encode, period_of(part), phase_of(part)) {
    // Neither has a length: the end of a frame is known by the silence of one byte after it.
    model.on_frame = [this, byte = format_of(part).byte_time()](Time begin, Time end) {
      return record_sample(begin, end + byte);
    };
  }

  RemoteReceiver model;
};

template <RemoteReceiver::Encode Encode>
std::unique_ptr<Element> make(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<RemoteElement>(outfit, part, name, Encode);
}

Hands::Switch switch_of(const Json& event, const char* key, Hands::Switch fallback) {
  const auto word = maybe<std::string>(event, key, "");
  return word == "up" ? Hands::kUp : word == "middle" ? Hands::kMiddle : word == "down" ? Hands::kDown : fallback;
}

void move(RemoteElement& part, const Json& event) {
  Hands& hands = part.model.hands;
  hands.right_x = maybe(event, "right_x", hands.right_x);
  hands.right_y = maybe(event, "right_y", hands.right_y);
  hands.left_x = maybe(event, "left_x", hands.left_x);
  hands.left_y = maybe(event, "left_y", hands.left_y);
  hands.wheel = maybe(event, "wheel", hands.wheel);
  hands.left_switch = switch_of(event, "left_switch", hands.left_switch);
  hands.right_switch = switch_of(event, "right_switch", hands.right_switch);
  hands.keys = maybe(event, "keys", hands.keys);
}

void silence(RemoteElement& part, const Json& event) { part.model.silent = is_on(event); }

void damage(RemoteElement& part, const Json& event) { part.model.damaged_frames = need<unsigned>(event, "frames"); }

void fail_safe(RemoteElement& part, const Json& event) { part.model.hands.failsafe = is_on(event); }

std::vector<Member> sticks() {
  std::vector<Member> members;
  for (const char* name : {"right_x", "right_y", "left_x", "left_y", "wheel"})
    members.push_back(number(name, "", "to the right and away from the operator", -1, 1));
  for (const char* name : {"left_switch", "right_switch"})
    members.push_back(choice(name, "", {"up", "middle", "down"}));
  members.push_back(integer("keys", "", "a bit each", 0, 65535));
  return members;
}

using RemoteRow = Rows<RemoteElement>;

Model receiver(const char* type, Model::Make make) {
  return {
      .type = type,
      .summary = "frames of a remote control every 14 ms",
      .figures = serial_line() + pace(14e6),
      .clock_tolerance_ppm = kResonatorTolerancePpm,
      .verbs = {with_member(RemoteRow::stimulus("move", "what the operator does; the rest stays", sticks(), move)),
                RemoteRow::fault("silent", "sends nothing", {until()}, silence),
                RemoteRow::fault("damage", "frames that lack a byte", {count("frames")}, damage)},
      .make = make,
  };
}

}  // namespace

Model dbus_receiver() { return receiver("dbus_receiver", make<dbus_frame>); }

Model sbus_receiver() {
  Model model = receiver("sbus_receiver", make<sbus_frame>);
  model.verbs.push_back(
      RemoteRow::fault("failsafe", "the receiver reports that it lost its transmitter", {until()}, fail_safe));
  return model;
}

}  // namespace finemote::emulator
