// The remote end of a text serial line.
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/serial_line.hpp"
#include "emulator/parts/serial_terminal.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class TerminalElement : public Element, public Hearing {
 public:
  TerminalElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), model_(outfit.board().world(), outfit.usart_of(part), format_of(part)) {}
  SerialTerminal& terminal() override { return model_; }

 private:
  SerialTerminal model_;
};

void send(TerminalElement& part, const Json& event) { part.terminal().send(need<std::string>(event, "text")); }

double heard(TerminalElement& part) { return static_cast<double>(part.terminal().heard().size()); }

}  // namespace

Model host_terminal() {
  using Row = Rows<TerminalElement>;
  return {
      .type = "host_terminal",
      .summary = "the remote end of a text serial line",
      .figures = serial_line(),
      .verbs = {Row::stimulus("send", "sends the text to the board", {required(text("text", ""))}, send)},
      .values = {Row::value("heard", "", "bytes received", heard)},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
