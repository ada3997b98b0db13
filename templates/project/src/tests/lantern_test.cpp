// The lantern on this computer: what it commands for what it sees.
#include "lantern.hpp"

#include "finemote/bench/checks.hpp"

int main() {
  finemote::bench::Checks checks;
  finemote::ButtonState button;
  finemote::LightState shown;
  finemote::LightCommand lamp;
  lantern::Lantern lantern({0.25F}, {button}, {shown, lamp});

  button.valid = true;
  button.origin = 5 * finemote::kMillisecond;
  lantern.update();
  lantern.handle();
  checks.near(lamp.red, 0.25, 1e-6, "nobody presses");
  checks.equal(lamp.origin, button.origin, "the command is as old as the data it comes from");

  button.pressed = true;
  lantern.update();
  lantern.handle();
  checks.near(lamp.red, 1, 1e-6, "somebody presses");

  button.valid = false;
  lantern.handle();
  checks.that(!lamp.valid, "without data there is no command");
  return checks.status();
}
