// Turns the operator's text commands into values the vehicle acts on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/uart.hpp"

namespace finemote {

/// One command of the FinsROV host program. Commands are ASCII without a terminator; the silence of the line ends a
/// message, which may hold several.
struct FinsRovOrder {
  enum class Verb : std::uint8_t {
    kOn,          ///< `ON`: hold depth and attitude
    kOff,         ///< `OFF`: thrusters to neutral
    kUp,          ///< `UP`: 1 cm less deep
    kDown,        ///< `DN`: 1 cm deeper
    kDepth,       ///< `H:n`: depth of n mm
    kForward,     ///< `W`
    kBack,        ///< `S`
    kLeft,        ///< `A`
    kRight,       ///< `D`
    kTurnLeft,    ///< `Q`
    kTurnRight,   ///< `E`
    kStop,        ///< `Z`: no horizontal motion
    kHeadingOn,   ///< `ACL:ON`
    kHeadingOff,  ///< `ACL:OF`
    kHeading,     ///< `ANG:deg`
    kReportOn,    ///< `RPY:ON`: send attitude and depth, ten times a second
    kReportOff,   ///< `RPY:OFF`
    kTest,        ///< `TES:p0,...,p7`: pulses [us], only while off
    kServos,      ///< `MOT:a,b,c,d`: accepted; the vehicle's servos are devices of their own
    kCalibrate,   ///< `CA`: take the present pressure as that of the surface
    kValues,      ///< `VA`: send the four pressures once
    kNothing,     ///< `BEG`, `END`, `IVA`: marks of the host program without effect
  };
  Verb verb = Verb::kNothing;
  std::int16_t value[8] = {};
};

/// Collects a message and takes it apart. A message counts whole or not at all: text that is no command, a number that
/// is out of int16 or has more than seven digits, more than kMaxMessage bytes or a line error (parity, framing, noise)
/// drop all of it. A long message is taken apart over several calls; while that lasts or its orders are obeyed, the
/// next one waits in the ring of the line.
class FinsRovHost {
 public:
  static constexpr std::size_t kMaxMessage = 100;
  /// Orders that one update() should obey.
  static constexpr unsigned kMostOrders = 8;
  /// Words, numbers and spaces that one receive() takes.
  static constexpr unsigned kMostPieces = 32;

  /// Takes what has arrived. True while orders of a good message are left: next() then gives them.
  bool receive(Uart& uart);
  /// The next order of that message; false after the last one.
  bool next(FinsRovOrder& order);

  /// When that message began to come.
  [[nodiscard]] Time origin() const { return origin_; }

  [[nodiscard]] std::uint32_t bad_messages() const { return bad_messages_; }

 private:
  enum class Stage : std::uint8_t { kCollecting, kTakingApart, kObeying };
  static constexpr std::size_t kMostNumbers = sizeof FinsRovOrder::value / sizeof FinsRovOrder::value[0];

  void begin_message();
  void collect(Uart& uart);
  void append(const std::uint8_t* bytes, std::size_t count);
  void drop();
  void take_apart();
  bool take_piece();
  bool take_word();
  bool take_number();
  void keep(std::int32_t number);

  /// The text, and from the begin on what it says: the number of each word and the word's numbers, two bytes each,
  /// which never takes more bytes than the text did. Whole words are read behind the end, so there is room for one.
  std::uint8_t text_[kMaxMessage + 8]{};
  std::uint8_t size_ = 0;
  std::uint8_t at_ = 0;       ///< of what is taken apart or obeyed
  std::uint8_t kept_ = 0;     ///< bytes of what is taken apart
  std::uint8_t numbers_ = 0;  ///< that have to follow
  Stage stage_ = Stage::kCollecting;
  bool too_long_ = false;
  Time origin_ = kLongAgo;
  std::uint32_t line_errors_ = 0;
  std::uint32_t bad_messages_ = 0;
};

}  // namespace finemote
