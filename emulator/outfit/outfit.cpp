#include "emulator/outfit/outfit.hpp"

#include <algorithm>
#include <cmath>

#include "emulator/scenario/read.hpp"
#include "generator/diagnostic/render.hpp"

namespace finemote::emulator {
namespace {

constexpr std::uint64_t kLookEvery = 1'000'000;  // ns

/// What is usual for every absent figure, also in lists.
void complete(Json& entry, const std::vector<scenario::Member>& rows) {
  for (const scenario::Member& row : rows) {
    if (!row.usual.empty() && !entry.contains(row.name)) entry[row.name] = Json::parse(row.usual);
    if (row.kind != scenario::Member::Kind::list || !entry.contains(row.name)) continue;
    for (Json& item : entry[row.name]) complete(item, row.members);
  }
}

/// @throws std::invalid_argument with every mistake
void check(const Json& document, std::vector<scenario::World::Part> parts) {
  scenario::World world;
  world.judges_wiring = false;  // the robot's model placed them, or the scenario was judged where it was read
  world.parts = std::move(parts);
  gen::Diagnostics diagnostics;
  const gen::SourceFile text{"scenario", "", document.dump(2)};
  if (!scenario::read(text, world, diagnostics)) throw std::invalid_argument(gen::render_text(diagnostics, false));
}

}  // namespace

void Outfit::add(const Json& document, std::int64_t zero_ns) {
  std::vector<scenario::World::Part> known;
  for (const auto& [name, part] : parts_) known.push_back({name, part.model->type});
  check(document, std::move(known));
  const auto list = [&](const char* key) { return document.value(key, Json::array()); };
  for (const Json& part : list("parts")) add_part(part);
  for (const Json& part : list("parts")) parts_.at(need<std::string>(part, "name")).element->connect();
  for (const Json& event : list("events")) add_event(event, zero_ns);
  for (const Json& entry : list("expect")) add_expectation(entry, zero_ns);
}

void Outfit::add_part(const Json& part) {
  const auto name = need<std::string>(part, "name");
  const scenario::Model* model = scenario::find_model(need<std::string>(part, "type"));
  Json entry = part;
  complete(entry, model->figures);
  parts_[name] = {model, model->make(*this, entry, name)};
  names_.push_back(name);
}

double Outfit::value(const std::string& part, const std::string& quantity) {
  const auto found = parts_.find(part);
  const scenario::Quantity* row =
      found == parts_.end() ? nullptr : scenario::find_quantity(found->second.model->values, quantity);
  if (row == nullptr) throw std::invalid_argument("part '" + part + "' has no value '" + quantity + "'");
  return row->look(*found->second.element, scenario::number_in_family(quantity, row->name));
}

std::vector<std::string> Outfit::names() const { return names_; }

std::vector<PartValue> Outfit::values(const std::string& part) {
  std::vector<PartValue> all;
  for (const scenario::Quantity& row : parts_.at(part).model->values) {
    for (const std::string& name : scenario::names_of(row.name, row.last))
      all.push_back({name, row.unit, value(part, name), row.last >= 0});
  }
  return all;
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

CanLine& Outfit::can_of(const Json& part) {
  Can* can = board_.chip().can(need<std::string>(part, "port"));
  if (can == nullptr) refuse(part, "the board has no such CAN port");
  return can->line;
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

void Outfit::listen_to_drive(const Json& part, DrivenPin::Listener listener) {
  if (part.contains("pwm"))
    return listen_to_pulses(part, [tell = std::move(listener)](Timer::Pulse pulse) { tell(drive_of(pulse)); });
  std::unique_ptr<DrivenPin>& pin = pins_[header_of(part)];
  if (pin == nullptr) {
    const PinPlace place = board_.chip().pulse_pin(need<std::string>(part, "port"));
    pin = std::make_unique<DrivenPin>(board_.chip().gpio(place.port), place.number);
    listen_to_pulses(part, [driven = pin.get()](Timer::Pulse pulse) { driven->set_pulse(pulse); });
  }
  pin->listen(std::move(listener));
}

void Outfit::listen_to_writes(const Json& part, WriteListener listener) {
  const Header header = header_of(part);
  writes_[header].push_back(std::move(listener));
  header.first->on_compare = [this, timer = header.first](unsigned which, std::uint64_t width_ns, Tag origin) {
    for (const auto& tell : writes_[{timer, which}]) tell(width_ns, origin);
  };
}

Outfit::Header Outfit::header_of(const Json& part) {
  const auto [timer, channel] = board_.chip().pwm(need<std::string>(part, "port"));
  if (timer == nullptr) refuse(part, "the board has no such PWM header");
  return {timer, channel};
}

const scenario::Verb& Outfit::verb_of(const Json& event) const {
  const auto& verbs = event.contains("part")   ? parts_.at(need<std::string>(event, "part")).model->verbs
                      : event.contains("port") ? scenario::kind_of_port(need<std::string>(event, "port"))->verbs
                      : event.contains("pin")  ? scenario::pin_verbs()
                                               : scenario::board_verbs();
  return *scenario::find_verb(verbs, need<std::string>(event, "do"));
}

void Outfit::add_event(const Json& event, std::int64_t zero_ns) {
  const scenario::Verb& verb = verb_of(event);
  const bool ends_one = !is_on(event);
  const Violation violation{verb.violates, event.value("part", ""), event.value("port", "")};
  const bool is_known = std::find(violated_.begin(), violated_.end(), violation) != violated_.end();
  const auto t_ns = zero_ns + need<std::int64_t>(event, "t_ns");
  if (!verb.violates.empty() && !ends_one) {
    if (!is_known) violated_.push_back(violation);
    violated_from_ns_ = std::min(t_ns, violated_from_ns_.value_or(t_ns));
  }
  board_.world().at(from_ns(static_cast<std::uint64_t>(t_ns)), [this, &verb, event] { verb.act(*this, event); });
}

Tag Outfit::sample(const std::string& part, unsigned channel, Time from, Time readable) {
  Provenance& provenance = board_.world().provenance();
  const auto [found, is_new] = sources_.try_emplace({part, channel}, 0);
  if (is_new) {
    found->second = provenance.add_source();
    channels_.push_back(found->first);
  }
  return provenance.sample(found->second, from, readable);
}

std::vector<SampleUse> Outfit::uses() const {
  const Provenance& provenance = board_.world().provenance();
  std::vector<SampleUse> all;
  for (const Use& use : provenance.uses()) {
    const Origin& sample = provenance.origin(use.sample);
    const auto& [part, channel] = channels_.at(sample.source);
    all.push_back({use.at, use.stage, part, channel, sample.n, use.claimed});
  }
  return all;
}

void Outfit::press_reset() {
  ++scripted_resets_;
  if (on_reset) on_reset();
  board_.press_reset();
}

void Outfit::add_expectation(const Json& entry, std::int64_t zero_ns) {
  Expectation e;
  e.zero_ns = zero_ns;
  e.part = need<std::string>(entry, "part");
  e.value = need<std::string>(entry, "value");
  e.from_ns = need<std::uint64_t>(entry, "from_ns");
  e.to_ns = maybe(entry, "to_ns", e.from_ns);
  e.min = need<double>(entry, "min");
  e.max = need<double>(entry, "max");
  e.needed = (e.to_ns - e.from_ns) / kLookEvery + 1;
  expectations_.push_back(e);
  plan_look(expectations_.size() - 1);
}

void Outfit::plan_look(std::size_t expectation) {
  const Expectation& e = expectations_[expectation];
  const std::uint64_t t_ns = static_cast<std::uint64_t>(e.zero_ns) + e.from_ns + e.looks * kLookEvery;
  board_.world().at(from_ns(t_ns), [this, expectation] { look(expectation); });
}

void Outfit::look(std::size_t expectation) {
  Expectation& e = expectations_[expectation];
  const double seen = value(e.part, e.value);
  if (std::isfinite(seen)) {
    e.lowest = e.has_seen() ? std::min(e.lowest, seen) : seen;
    e.highest = e.has_seen() ? std::max(e.highest, seen) : seen;
  } else {
    ++e.not_finite;
  }
  ++e.looks;
  if (!(seen >= e.min && seen <= e.max) && e.broken_ns == 0) e.broken_ns = board_.now_ns();
  if (e.looks < e.needed) plan_look(expectation);
}

}  // namespace finemote::emulator
