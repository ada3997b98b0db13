// Names what a board can do on its pins: one class per kind of port, implemented by the linked board.
//
// The classes are declared here and defined by the board (`runtime/boards/<board>/`), without virtual functions:
// exactly one board is linked. A port object holds a reference to a structure only its board knows, so that it is
// constant initialised and the same generated code compiles for every board; the board's own header names it.
//
// Calling contexts. *init*: before the first release, interrupts off or harmless. *bucket*: any update() or handle().
// *fastest bucket*: supervise() alone. *interrupt*: the bus's own interrupt priority, which lies above every bucket;
// the lines of one bus share one priority, so its routines never preempt each other. *any*: all of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/moment.hpp"
#include "finemote/time.hpp"

namespace finemote {

class I2cBus;
class SpiBus;
class CanBus;

struct UartHardware;  // defined by the board
struct I2cHardware;   // defined by the board
struct SpiHardware;   // defined by the board
struct CanHardware;   // defined by the board
struct PwmHardware;   // defined by the board
struct GpioHardware;  // defined by the board
struct EdgeHardware;  // defined by the board
struct AdcHardware;   // defined by the board

// ---------------------------------------------------------------------------------------------------------------- UART

/// Data bits, parity and stop bits on the wire.
enum class UartFormat : std::uint8_t {
  k8N1,          ///< 8 data bits, no parity, 1 stop bit
  k8E1,          ///< 8 data bits, even parity, 1 stop bit
  k8E2,          ///< 8 data bits, even parity, 2 stop bits
  k8E1Inverted,  ///< k8E1 with inverted line levels (DBUS); a board with an on-board inverter ignores the inversion
  k8E2Inverted,  ///< k8E2 with inverted line levels (SBUS)
};

/// Line errors since start; each counter wraps.
struct UartErrors {
  std::uint32_t framing = 0;  ///< bytes without a stop bit
  std::uint32_t noise = 0;    ///< bytes whose samples disagree
  std::uint32_t parity = 0;   ///< bytes with a wrong parity bit
  std::uint32_t overrun = 0;  ///< bytes lost because nothing took the one before
};

/// The receive ring the hardware fills without help, for ever: a power of two of bytes that DMA reaches (FINEMOTE_DMA).
struct UartRing {
  std::uint8_t* bytes = nullptr;  ///< null: none
  std::uint32_t size = 0;         ///< bytes

  constexpr UartRing() = default;
  /// The whole array.
  template <std::size_t count>
  constexpr UartRing(std::uint8_t (&ring)[count]) : bytes(ring), size(count) {  // NOLINT(google-explicit-constructor)
    static_assert((count & (count - 1)) == 0 && count <= 0x8000, "a power of two, at most what a DMA stream counts");
  }
};

/// The last time the line fell silent: how many bytes had arrived by then, and when.
struct UartIdle {
  std::uint32_t received = 0;  ///< bytes since start, modulo 2^32
  Time at = kLongAgo;          ///< not later than the event
};

/// What a line had brought at one instant.
struct UartSeen {
  std::uint32_t received = 0;  ///< bytes since start, modulo 2^32
  UartIdle idle;               ///< the last time it had fallen silent
};

/// A serial port that receives into a ring by DMA and sends one block at a time by DMA.
class UartPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit UartPort(UartHardware& hardware) : hardware_(&hardware) {}

  /// Clocks, pins, baud rate [bit/s], receiving DMA into `ring` and its interrupts; no line events. Context: init.
  void start(std::int64_t baud, UartFormat format, UartRing ring);

  /// From now on lets at most `count` line events (idle, damaged byte) interrupt, whatever was left of the last call.
  /// Those that come when none is left wait: the next call sees an idle line, and one error of each kind. Context:
  /// init, bucket.
  void allow_events(std::uint32_t count);

  /// Gives the line driver a pin: active from transmit() to the last stop bit, inactive otherwise. The pin is an output
  /// already. Context: init.
  void drive_with(std::uint8_t pin, bool active_low);

  /// Bytes received since start, modulo 2^32; byte number n lies in the ring at n % size. Monotonic: the count of
  /// completed laps and the DMA's position are read so that a lap in between is never missed. Context: any.
  [[nodiscard]] std::uint32_t received() const;

  /// The last idle-line event; of one that had to wait, the time is earlier. Context: bucket.
  [[nodiscard]] UartIdle idle() const;
  /// Both of one instant. Context: bucket.
  [[nodiscard]] UartSeen seen() const;

