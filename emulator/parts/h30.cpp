#include "emulator/parts/h30.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace finemote::emulator {
namespace {

void put(std::vector<std::uint8_t>& bytes, double value) {
  const auto steps = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 1e6)));
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(steps >> (8 * i)));
}

void record(std::vector<std::uint8_t>& bytes, std::uint8_t type, std::initializer_list<double> values) {
  bytes.push_back(type);
  bytes.push_back(static_cast<std::uint8_t>(4 * values.size()));
  for (const double value : values) put(bytes, value);
}

}  // namespace

std::vector<std::uint8_t> h30_frame(std::uint16_t number, const Attitude& a) {
  std::vector<std::uint8_t> bytes{0x59, 0x53, static_cast<std::uint8_t>(number & 0xFF),
                                  static_cast<std::uint8_t>(number >> 8), 0};
  record(bytes, 0x10, {a.acceleration[0], a.acceleration[1], a.acceleration[2]});
  record(bytes, 0x20, {a.rate[0], a.rate[1], a.rate[2]});
  record(bytes, 0x40, {a.pitch, a.roll, a.yaw});
  const double half = std::numbers::pi / 360;
  const double cp = std::cos(a.pitch * half), sp = std::sin(a.pitch * half), cr = std::cos(a.roll * half),
               sr = std::sin(a.roll * half), cy = std::cos(a.yaw * half), sy = std::sin(a.yaw * half);
  record(bytes, 0x41,
         {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
          cr * cp * sy - sr * sp * cy});
  bytes[4] = static_cast<std::uint8_t>(bytes.size() - 5);
  std::uint8_t sum1 = 0, sum2 = 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) {
    sum1 = static_cast<std::uint8_t>(sum1 + bytes[i]);
    sum2 = static_cast<std::uint8_t>(sum2 + sum1);
  }
  bytes.push_back(sum1);
  bytes.push_back(sum2);
  return bytes;
}

H30::H30(World& world, Usart& usart, const SerialFormat& format, Time period, Time phase,
         std::function<Attitude(Time)> attitude)
    : FrameSender(world, usart, format, period), attitude_(std::move(attitude)) {
  begin(phase);
}

}  // namespace finemote::emulator
