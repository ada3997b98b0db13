// Turns a description of parts and events into parts on a board's buses and things that happen to them.
//
// The description is a JSON document `finemote.scenario/1`: `parts` is what hangs on the board (the `run` command
// writes it from the robot's model), `events` what happens and when (the user's scenario file).
// docs/reference/scenario.md.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "emulator/board.hpp"
#include "emulator/parts/h30.hpp"
#include "emulator/parts/ms5837.hpp"
#include "emulator/parts/pca9685.hpp"
#include "emulator/parts/serial_terminal.hpp"
#include "emulator/parts/tca9548a.hpp"

namespace finemote::emulator {

/// Something a part did that a chain's ends are measured by.
struct PartEvent {
  enum class Kind {
    sample,  ///< `from`: when the quantity was sampled; `at`: when its last bit could be read
    output,  ///< `at`: when an output took its value; `from` the same
  };
  std::string part;
  Kind kind;
  unsigned channel;
  std::uint64_t from_ns, at_ns;  ///< since power-on
  std::uint64_t value;           ///< pulse width [ns] of an output
};

class Outfit {
 public:
  explicit Outfit(Board& board) : board_(board) {}

  /// Adds the document's parts, then plans its events; may be called again with further documents.
  /// @throws std::invalid_argument naming the entry and what is wrong with it
  void add(const nlohmann::ordered_json& document);

  /// In time order per part.
  [[nodiscard]] const std::vector<PartEvent>& events() const { return events_; }

  // By name; null when there is none of that kind.
  [[nodiscard]] H30* h30(const std::string& name);
  [[nodiscard]] Ms5837* ms5837(const std::string& name);
  [[nodiscard]] Tca9548a* tca9548a(const std::string& name);
  [[nodiscard]] Pca9685* pca9685(const std::string& name);
  [[nodiscard]] SerialTerminal* terminal(const std::string& name);

 private:
  using Json = nlohmann::ordered_json;
  template <class Part>
  using Named = std::map<std::string, std::unique_ptr<Part>>;

  void add_part(const Json& part);
  void add_event(const Json& event);
  void happen(const Json& event);
  void happen_to_part(const Json& event, const std::string& name);
  static void check_pin(const Json& event);
  void happen_to_pin(const Json& event, const std::string& pin);
  void happen_to_port(const Json& event, const std::string& port);
  void add_h30(const Json& part, const std::string& name);
  void add_pca9685(const Json& part, const std::string& name);
  Usart& usart_of(const Json& part);
  I2cLine& line_of(const Json& part);

  Board& board_;
  Named<H30> h30s_;
  Named<Ms5837> ms5837s_;
  Named<Tca9548a> muxes_;
  Named<Pca9685> pwms_;
  Named<SerialTerminal> terminals_;
  std::map<std::string, Attitude> attitudes_;
  std::map<std::string, double> pressures_;
  std::vector<PartEvent> events_;
};

}  // namespace finemote::emulator