  /// Whether silence behind the first `received` bytes would be an event: they interrupt, and did. Context: bucket.
  [[nodiscard]] bool tells_silence_after(std::uint32_t received) const;

  /// What the line has suffered since start. Context: bucket.
  [[nodiscard]] UartErrors errors() const;

  /// True after a DMA error stopped reception; received() stands still. Context: bucket.
  [[nodiscard]] bool receive_halted() const;
  /// Restarts reception and returns the number of the byte that comes next: a multiple of the ring size that is not
  /// below received(). The last silence is forgotten. Context: bucket.
  std::uint32_t restart_receive();

  /// Where transmit() takes its bytes from; in memory the DMA reaches. Write it only while !transmitting(). Context:
  /// bucket.
  [[nodiscard]] std::uint8_t* transmit_buffer();
  /// Its size, at least 64. Context: any.
  [[nodiscard]] std::size_t transmit_capacity() const;
  /// True from transmit() until the last stop bit has left, or abort_transmit(). Context: bucket.
  [[nodiscard]] bool transmitting() const;
  /// Sends the first `size` bytes of the buffer, 1..transmit_capacity(). On a port with direction control the driver is
  /// on from here to the last stop bit. Context: bucket, while !transmitting().
  void transmit(std::size_t size);
  /// Stops sending at once. Context: bucket.
  void abort_transmit();

 private:
  UartHardware* const hardware_;
};

// ----------------------------------------------------------------------------------------------------------------- I2C

/// One addressed exchange: START, write phase (if any), repeated START, read phase (if any), STOP.
/// With both sizes 0 the address alone is sent. The buffers may lie in any RAM and stay untouched until the exchange
/// has ended; a board whose DMA cannot reach them copies.
struct I2cMessage {
  std::uint8_t address;       ///< 7 bit
  const std::uint8_t* write;  ///< bytes out
  std::uint16_t write_size;   ///< 0: no write phase
  std::uint8_t* read;         ///< room for the bytes in
  std::uint16_t read_size;    ///< 0: no read phase
};

/// How an exchange ended, or that an interrupt brought no end.
enum class I2cEvent : std::uint8_t {
  kNone,   ///< the interrupt was pended by software, or the exchange goes on
  kDone,   ///< all bytes moved, STOP sent
  kNack,   ///< address or data byte not acknowledged, STOP sent
  kError,  ///< bus error, arbitration lost or DMA error: the bus needs recovery
};

/// An I2C master that carries out one exchange at a time.
class I2cPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit I2cPort(I2cHardware& hardware) : hardware_(&hardware) {}

  /// Clocks, pins and bus clock [Hz], interrupts. From here on every interrupt of the port ends in
  /// `bus.on_interrupt(event)`, exactly once per interrupt. Context: init.
  void configure(std::int64_t clock_hz, I2cBus& bus);

  /// Makes the bus's interrupt run `bus.on_interrupt(I2cEvent::kNone)` soon (sets its line pending in the NVIC, PM0214
  /// 4.3.4). Never blocks. Context: any.
  void pend();

  /// SCL and SDA are high: no part holds the bus. Context: init, behind configure().
  [[nodiscard]] bool lines_free() const;

  /// Whether the exchange has gone no step on for longer than one can take on the wire. Context: bucket.
  [[nodiscard]] bool stands_still() const;

  /// Begins an exchange and returns; its end arrives as an event in a later interrupt, never from inside this call.
  /// Only called while no exchange is under way. `message` is copied; a board that must wait for the STOP of the
  /// exchange before has at most two bit times for it, and begins nothing where it does not come. Context: interrupt.
  void begin(const I2cMessage& message);

  /// Ends the exchange at once without waiting, peripheral and DMA off; no event follows it. Context: interrupt.
  void abort();

  /// What a step of recovery has reached.
  enum class Recovery : std::uint8_t {
    kBusy,   ///< call again with the next step
    kFree,   ///< SDA and SCL are high, the peripheral is ready for begin()
    kStuck,  ///< a line is still held low; the peripheral is off
  };
  static constexpr unsigned kMaxRecoverySteps = 6;  ///< after which recovery is over

  /// One bounded step of bus recovery: clocks SCL by hand until SDA is released (nine clocks in all at most, I2C-bus
  /// specification UM10204 3.1.16), sends a STOP, and sets the peripheral up again as configure() did. `step` counts 0,
  /// 1, 2, ... within one recovery. Takes at most 40 us each, and is over after at most kMaxRecoverySteps steps.
  /// Context: fastest bucket, between abort() and the next begin(); init, before the first.
  [[nodiscard]] Recovery recover(unsigned step);

 private:
  I2cHardware* const hardware_;
};

