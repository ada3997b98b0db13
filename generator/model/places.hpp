// Where a device sits on its bus: what address, channel and id have in common.
#pragma once

#include <string>
#include <string_view>

#include "generator/model/reading.hpp"

namespace finemote::gen {

/// A device of a known type, with the tag that says its place.
struct Placing {
  Placing(Reading& all, DeviceId id);

  Reading& reading;
  Device& device;
  const DeviceType& type;
  const xml::Node& tag;
  bool bus_is_wrong;

  [[nodiscard]] Diagnostics& diagnostics() const { return reading.diagnostics; }
  /// True when the attribute may stand here. Reports FM3018 otherwise.
  [[nodiscard]] bool applies(const char* attribute, bool is_needed) const;
  /// Reports FM3010 unless the bus, or a misspelt attribute, explains it.
  void report_missing(const char* attribute, const std::string& example) const;
};

/// Something that sits somewhere, for messages.
struct Occupant {
  std::string what;  ///< `device 'baro_1'`
  const xml::Node* tag;
};

Occupant describe(const Reading& reading, DeviceId device);

/// An error at the attribute of the tag, or at the tag when the value was a default.
Diagnostic& at_place(Diagnostics& diagnostics, Code code, const Occupant& occupant, std::string_view attribute,
                     std::string message);

// What each kind of place says of itself, and what they say together.
void read_address(const Placing& at);         // addresses.cpp
void check_addresses(Reading& reading);       // addresses.cpp
void read_channel(const Placing& at);         // channels.cpp
void resolve_use_channels(Reading& reading);  // channels.cpp: the pulse output or chip select that a <use> names
void check_channels(Reading& reading);        // channels.cpp
void read_id(const Placing& at);              // ids.cpp
void check_ids(Reading& reading);             // ids.cpp
void check_shared_frames(Reading& reading);   // ids.cpp

}  // namespace finemote::gen
