// Parts on I2C buses.
#include "emulator/outfit/bodies.hpp"
#include "emulator/parts/ist8310.hpp"
#include "emulator/parts/ms5837.hpp"
#include "emulator/parts/pca9685.hpp"
#include "emulator/parts/register_bank.hpp"
#include "emulator/parts/tca9548a.hpp"

namespace finemote::emulator {
namespace {

constexpr double kSurfacePascal = 101'325, kWaterDensity = 1000;

class MuxElement : public Element, public LineSource {
 public:
  MuxElement(Outfit& outfit, const Json& part) : model_(maybe<std::uint8_t>(part, "address", 0x70)) {
    outfit.line_of(part).attach(model_);
    on("power_cycle", [this](const Json&) { model_.power_cycle(); });
    show("control", [this] { return model_.control(); });
  }
  I2cLine* line(unsigned channel) override { return channel < 8 ? &model_.channel(channel) : nullptr; }

 private:
  Tca9548a model_;
};

class PwmElement : public Element, public PulseSource {
 public:
  PwmElement(Outfit& outfit, const Json& part, const std::string& name)
      : model_(maybe<std::uint8_t>(part, "address", 0x40)) {
    model_.on_pulse = [this, &outfit, name](unsigned channel, std::uint64_t pulse) {
      const std::uint64_t now = outfit.board().now_ns();
      outfit.record(PartEvent{name, PartEvent::Kind::output, channel, now, now, static_cast<double>(pulse)});
      for (const Listener& tell : listeners_[channel]) tell({pulse, model_.period_ns()});
    };
    model_.on_write = [this](unsigned channel, std::uint64_t pulse) {
      if (notes_[channel] < 0) notes_[channel] = static_cast<double>(pulse) / 1000;
    };
    outfit.line_of(part).attach(model_);
    on("power_cycle", [this](const Json&) { model_.power_cycle(); });
    on("note", [this](const Json&) { notes_.fill(-1); });
    show("bursts", [this] { return model_.bursts(); });
    for (unsigned i = 0; i < notes_.size(); ++i) {
      show("noted_" + std::to_string(i), [this, i] { return notes_[i]; });
      show("pulse_" + std::to_string(i), [this, i] { return static_cast<double>(model_.pulse_ns(i)) / 1000; });
    }
  }
  bool listen(unsigned channel, Listener listener) override {
    if (channel >= listeners_.size()) return false;
    listeners_[channel].push_back(std::move(listener));
    return true;
  }

 private:
  Pca9685 model_;
  std::array<std::vector<Listener>, 16> listeners_;
  std::array<double, 16> notes_{};
};

class PressureElement : public Element {
 public:
  PressureElement(Outfit& outfit, const Json& part, const std::string& name)
      : outfit_(outfit),
        seat_(part),
        follows_(part.contains("body")),
        pressure_(maybe(part, "pressure", kSurfacePascal)),
        model_(
            variant_of(part), [&outfit] { return outfit.now(); }, [this, name](Time now) { return feel(now, name); }) {
    outfit.line_of(part).attach(model_);
    on("silent", [this](const Json& event) { model_.dead = maybe(event, "on", true); });
    on("damage", [this](const Json& event) { model_.prom_damage = need<std::uint16_t>(event, "bits"); });
    on("move", [this](const Json& event) {
      pressure_ = need<double>(event, "pressure");
      follows_ = false;
    });
    show("pressure", [this] { return pressure(outfit_.now()); });
    show("conversions", [this] { return model_.conversions(); });
  }
  void connect(Outfit& outfit) override { seat_.connect(outfit); }

 private:
  static Ms5837::Variant variant_of(const Json& part) {
    return maybe<std::string>(part, "variant", "30BA") == "02BA" ? Ms5837::Variant::k02BA : Ms5837::Variant::k30BA;
  }
  double pressure(Time now) {
    if (!follows_) return pressure_;
    const double depth = -seat_.motion(now).position.z();
    return kSurfacePascal + (depth > 0 ? depth * kWaterDensity * kGravity : 0);
  }
  double feel(Time now, const std::string& name) {
    outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(now), to_ns(now), 0});
    return pressure(now);
  }

  Outfit& outfit_;
  Seat seat_;
  bool follows_;
  double pressure_;
  Ms5837 model_;
};

class CompassElement : public Element {
 public:
  CompassElement(Outfit& outfit, const Json& part, const std::string& name)
      : outfit_(outfit),
        seat_(part),
        field_(vector(part, "field", {20e-6, 0, -45e-6})),
        model_(
            maybe<std::uint8_t>(part, "address", 0x0E), [&outfit] { return outfit.now(); },
            [this](Time now) { return Eigen::Vector3d(seat_.motion(now).attitude.conjugate() * field_); }) {
    model_.on_read = [this, name](Time from) {
      outfit_.record(PartEvent{name, PartEvent::Kind::sample, 0, to_ns(from), outfit_.board().now_ns(), 0});
    };
    outfit.line_of(part).attach(model_);
    on("silent", [this](const Json& event) { model_.dead = maybe(event, "on", true); });
    on("power_cycle", [this](const Json&) { model_.power_cycle(); });
    on("move", [this](const Json& event) {
      field_ = vector(event, "field", field_);
      seat_.move(outfit_.now(), event);
    });
    if (maybe<std::string>(part, "port", "") == "i2c3") {  // the part on the board has its reset at PG6
      outfit.board().chip().gpio('G').watcher[6] = [this](bool output, bool high) {
        model_.hold_reset(output && !high);
      };
    }
  }
  void connect(Outfit& outfit) override { seat_.connect(outfit); }

 private:
  Outfit& outfit_;
  Seat seat_;
  Eigen::Vector3d field_;  ///< in the world's axes [T]
  Ist8310 model_;
};

/// `r0`..`r255`: what the part is described by and asked for.
class RegisterElement : public Element {
 public:
  RegisterElement(Outfit& outfit, const Json& part) : model_(need<std::uint8_t>(part, "address")) {
    set(part);
    outfit.line_of(part).attach(model_);
    on("set", [this](const Json& event) { set(event); });
    for (unsigned i = 0; i < model_.bytes.size(); ++i) show(name_of(i), [this, i] { return model_.bytes[i]; });
  }

 private:
  static std::string name_of(unsigned number) { return "r" + std::to_string(number); }
  void set(const Json& entry) {
    for (unsigned i = 0; i < model_.bytes.size(); ++i)
      model_.bytes[i] = maybe(entry, name_of(i).c_str(), model_.bytes[i]);
  }

  RegisterBank model_;
};

}  // namespace

std::unique_ptr<Element> make_register_bank(Outfit& outfit, const Json& part, const std::string&) {
  return std::make_unique<RegisterElement>(outfit, part);
}
std::unique_ptr<Element> make_tca9548a(Outfit& outfit, const Json& part, const std::string&) {
  return std::make_unique<MuxElement>(outfit, part);
}
std::unique_ptr<Element> make_pca9685(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<PwmElement>(outfit, part, name);
}
std::unique_ptr<Element> make_ms5837(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<PressureElement>(outfit, part, name);
}
std::unique_ptr<Element> make_ist8310(Outfit& outfit, const Json& part, const std::string& name) {
  return std::make_unique<CompassElement>(outfit, part, name);
}

}  // namespace finemote::emulator