// ----------------------------------------------------------------------------------------------------------------- SPI

/// One exchange with a chip select: `size` bytes out and in at the same time. `write` null sends 0xFF, `read` null
/// drops what comes back. Buffers as in I2cMessage.
struct SpiMessage {
  std::uint8_t select;        ///< chip select, in the order of the board file
  std::uint8_t mode;          ///< 0..3: CPOL * 2 + CPHA
  const std::uint8_t* write;  ///< bytes out, or null
  std::uint8_t* read;         ///< room for the bytes in, or null
  std::uint16_t size;         ///< >= 1
};

/// How an exchange ended, or that an interrupt brought no end.
enum class SpiEvent : std::uint8_t {
  kNone,   ///< pended by software, or the exchange goes on
  kDone,   ///< all bytes moved, chip select high again
  kError,  ///< overrun or DMA error, chip select high again
};

/// An SPI master with its chip selects.
class SpiPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit SpiPort(SpiHardware& hardware) : hardware_(&hardware) {}

  /// As I2cPort::configure(); takes the highest clock not above `clock_hz`. Context: init.
  void configure(std::int64_t clock_hz, SpiBus& bus);
  /// As I2cPort::pend(). Context: any.
  void pend();
  /// Of the last exchange, the bytes that its interrupts have moved; 0 where the DMA does. Context: bucket.
  [[nodiscard]] std::uint16_t moved() const;
  /// As I2cPort::begin(). Context: interrupt.
  void begin(const SpiMessage& message);
  /// As I2cPort::abort(); every chip select is high afterwards. Context: interrupt.
  void abort();

 private:
  SpiHardware* const hardware_;
};

// ----------------------------------------------------------------------------------------------------------------- CAN

/// A classic CAN data frame with a standard identifier.
struct CanFrame {
  std::uint16_t id = 0;                           ///< 11 bit
  std::uint8_t size = 0;                          ///< 0..8
  alignas(std::uint32_t) std::uint8_t data[8]{};  ///< the first `size` count
};

/// Identifiers that are accepted: none, one, or a block of a power of two that begins at a multiple of its size.
struct CanIds {
  std::uint16_t first = 0;  ///< 11 bit
  std::uint16_t count = 0;  ///< 0: none

  constexpr CanIds() = default;
  constexpr CanIds(std::uint16_t one) : first(one), count(1) {}                             ///< one identifier
  constexpr CanIds(std::uint16_t begin, std::uint16_t size) : first(begin), count(size) {}  ///< a block
  /// Whether `id` is among them.
  [[nodiscard]] constexpr bool hold(std::uint16_t id) const { return static_cast<std::uint16_t>(id - first) < count; }
};

/// A CAN controller that filters by identifier.
class CanPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit CanPort(CanHardware& hardware) : hardware_(&hardware) {}

  /// Clocks, pins, bit timing for `bitrate` [bit/s], acceptance of exactly what `bus.each_ids()` lists (a superset
  /// where the hardware has too few filters), interrupts for reception, sending and errors. They hand each received
  /// frame to `bus.on_frame(frame, moment)`, and call `bus.on_interrupt()` after a pend() and when a mailbox falls free
  /// after tell_when_sent(). Context: init.
  void configure(std::int64_t bitrate, CanBus& bus);
  /// As I2cPort::pend(). Context: any.
  void pend();
  /// Puts a frame into a free mailbox; the mailboxes are sent by identifier. False: none is free. Context: interrupt.
  [[nodiscard]] bool send(const CanFrame& frame);
  static constexpr unsigned kMailboxes = 3;  ///< frames that wait in the controller at most
  /// Asks for `bus.on_interrupt()` when the next frame has gone, or at once where one has since the routine began. To
  /// be called where no mailbox was free in this routine. Context: interrupt.
  void tell_when_sent();
  /// Frames in mailboxes that have not gone. Context: interrupt.
  [[nodiscard]] unsigned unsent() const;
  /// True where no other node has sent anything for eleven bits of `bitrate` [bit/s]: then none has anything to send.
  /// Waits for as long at most. Context: init.
  [[nodiscard]] bool idle(std::int64_t bitrate) const;
  /// Empties the mailboxes. Context: interrupt.
  void abort();
  /// True while the controller is off the bus. Context: any.
  [[nodiscard]] bool bus_off() const;
  /// Starts the return to the bus (128 x 11 recessive bits, ISO 11898-1); bus_off() tells when it is done. False: the
  /// controller is not ready for it yet, and is asked again later; 10 ms at most. Never waits. Context: fastest bucket.
  [[nodiscard]] bool recover();
  /// Transmit and receive error counters, low and high byte. Context: any.
  [[nodiscard]] std::uint16_t error_counters() const;

 private:
  CanHardware* const hardware_;
};

