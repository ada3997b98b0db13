// A JSON text to a value whose every member can be found again as line and column.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

using Json = nlohmann::ordered_json;

/// The way to a member: keys, and indices as decimal numbers.
using JsonPath = std::vector<std::string>;

/// The texts that say a value: most often one, and for what is laid over others those too, nearest first.
class Origin {
 public:
  Origin(const SourceFile& source) : layers_{&source} {}  // NOLINT(google-explicit-constructor): one text is an origin

  void lay_over(const Origin& below) { layers_.insert(layers_.end(), below.layers_.begin(), below.layers_.end()); }
  [[nodiscard]] const std::vector<const SourceFile*>& layers() const { return layers_; }

 private:
  std::vector<const SourceFile*> layers_;
};

struct JsonFile {
  Origin origin;
  Json value;
};

/// A stretch of a source text.
struct Extent {
  Position at;
  std::size_t length = 1;
};

/// Parses a text. Reports FM3101 at the wrong byte and where it is nested too deep, and FM3103 where an object has one
/// key twice; then there is no value.
std::optional<JsonFile> parse_json(const SourceFile& source, Diagnostics& diagnostics);

/// The text that is a member of the outermost object, whatever else is wrong with `text`; none where it cannot be told.
std::optional<std::string> peek_text(std::string_view text, const char* key);

/// Where the value at `path` stands, or its nearest ancestor that exists; a container is shown by its key.
/// Looked up in the texts when asked, so a text without mistakes costs nothing.
Extent find_value(const Origin& origin, const JsonPath& path);

/// Whether there is a value at `path`.
bool holds_value(const Origin& origin, const JsonPath& path);

/// The place of a byte of a text.
Position position_at(const SourceFile& source, std::size_t offset);

}  // namespace finemote::gen
