// The classes of ports that runtime/include/finemote/ports.hpp has.
#pragma once

namespace finemote::gen {

/// `edge` is a pin that interrupts, `adc` a converter: no bus sits on these.
enum class PortClass { uart, can, i2c, spi, pwm, edge, adc };

}  // namespace finemote::gen