// ---------------------------------------------------------------------------------------------------------- PWM, pins

inline constexpr std::uint32_t kShortestPwmPeriod = 1'000;       ///< ns: pulses cannot repeat more often
inline constexpr std::uint32_t kLongestPwmPeriod = 400'000'000;  ///< ns: nor more rarely

/// One timer channel that repeats a pulse.
class PwmPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit PwmPort(PwmHardware& hardware) : hardware_(&hardware) {}

  /// Clock, pin and repetition period [ns], in range and one for all outputs of a timer (Module::pwm); the output stays
  /// low until the first write(). Context: init.
  void start(Duration period);
  /// Pulse width [ns] from the next repetition on; 0 keeps the output low. Context: bucket.
  void write(std::uint32_t pulse);
  /// Another repetition period [ns], from the next repetition on; the pulse keeps its counts until the next write().
  /// False, and nothing changes, where another output of the same timer runs, or the period is out of range.
  /// Context: bucket.
  [[nodiscard]] bool tune(std::uint32_t period);

 private:
  PwmHardware* const hardware_;
};

/// What a pin is made into.
enum class PinSetting : std::uint8_t {
  kInput,          ///< nothing pulls it
  kInputPullUp,    ///< high when nobody drives it
  kInputPullDown,  ///< low when nobody drives it
  kOutputLow,      ///< push-pull, low from the first moment
  kOutputHigh,     ///< push-pull, high from the first moment
  kAnalog,         ///< for a converter: no digital input
};

/// The number of a chip pin: `pin_number('C', 4)` is PC4.
constexpr std::uint8_t pin_number(char port, unsigned pin) {
  return static_cast<std::uint8_t>(16 * static_cast<unsigned>(port - 'A') + pin);
}

/// The chip's single pins, by pin_number().
class GpioPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit GpioPort(GpioHardware& hardware) : hardware_(&hardware) {}

  /// Clock, direction, pull and idle level of one pin. Context: init.
  void configure(std::uint8_t pin, PinSetting setting);
  /// Sets an output pin. Context: any.
  void write(std::uint8_t pin, bool high);
  /// Level of a pin. Context: any.
  [[nodiscard]] bool read(std::uint8_t pin) const;

 private:
  GpioHardware* const hardware_;
};

/// The last edge of a line that interrupts.
struct Edge {
  std::uint32_t count = 0;  ///< edges so far, modulo 2^32; 0: none yet
  Time at = kLongAgo;       ///< not later than the last one
};

/// One pin whose edges are counted and timed by an interrupt of its own.
class EdgePort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit EdgePort(EdgeHardware& hardware) : hardware_(&hardware) {}

  /// Clock, input with a pull against the edge, interrupt on the falling or the rising edge. Context: init.
  void start(bool falling);
  /// Both members of one edge. Context: bucket.
  [[nodiscard]] Edge last() const;

 private:
  EdgeHardware* const hardware_;
};

/// A 12-bit converter that measures one input at a time.
class AdcPort {
 public:
  /// The port of this hardware, which outlives it.
  constexpr explicit AdcPort(AdcHardware& hardware) : hardware_(&hardware) {}

  static constexpr std::uint16_t kFullScale = 4095;  ///< the highest code

  /// Clock, and the pin of this input as analog. Context: init.
  void start(std::uint8_t input, std::uint8_t pin);
  /// Begins a conversion, unless one is under way; its end is asked for with take(). Never waits. Context: bucket.
  void begin(std::uint8_t input);
  /// The finished conversion of this input, once: 0..kFullScale. False: none, or of another input. Context: bucket.
  [[nodiscard]] bool take(std::uint8_t input, std::uint16_t& value);

 private:
  AdcHardware* const hardware_;
};

}  // namespace finemote

#include "finemote/port_names.hpp"
