// What happens at pins, timers and serial buses to lines of text, each with its time.
#pragma once

#include <map>
#include <ostream>
#include <string>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// Writes `time since power-on [ns], who, what` while the board runs. It outlives the board's last event.
class EventLog {
 public:
  /// Parts that listen to the board already hear it still.
  EventLog(Board& board, std::ostream& out);
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

 private:
  template <class... Values>
  void line(const char* format, Values... values);
  void show_byte(const char* name, std::uint8_t byte);
  void show_text(const std::string& name, char c);
  void watch_pins();
  void watch_serial_lines();
  void watch_buses();
  void watch_timers();

  Board& board_;
  std::ostream& out_;
  std::map<std::string, std::string> texts_;  ///< of lines of text that have no end yet, by serial port
};

}  // namespace finemote::emulator
