// The kinds of descriptor file: how each says what it is, what checks it and where its name stands.
#pragma once

#include <string_view>

namespace finemote::gen {

struct FileFormat {
  std::string_view version;      ///< value of "schema": `finemote.device/1`
  std::string_view schema_file;  ///< in the schema folder; of a chip: what the boards on it are held to
  const char* name_key;          ///< the member that repeats the file's name
  const char* what;              ///< for messages

  /// Whether a value of "schema" is one of this kind, in this version or another.
  [[nodiscard]] constexpr bool is_kind_of(std::string_view other) const {
    return other.starts_with(version.substr(0, version.find('/') + 1));
  }
};

inline constexpr FileFormat kDeviceFormat{"finemote.device/1", "device.schema.json", "type", "device type"};
inline constexpr FileFormat kExpanderFormat{"finemote.expander/1", "expander.schema.json", "model", "expander"};
inline constexpr FileFormat kBoardFormat{"finemote.board/1", "board.schema.json", "name", "board"};
inline constexpr FileFormat kChipFormat{"finemote.chip/1", "board.schema.json", "name", "chip"};

}  // namespace finemote::gen
