// A wire from an output of a bus to its own input: what is sent comes back.
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// Each byte comes back as the next one is sent.
class SerialJumper : public Element {
 public:
  SerialJumper(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name) {
    Usart& usart = outfit.usart_of(part);
    usart.on_sent = [this, &usart, other = usart.on_sent](WireByte byte) {
      ++bytes_;
      usart.send_in({byte.value}, usart.format());
      if (other) other(byte);
    };
  }
  [[nodiscard]] double bytes() const { return static_cast<double>(bytes_); }

 private:
  std::uint64_t bytes_ = 0;
};

class SpiJumper : public Element {
 public:
  SpiJumper(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name) {
    SpiPart wire;
    wire.exchange = [this](WireByte byte) {
      ++bytes_;
      return byte;
    };
    if (!outfit.board().chip().attach_spi(need<std::string>(part, "port"), need<unsigned>(part, "channel"), wire))
      refuse(part, "the board has no such SPI port or chip select");
  }
  [[nodiscard]] double bytes() const { return static_cast<double>(bytes_); }

 private:
  std::uint64_t bytes_ = 0;
};

}  // namespace

Model serial_jumper() {
  using Row = Rows<SerialJumper>;
  return {
      .type = "serial_jumper",
      .summary = "a wire from TX to RX",
      .figures = {held("has the serial port", required(port("serial")))},
      .values = {Row::value("bytes", "", "so far", [](SerialJumper& part) { return part.bytes(); })},
      .make = Row::make,
  };
}

Model spi_jumper() {
  using Row = Rows<SpiJumper>;
  return {
      .type = "spi_jumper",
      .summary = "a wire from MOSI to MISO",
      .figures = {required(port("spi")),
                  held("has chip select",
                       usually(0, integer("channel", "", "chip select that is used with it", 0, 1)))},
      .values = {Row::value("bytes", "", "so far", [](SpiJumper& part) { return part.bytes(); })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
