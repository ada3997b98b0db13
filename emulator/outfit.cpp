#include "emulator/outfit.hpp"

#include <algorithm>

namespace finemote::emulator {
namespace {

constexpr std::uint64_t kLookEvery = 1'000'000;  // ns

constexpr std::pair<const char*, MakeElement> kModels[] = {
    {"bmi088", make_bmi088},
    {"dbus_receiver", make_dbus_receiver},
    {"dji_motor", make_dji_motor},
    {"h30_imu", make_h30},
    {"host_terminal", make_host_terminal},
    {"ist8310", make_ist8310},
    {"mecanum_base", make_mecanum_base},
    {"ms5837", make_ms5837},
    {"pca9685", make_pca9685},
    {"pwm_output", make_pwm_output},
    {"register_bank", make_register_bank},
    {"sbus_receiver", make_sbus_receiver},
    {"standing_body", make_standing_body},
    {"submerged_body", make_submerged_body},
    {"tca9548a", make_tca9548a},
    {"thruster", make_thruster},
    {"weights", make_weights},
};

}  // namespace

MakeElement find_model(const std::string& type) {
  for (const auto& [name, make] : kModels) {
    if (type == name) return make;
  }
  return nullptr;
}

void Outfit::add(const Json& document) {
  if (!document.is_object() || maybe<std::string>(document, "schema", "") != "finemote.scenario/1")
    throw std::invalid_argument("a scenario begins with \"schema\": \"finemote.scenario/1\"");
  for (const auto& [key, value] : document.items()) {
    if (key != "schema" && key != "parts" && key != "events" && key != "expect")
      throw std::invalid_argument("a scenario has no member '" + key + "'");
    if (key != "schema" && !value.is_array()) throw std::invalid_argument("'" + key + "' is a list");
  }
  const Json none = Json::array();
  const auto list = [&](const char* key) -> const Json& {
    const auto found = document.find(key);
    return found == document.end() ? none : *found;
  };
  for (const Json& part : list("parts")) add_part(part);
  for (const Json& part : list("parts")) elements_.at(need<std::string>(part, "name"))->connect(*this);
  for (const Json& event : list("events")) add_event(event);
  for (const Json& entry : list("expect")) add_expectation(entry);
}

void Outfit::add_part(const Json& part) {
  const auto type = need<std::string>(part, "type"), name = need<std::string>(part, "name");
  const MakeElement make = find_model(type);
  if (make == nullptr) refuse(part, "no model of a part of type '" + type + "'");
  if (elements_.count(name) != 0) refuse(part, "there is a part of this name already");
  elements_[name] = make(*this, part, name);
}

double Outfit::value(const std::string& part, const std::string& quantity) {
  Element* element = find<Element>(part);
  const auto value = element == nullptr ? std::nullopt : element->value(quantity);
  if (!value) throw std::invalid_argument("part '" + part + "' has no value '" + quantity + "'");
  return *value;
}

SerialTerminal* Outfit::terminal(const std::string& part) {
  auto* element = find<Hearing>(part);
  return element == nullptr ? nullptr : &element->terminal();
}

std::string Outfit::text(const std::string& part) {
  const SerialTerminal* host = terminal(part);
  if (host == nullptr) throw std::invalid_argument("part '" + part + "' hears no text");
  return host->text();
}

Usart& Outfit::usart_of(const Json& part) {
  Usart* usart = board_.chip().usart(need<std::string>(part, "port"));
  if (usart == nullptr) refuse(part, "the board has no such serial port");
  return *usart;
}

/// The bus itself, or one channel of a mux on it.
I2cLine& Outfit::line_of(const Json& part) {
  if (part.contains("mux")) {
    auto* mux = find<LineSource>(need<std::string>(part, "mux"));
    I2cLine* line = mux == nullptr ? nullptr : mux->line(need<unsigned>(part, "channel"));
    if (line == nullptr) refuse(part, "there is no such mux channel");
    return *line;
  }
  I2c* i2c = board_.chip().i2c(need<std::string>(part, "port"));
  if (i2c == nullptr) refuse(part, "the board has no such I2C port");
  return i2c->line;
}

void Outfit::listen_to_pulses(const Json& part, PulseSource::Listener listener) {
  if (part.contains("pwm")) {
    auto* source = find<PulseSource>(need<std::string>(part, "pwm"));
    if (source == nullptr || !source->listen(need<unsigned>(part, "channel"), std::move(listener)))
      refuse(part, "there is no such PWM output");
    return;
  }
  const Header header = header_of(part);
  headers_[header].push_back(std::move(listener));
  header.first->on_pulse = [this, timer = header.first](unsigned which, Timer::Pulse pulse) {
    for (const auto& tell : headers_[{timer, which}]) tell(pulse);
  };
}

void Outfit::listen_to_writes(const Json& part, std::function<void(std::uint64_t)> listener) {
  const Header header = header_of(part);
  writes_[header].push_back(std::move(listener));
  header.first->on_compare = [this, timer = header.first](unsigned which, std::uint64_t width_ns) {
    for (const auto& tell : writes_[{timer, which}]) tell(width_ns);
  };
}

Outfit::Header Outfit::header_of(const Json& part) {
  const auto [timer, channel] = board_.chip().pwm(need<std::string>(part, "port"));
  if (timer == nullptr) refuse(part, "the board has no such PWM header");
  return {timer, channel};
}

bool Outfit::is_pin(const std::string& pin) {
  const bool digits = pin.size() >= 3 && pin.size() <= 4 && pin.find_first_not_of("0123456789", 2) == std::string::npos;
  return digits && pin[0] == 'P' && pin[1] >= 'A' && pin[1] <= 'I' && std::stoul(pin.substr(2)) <= 15;
}

/// `PA0` to `PI15`, driven `high` or `low`, or `release`d.
void Outfit::check_pin(const Json& event) {
  const auto pin = need<std::string>(event, "pin"), what = need<std::string>(event, "do");
  if (!is_pin(pin)) refuse(event, "'pin' is a pin of the chip, PA0 to PI15");
  if (what != "high" && what != "low" && what != "release") refuse(event, "'" + what + "' cannot happen to a pin");
}

void Outfit::add_event(const Json& event) {
  const auto at = need<std::uint64_t>(event, "t_ns");
  const auto what = need<std::string>(event, "do");
  const bool to_part = event.contains("part"), to_pin = event.contains("pin");
  const int targets = to_part + to_pin + event.contains("port");
  if (targets != 1 && !(targets == 0 && what == "reset"))
    refuse(event, "an event happens to a 'part', to a 'port' or to a 'pin'");
  if (to_pin) check_pin(event);
  if (to_part && find<Element>(need<std::string>(event, "part")) == nullptr) refuse(event, "there is no such part");
  const bool stimulus = to_pin || what == "volts" ||
                        (to_part && (what == "move" || what == "send" || what == "disturb" || what == "heat"));
  injects_faults_ = injects_faults_ || !stimulus;
  board_.world().at(from_ns(at), [this, event] { happen(event); });
}

void Outfit::happen(const Json& event) {
  if (event.contains("port")) return happen_to_port(event, need<std::string>(event, "port"));
  if (event.contains("pin")) return happen_to_pin(event, need<std::string>(event, "pin"));
  const auto what = need<std::string>(event, "do");
  if (!event.contains("part")) {
    ++scripted_resets_;
    return board_.press_reset();
  }
  if (!find<Element>(need<std::string>(event, "part"))->happen(what, event))
    refuse(event, "'" + what + "' cannot happen to this part");
}

/// A pin is driven from outside, or left alone.
void Outfit::happen_to_pin(const Json& event, const std::string& pin) {
  const int level = need<std::string>(event, "do") == "release" ? -1 : need<std::string>(event, "do") == "high" ? 1 : 0;
  board_.chip().gpio(pin[1]).drive(static_cast<unsigned>(std::stoul(pin.substr(2))), level);
}

void Outfit::happen_to_port(const Json& event, const std::string& port) {
  const auto what = need<std::string>(event, "do");
  if (Usart* usart = board_.chip().usart(port)) {
    if (what == "silent") return void(usart->silent = maybe(event, "on", true));
    if (what == "noise") return void(usart->noisy_bytes = need<unsigned>(event, "bytes"));
    if (what == "dma_error") return void(board_.chip().break_dma(port));
  } else if (I2c* i2c = board_.chip().i2c(port)) {
    if (what == "nack") return i2c->line.nack(need<std::uint8_t>(event, "address"), need<unsigned>(event, "times"));
    if (what == "hold_sda") return i2c->line.hold_sda(maybe(event, "clocks", I2cLine::kForever));
    if (what == "release_sda") return i2c->line.hold_sda(0);
    if (what == "disturb") return void(i2c->disturbed_starts = need<unsigned>(event, "starts"));
    if (what == "lose") return void(i2c->lost_starts = need<unsigned>(event, "starts"));
  } else if (Can* can = board_.chip().can(port)) {
    if (what == "disturb") return void(can->line.disturbed_frames = need<unsigned>(event, "frames"));
    if (what == "silent") return void(can->line.cut = maybe(event, "on", true));
  } else if (board_.chip().spi(port) != nullptr) {
    if (what == "dma_error") return void(board_.chip().break_dma(port));
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

void Outfit::add_expectation(const Json& entry) {
  Expectation e;
  e.part = need<std::string>(entry, "part");
  e.value = need<std::string>(entry, "value");
  e.from_ns = need<std::uint64_t>(entry, "from_ns");
  e.to_ns = maybe(entry, "to_ns", e.from_ns);
  e.min = need<double>(entry, "min");
  e.max = need<double>(entry, "max");
  if (e.to_ns < e.from_ns || e.max < e.min) refuse(entry, "its end lies before its begin");
  Element* element = find<Element>(e.part);
  if (element == nullptr) refuse(entry, "there is no such part");
  if (!element->value(e.value)) refuse(entry, "the part has no such value");
  e.needed = static_cast<unsigned>((e.to_ns - e.from_ns) / kLookEvery + 1);
  expectations_.push_back(e);
  board_.world().at(from_ns(e.from_ns), [this, index = expectations_.size() - 1] { look(index); });
}

void Outfit::look(std::size_t expectation) {
  Expectation& e = expectations_[expectation];
  const double seen = value(e.part, e.value);
  e.lowest = e.looks == 0 ? seen : std::min(e.lowest, seen);
  e.highest = e.looks == 0 ? seen : std::max(e.highest, seen);
  ++e.looks;
  if (!(seen >= e.min && seen <= e.max) && e.broken_ns == 0) e.broken_ns = board_.now_ns();
  if (e.looks < e.needed)
    board_.world().at(from_ns(e.from_ns + e.looks * kLookEvery), [this, expectation] { look(expectation); });
}

}  // namespace finemote::emulator
