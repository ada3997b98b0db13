#pragma once
#include <finemote/contract.hpp>
#include <finemote/i2c.hpp>

struct LightSensor {
  struct Config {
    int gain;
  };
  finemote::Stamp state;
  void update() {}
  void handle() {}
};
