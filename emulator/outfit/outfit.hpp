// Turns a description of parts and events into parts on a board's buses, things that happen to them, and what is to be
// seen at them.
//
// The description is a JSON document `finemote.scenario/1`: `parts` is what hangs on the board (the `run` command
// writes it from the robot's model), `events` what happens and when, `expect` what values have to be (both from the
// user's scenario file). docs/reference/emulator.md.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "emulator/board.hpp"
#include "emulator/outfit/driven_pin.hpp"
#include "emulator/outfit/element.hpp"
#include "emulator/scenario/grammar.hpp"

namespace finemote::emulator {

/// An event at a part where a measured chain begins or ends. Where bytes come from is known on a board with
/// `BoardOptions::tags`.
struct PartEvent {
  enum class Kind {
    sample,  ///< `from`: when the quantity was sampled; `at`: when its last bit could be read
    output,  ///< `at`: when an output took its value; `from` the same
  };
  std::string part;
  Kind kind;
  unsigned channel;
  Time from, at;  ///< since power-on
  double value;   ///< of an output: pulse width [ns], current command
  /// The stage of the handle whose bytes an output took; empty of a sample, and where they come from no handle.
  std::optional<std::uint32_t> stage = {};
  std::uint32_t n = 0;  ///< counts the samples of the channel, or the runs of the handle since power-on, from 0
};

/// What the state of a device was made of when an update of it ended.
struct SampleUse {
  Time at;              ///< since power-on
  std::uint32_t stage;  ///< of the update
  std::string part;
  unsigned channel;
  std::uint32_t n;  ///< of the sample of that channel
  Claim claimed;    ///< when the state's data were taken, as it says
};

/// A quantity of a part now.
struct PartValue {
  std::string name, unit;
  double value;
  bool is_of_family;  ///< one of many of the same row: `r0`..`r255`
};

/// A value of a part that has to stay between two limits, and where it has been.
struct Expectation {
  std::string part, value;
  std::uint64_t from_ns = 0, to_ns = 0;  ///< since `zero_ns`
  std::int64_t zero_ns = 0;              ///< since power-on
  double min = 0, max = 0;
  double lowest = 0, highest = 0;  ///< seen, of the finite ones; both 0 before the first
  std::uint64_t looks = 0, needed = 0;
  std::uint64_t not_finite = 0;  ///< looks at which it was no number, or infinite
  std::uint64_t broken_ns = 0;   ///< first look outside; 0: none
  [[nodiscard]] bool has_seen() const { return looks > not_finite; }
  [[nodiscard]] bool holds() const { return looks == needed && broken_ns == 0; }
};

/// An assumption of the bounds that an event violates, and the part or port that the event names; empty: none.
struct Violation {
  std::string assumption, part, port;
  friend bool operator==(const Violation&, const Violation&) = default;
};

class Outfit {
 public:
  explicit Outfit(Board& board) : board_(board) {}
  Outfit(const Outfit&) = delete;
  Outfit& operator=(const Outfit&) = delete;

  /// Adds the document's parts, then plans its events and looks, whose times count from `zero_ns` since power-on; may
  /// be called again with further documents.
  /// @throws std::invalid_argument with every mistake in it, as emulator/scenario/read.hpp reports them
  void add(const Json& document, std::int64_t zero_ns = 0);

  /// In the order they happened.
  [[nodiscard]] const std::vector<PartEvent>& events() const { return events_; }
  /// In the order of time; one for each source that an update's state is made of.
  [[nodiscard]] std::vector<SampleUse> uses() const;
  [[nodiscard]] const std::vector<Expectation>& expectations() const { return expectations_; }
  /// Assumptions of the bounds that events violate, in the order of the events: those of faults, not of stimuli or of
  /// ends of faults.
  [[nodiscard]] const std::vector<Violation>& violated() const { return violated_; }
  /// When the first of these happens [ns since power-on]; none: none does.
  [[nodiscard]] std::optional<std::int64_t> violated_from_ns() const { return violated_from_ns_; }
  /// Resets the scenario has asked for so far.
  [[nodiscard]] unsigned scripted_resets() const { return scripted_resets_; }
  /// Told before each of them: the firmware forgets what it has counted.
  std::function<void()> on_reset;

  /// A quantity of a part now. @throws std::invalid_argument when there is no such part or quantity
  double value(const std::string& part, const std::string& quantity);
  /// Names of all parts, as they were added.
  [[nodiscard]] std::vector<std::string> names() const;
  /// All quantities of a part now, in the order of its row.
  std::vector<PartValue> values(const std::string& part);
  /// What a host terminal has heard.
  std::string text(const std::string& part);
  /// The host terminal of this name, or null.
  SerialTerminal* terminal(const std::string& part);

  // For elements.
  Board& board() { return board_; }
  [[nodiscard]] Time now() { return board_.world().now(); }
  void record(PartEvent event) { events_.push_back(std::move(event)); }
  /// The next sample of a part's channel, taken at `from`: what its bytes carry.
  Tag sample(const std::string& part, unsigned channel, Time from, Time readable);
  /// What the element of this name is to others; null when there is none, or it is not that.
  template <class As>
  As* find(const std::string& name) {
    const auto found = parts_.find(name);
    return found == parts_.end() ? nullptr : dynamic_cast<As*>(found->second.element.get());
  }
  /// Pulls the reset pin, as the scenario asks for.
  void press_reset();
  Usart& usart_of(const Json& part);
  CanLine& can_of(const Json& part);
  I2cLine& line_of(const Json& part);
  /// Calls the listener for every change of the PWM output the part is connected to.
  void listen_to_pulses(const Json& part, PulseSource::Listener listener);
  /// Calls the listener, now and with every change, of how the output the part is connected to is driven: also where
  /// the pin of a header is no timer's but a plain output.
  void listen_to_drive(const Json& part, DrivenPin::Listener listener);
  /// Told of every pulse width [ns] written, and where it comes from.
  using WriteListener = std::function<void(std::uint64_t width_ns, Tag origin)>;
  /// Calls the listener for every pulse width written for the PWM header the part is connected to.
  void listen_to_writes(const Json& part, WriteListener listener);

 private:
  void add_part(const Json& part);
  void add_event(const Json& event, std::int64_t zero_ns);
  void add_expectation(const Json& entry, std::int64_t zero_ns);
  void plan_look(std::size_t expectation);
  void look(std::size_t expectation);
  /// The row of what happens.
  [[nodiscard]] const scenario::Verb& verb_of(const Json& event) const;

  /// A part with the row it was made by.
  struct Part {
    const scenario::Model* model;
    std::unique_ptr<Element> element;
  };
  using Header = std::pair<Timer*, unsigned>;
  Header header_of(const Json& part);

  Board& board_;
  std::map<std::string, Part> parts_;
  std::vector<std::string> names_;  ///< of them, as they were added
  std::map<Header, std::vector<PulseSource::Listener>> headers_;
  std::map<Header, std::vector<WriteListener>> writes_;
  std::map<Header, std::unique_ptr<DrivenPin>> pins_;
  using Channel = std::pair<std::string, unsigned>;  ///< of a part
  std::map<Channel, std::uint32_t> sources_;         ///< numbers of samples' sources
  std::vector<Channel> channels_;                    ///< by them
  std::vector<PartEvent> events_;
  std::vector<Expectation> expectations_;
  unsigned scripted_resets_ = 0;
  std::vector<Violation> violated_;
  std::optional<std::int64_t> violated_from_ns_;
};

}  // namespace finemote::emulator
