// Users' types for structural mutations: every kind of param, use, role and geometry, with and without a constructor
// that runs at compile time.
#pragma once

#include <finemote/analog.hpp>
#include <finemote/contract.hpp>
#include <finemote/geometry.hpp>
#include <finemote/gpio.hpp>
#include <finemote/interfaces.hpp>
#include <finemote/uart.hpp>

namespace probes {

struct HeatState : finemote::Stamp {
  float degrees = 0;
};
struct HeatCommand : finemote::Stamp {
  float power = 0;
};
struct Heat {
  using State = HeatState;
  using Command = HeatCommand;
};
struct Warmth {
  using State = HeatState;
  using Command = void;
};

enum class Mode { kQuick, kSlow };

/// Provides two interfaces by members of other names than usual.
class Probe {
 public:
  struct Config {
    Mode mode = Mode::kQuick;
    const char* label = "";
    std::int64_t rate = 0, bits = 0, speed = 0;
    bool invert = false;
    std::int32_t count = 0;
    float gain = 0, share = 0;
    finemote::Duration hold = 0;
    int more = 3;  ///< no param
  };
  constexpr Probe(const Config& config, finemote::Uart* debug, finemote::GpioPin* button, finemote::EdgePin* line,
                  finemote::AnalogPin* sense, finemote::Ports<finemote::Any> parts, finemote::Ports<Warmth> warm)
      : config_(config), debug_(debug), button_(button), line_(line), sense_(sense), parts_(parts), warm_(warm) {}
  void update() {}
  void handle() {}
  void safe() {}

  HeatState heat, warmth;
  HeatCommand power;

 private:
  Config config_;
  finemote::Uart* debug_;
  finemote::GpioPin* button_;
  finemote::EdgePin* line_;
  finemote::AnalogPin* sense_;
  finemote::Ports<finemote::Any> parts_;
  finemote::Ports<Warmth> warm_;
};

/// Its constructor runs before main.
class Late {
 public:
  struct Config {
    finemote::Duration hold = 0;
  };
  Late(const Config& config, finemote::Ports<Heat> heats, finemote::Ports<finemote::Any> parts);
  void update() {}
  void handle() {}

  HeatState state;
  HeatCommand command;
};

/// All geometry there is.
class Frame {
 public:
  constexpr Frame(const float (*)[6], const finemote::Vector*, const finemote::ChainLink*, const finemote::Rotation*,
                  finemote::Ports<finemote::Any>) {}
  void update() {}
  void handle() {}

  finemote::Stamp state;
};

}  // namespace probes
