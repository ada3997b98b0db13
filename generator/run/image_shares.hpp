// A linked image to what of it belongs to whom, as far as symbols say so.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/image.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Bytes of an image that belong to one owner.
struct ImageShare {
  enum class Kind {
    device,     ///< its object and its slot on a bus
    bus,        ///< its object
    type,       ///< code and constants of a device type's class, which all devices of the type share
    generated,  ///< stages, ports and constants of the robot beside those
    rest,       ///< runtime, board, libraries, and what has no symbol
  };
  Kind kind = Kind::rest;
  std::string name = {};  ///< of the device, the bus or the type
  std::uint32_t flash = 0, ram = 0;
};

/// `device`, `bus`, `type`, `generated`, `rest`.
const char* share_name(ImageShare::Kind kind);

/// All bytes that measure_image() counts as flash and RAM, each once: devices in document order, buses, types,
/// generated, rest.
std::vector<ImageShare> image_shares(const Image& image, const Robot& robot);

}  // namespace finemote::gen
