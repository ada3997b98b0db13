// Names of the ports that the bench kit uses, and of its jumpers.
#pragma once

namespace finemote::gen::bench_ports {

inline constexpr const char* kReport = "usart6";                          ///< where the record leaves the board
inline constexpr const char *kImu = "spi1", *kCompass = "i2c3";           ///< with the parts that are soldered to them
inline constexpr const char *kSerialLoop = "usart1", *kSpiLoop = "spi2";  ///< that a jumper closes,
inline constexpr const char *kSerialJumper = "J1", *kSpiJumper = "J2";    ///< which has this name

/// What their tests need, for people.
inline constexpr const char *kNeedsSerialJumper = "jumper J1", *kNeedsSpiJumper = "jumper J2";

}  // namespace finemote::gen::bench_ports
