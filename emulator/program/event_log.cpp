#include "emulator/program/event_log.hpp"

#include <cstdio>

namespace finemote::emulator {

EventLog::EventLog(Board& board, std::ostream& out) : board_(board), out_(out) {
  watch_pins();
  watch_serial_lines();
  watch_buses();
  watch_timers();
}

template <class... Values>
void EventLog::line(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  out_ << board_.now_ns() << ' ' << text << '\n';
}

void EventLog::watch_pins() {
  for (char port = 'A'; port <= 'I'; ++port) {
    board_.chip().gpio(port).on_output = [this, port](unsigned pin, bool output, bool high) {
      if (output) line("P%c%u %d", port, pin, high ? 1 : 0);
    };
  }
}

/// A byte as text where it is some.
void EventLog::show_byte(const char* name, std::uint8_t byte) {
  if (byte >= 0x20 && byte < 0x7F) return line("%s 0x%02X '%c'", name, byte, byte);
  line("%s 0x%02X", name, byte);
}

/// The line of text that ends here, if it is one: what a terminal would show.
void EventLog::show_text(const std::string& name, char c) {
  std::string& text = texts_[name];
  const bool is_text = (c >= 0x20 && c < 0x7F) || c == '\t';
  if (is_text) {
    text += c;
    return;
  }
  if (c == '\n' && text.size() > 1) out_ << board_.now_ns() << ' ' << name << " text " << text << '\n';
  if (c != '\r') text.clear();
}

void EventLog::watch_serial_lines() {
  for (const auto& it : board_.chip().usarts()) {
    it->on_sent = [this, name = it->name().c_str(), other = it->on_sent](WireByte byte) {
      show_byte(name, byte);
      show_text(name, static_cast<char>(byte.value));
      if (other) other(byte);
    };
  }
}

void EventLog::watch_buses() {
  for (const auto& it : board_.chip().i2cs()) {
    it->on_wire = [this, name = it->name().c_str()](const char* what, std::uint8_t byte, bool acknowledged) {
      if (what[1] == 't') return line("%s stop", name);
      line("%s %s 0x%02X %s", name, what, byte, acknowledged ? "ACK" : "NACK");
    };
  }
  for (const auto& it : board_.chip().spis()) {
    it->on_frame = [this, name = it->name().c_str()](std::uint16_t out, std::uint16_t in, unsigned bits) {
      if (bits > 8) return line("%s out 0x%04X in 0x%04X", name, out, in);
      line("%s out 0x%02X in 0x%02X", name, out, in);
    };
  }
}

void EventLog::watch_timers() {
  for (const auto& it : board_.chip().timers()) {
    it->on_pulse = [this, name = it->name().c_str(), other = it->on_pulse](unsigned channel, Timer::Pulse pulse) {
      line("%s.%u pulse %llu of %llu ns", name, channel, static_cast<unsigned long long>(pulse.width_ns),
           static_cast<unsigned long long>(pulse.period_ns));
      if (other) other(channel, pulse);
    };
  }
}

}  // namespace finemote::emulator
