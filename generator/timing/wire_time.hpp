// Bytes to time on a bus, and to the interrupts that move them.
#pragma once

#include <string_view>

#include "generator/descriptor/device_type.hpp"
#include "generator/timing/integer.hpp"

namespace finemote::gen::timing {

struct WireRate {
  BusKind kind = BusKind::uart;
  Ns bits_per_s = 1;
  Ns bits_per_byte = 10;  ///< uart, rs485: start, data, parity and stop bits
};

/// Bits of one byte on a serial line of that format (`8N1`: 10).
Ns bits_per_byte(std::string_view format);

/// What one unit on the bus takes.
///
/// I2C (NXP UM10204): start or repeated start, address and every byte with its acknowledge 9 bits, stop and bus-free
/// time 2 bits; service for start, address, each byte and the end. CAN (Bosch CAN 2.0 A, worst stuffing as in Davis et
/// al. 2007): 55 + 10 n bits for a frame of n <= 8 bytes, interframe space included. SPI: 8 bits per byte, full duplex.
struct WireUse {
  Ns wire_ns = 0;
  Ns interrupts = 0;
  Ns min_interval_ns = 0;

  void add(const WireRate& rate, Ns write, Ns read);
};

}  // namespace finemote::gen::timing
