#include "emulator/outfit.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace finemote::emulator {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const Json& entry, const std::string& why) {
  throw std::invalid_argument(why + ": " + entry.dump());
}

template <class T>
T need(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end()) refuse(entry, std::string("'") + key + "' is missing");
  try {
    return found->get<T>();
  } catch (const nlohmann::json::exception&) {
    refuse(entry, std::string("'") + key + "' has the wrong type");
  }
}

template <class T>
T maybe(const Json& entry, const char* key, T fallback) {
  return entry.contains(key) ? need<T>(entry, key) : fallback;
}

template <class Map>
auto* find(Map& map, const std::string& name) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : found->second.get();
}

SerialFormat format_of(const Json& part) {
  SerialFormat format;
  format.baud = need<std::uint32_t>(part, "baud");
  format.even_parity = maybe(part, "even_parity", false);
  format.stop_bits = maybe(part, "stop_bits", 1U);
  if (format.baud == 0) refuse(part, "'baud' is 0");
  return format;
}

void change(Attitude& attitude, const Json& event) {
  attitude.roll = maybe(event, "roll", attitude.roll);
  attitude.pitch = maybe(event, "pitch", attitude.pitch);
  attitude.yaw = maybe(event, "yaw", attitude.yaw);
  attitude.rate = maybe(event, "rate", attitude.rate);
  attitude.acceleration = maybe(event, "acceleration", attitude.acceleration);
}

constexpr double kSurfacePascal = 101'325;

}  // namespace

H30* Outfit::h30(const std::string& name) { return find(h30s_, name); }
Ms5837* Outfit::ms5837(const std::string& name) { return find(ms5837s_, name); }
Tca9548a* Outfit::tca9548a(const std::string& name) { return find(muxes_, name); }
Pca9685* Outfit::pca9685(const std::string& name) { return find(pwms_, name); }
SerialTerminal* Outfit::terminal(const std::string& name) { return find(terminals_, name); }

void Outfit::add(const Json& document) {
  if (!document.is_object() || maybe<std::string>(document, "schema", "") != "finemote.scenario/1")
    throw std::invalid_argument("a scenario begins with \"schema\": \"finemote.scenario/1\"");
  for (const auto& [key, value] : document.items()) {
    if (key != "schema" && key != "parts" && key != "events")
      throw std::invalid_argument("a scenario has no member '" + key + "'");
    if (key != "schema" && !value.is_array()) throw std::invalid_argument("'" + key + "' is a list");
  }
  if (document.contains("parts")) {
    for (const Json& part : document["parts"]) add_part(part);
  }
  if (document.contains("events")) {
    for (const Json& event : document["events"]) add_event(event);
  }
}

Usart& Outfit::usart_of(const Json& part) {
  Usart* usart = board_.chip().usart(need<std::string>(part, "port"));
  if (usart == nullptr) refuse(part, "the board has no such serial port");
  return *usart;
}

/// The bus itself, or one channel of a mux on it.
I2cLine& Outfit::line_of(const Json& part) {
  if (part.contains("mux")) {
    Tca9548a* mux = tca9548a(need<std::string>(part, "mux"));
    const auto channel = need<unsigned>(part, "channel");
    if (mux == nullptr || channel > 7) refuse(part, "there is no such mux channel");
    return mux->channel(channel);
  }
  I2c* i2c = board_.chip().i2c(need<std::string>(part, "port"));
  if (i2c == nullptr) refuse(part, "the board has no such I2C port");
  return i2c->line;
}

void Outfit::add_h30(const Json& part, const std::string& name) {
  Usart& usart = usart_of(part);
  const SerialFormat format = format_of(part);
  attitudes_[name];
  const auto feel = [this, name, format](Time now) {
    const Time arrival = now + h30_frame(0, {}).size() * format.byte_time();
    events_.push_back(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(now), to_ns(arrival), 0});
    return attitudes_[name];
  };
  h30s_[name] =
      std::make_unique<H30>(board_.world(), usart, format, from_ns(maybe<std::uint64_t>(part, "period_ns", 5'000'000)),
                            from_ns(maybe<std::uint64_t>(part, "phase_ns", 0)), feel);
}

void Outfit::add_pca9685(const Json& part, const std::string& name) {
  auto pwm = std::make_unique<Pca9685>(maybe<std::uint8_t>(part, "address", 0x40));
  pwm->on_pulse = [this, name](unsigned channel, std::uint64_t pulse) {
    events_.push_back(PartEvent{name, PartEvent::Kind::output, channel, board_.now_ns(), board_.now_ns(), pulse});
  };
  line_of(part).attach(*pwm);
  pwms_[name] = std::move(pwm);
}

void Outfit::add_part(const Json& part) {
  const auto type = need<std::string>(part, "type"), name = need<std::string>(part, "name");
  if (type == "h30_imu") {
    add_h30(part, name);
  } else if (type == "host_terminal") {
    terminals_[name] = std::make_unique<SerialTerminal>(board_.world(), usart_of(part), format_of(part));
  } else if (type == "tca9548a") {
    muxes_[name] = std::make_unique<Tca9548a>(maybe<std::uint8_t>(part, "address", 0x70));
    line_of(part).attach(*muxes_[name]);
  } else if (type == "pca9685") {
    add_pca9685(part, name);
  } else if (type == "ms5837") {
    const auto variant = maybe<std::string>(part, "variant", "30BA");
    if (variant != "30BA" && variant != "02BA") refuse(part, "'variant' is 30BA or 02BA");
    pressures_[name] = maybe(part, "pressure", kSurfacePascal);
    const auto feel = [this, name](Time now) {
      events_.push_back(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(now), to_ns(now), 0});
      return pressures_[name];
    };
    ms5837s_[name] = std::make_unique<Ms5837>(
        variant == "02BA" ? Ms5837::Variant::k02BA : Ms5837::Variant::k30BA, [this] { return board_.world().now(); },
        feel);
    line_of(part).attach(*ms5837s_[name]);
  } else {
    refuse(part, "no model of a part of type '" + type + "'");
  }
}

/// `PA0` to `PI15`, driven `high` or `low`, or `release`d.
void Outfit::check_pin(const Json& event) {
  const auto pin = need<std::string>(event, "pin"), what = need<std::string>(event, "do");
  const bool digits = pin.size() >= 3 && pin.size() <= 4 && pin.find_first_not_of("0123456789", 2) == std::string::npos;
  if (!digits || pin[0] != 'P' || pin[1] < 'A' || pin[1] > 'I' || std::stoul(pin.substr(2)) > 15)
    refuse(event, "'pin' is a pin of the chip, PA0 to PI15");
  if (what != "high" && what != "low" && what != "release") refuse(event, "'" + what + "' cannot happen to a pin");
}

void Outfit::add_event(const Json& event) {
  const auto at = need<std::uint64_t>(event, "t_ns");
  need<std::string>(event, "do");
  const auto targets = event.contains("part") + event.contains("port") + event.contains("pin");
  if (targets != 1) refuse(event, "an event happens to a 'part', to a 'port' or to a 'pin'");
  if (event.contains("pin")) check_pin(event);
  board_.world().at(from_ns(at), [this, event] { happen(event); });
}

void Outfit::happen(const Json& event) {
  if (event.contains("part")) {
    happen_to_part(event, need<std::string>(event, "part"));
  } else if (event.contains("port")) {
    happen_to_port(event, need<std::string>(event, "port"));
  } else {
    happen_to_pin(event, need<std::string>(event, "pin"));
  }
}

/// A pin is driven from outside, or left alone.
void Outfit::happen_to_pin(const Json& event, const std::string& pin) {
  const int level = need<std::string>(event, "do") == "release" ? -1 : need<std::string>(event, "do") == "high" ? 1 : 0;
  board_.chip().gpio(pin[1]).drive(static_cast<unsigned>(std::stoul(pin.substr(2))), level);
}

void Outfit::happen_to_part(const Json& event, const std::string& name) {
  const auto what = need<std::string>(event, "do");
  if (H30* part = h30(name)) {
    if (what == "silent") return void(part->silent = maybe(event, "on", true));
    if (what == "damage") return void(part->damaged_frames = need<unsigned>(event, "frames"));
    if (what == "move") return change(attitudes_[name], event);
  } else if (Ms5837* sensor = ms5837(name)) {
    if (what == "silent") return void(sensor->dead = maybe(event, "on", true));
    if (what == "damage") return void(sensor->prom_damage = need<std::uint16_t>(event, "bits"));
    if (what == "move") return void(pressures_[name] = need<double>(event, "pressure"));
  } else if (Tca9548a* mux = tca9548a(name)) {
    if (what == "power_cycle") return mux->power_cycle();
  } else if (SerialTerminal* host = terminal(name)) {
    if (what == "send") return host->send(need<std::string>(event, "text"));
  } else {
    refuse(event, "there is no part '" + name + "'");
  }
  refuse(event, "'" + what + "' cannot happen to this part");
}

void Outfit::happen_to_port(const Json& event, const std::string& port) {
  const auto what = need<std::string>(event, "do");
  if (Usart* usart = board_.chip().usart(port)) {
    if (what == "silent") return void(usart->silent = maybe(event, "on", true));
    if (what == "noise") return void(usart->noisy_bytes = need<unsigned>(event, "bytes"));
  } else if (I2c* i2c = board_.chip().i2c(port)) {
    if (what == "nack") return i2c->line.nack(need<std::uint8_t>(event, "address"), need<unsigned>(event, "times"));
    if (what == "hold_sda") return i2c->line.hold_sda(maybe(event, "clocks", I2cLine::kForever));
    if (what == "release_sda") return i2c->line.hold_sda(0);
    if (what == "disturb") return void(i2c->disturbed_starts = need<unsigned>(event, "starts"));
  } else if (Can* can = board_.chip().can(port)) {
    if (what == "disturb") return void(can->line.disturbed_frames = need<unsigned>(event, "frames"));
  } else if (Adc* adc = board_.chip().adc(port)) {
    if (what == "silent") return void(adc->dead = maybe(event, "on", true));
    if (what == "volts") {
      const auto input = need<unsigned>(event, "input");
      if (input > 15) refuse(event, "'input' is 0 to 15");
      return void(adc->volts[input] = need<double>(event, "volts"));
    }
  } else {
    refuse(event, "the board has no bus at port '" + port + "'");
  }
  refuse(event, "'" + what + "' cannot happen to this port");
}

}  // namespace finemote::emulator
