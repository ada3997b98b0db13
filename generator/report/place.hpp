// A result in a document to an element of a page that names it: `timing#/chains/0/decide_ns`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace finemote::gen::report {

using Json = nlohmann::ordered_json;

enum class Unit { time, room, share, bytes, count, number };

/// As people read it: `1.83 ms`, `38.2 %`, `12 345`; a dash for null. Times are rounded up, as a bound may not look
/// smaller than it is; what is left of a limit (`room`, a time as well) is rounded down.
std::string shown(const Json& value, Unit unit);

/// A value of a document, with the way to it. What is not there has places below it that are not there either.
class Place {
 public:
  /// Of the document `name`: `timing`, `simulation`, `run`. `document` outlives this.
  Place(const Json& document, std::string_view name);

  [[nodiscard]] Place operator[](std::string_view member) const;
  [[nodiscard]] Place operator[](std::size_t element) const;

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] const Json& value() const { return *value_; }  ///< requires exists()
  [[nodiscard]] std::size_t size() const;                      ///< of an array; else 0
  [[nodiscard]] std::string text() const;                      ///< of a string; else empty
  [[nodiscard]] bool is_true() const;
  [[nodiscard]] bool is_number() const { return exists() && value_->is_number(); }
  [[nodiscard]] double number() const { return is_number() ? value_->get<double>() : 0; }

  /// `<span data-key="..." data-value="...">1.83 ms</span>`; a dash for what does not exist.
  [[nodiscard]] std::string figure(Unit unit) const;
  /// The same as a cell of a table.
  [[nodiscard]] std::string cell(Unit unit) const;
  /// ` data-key="..." data-value="..."`, of an element that shows it as a picture; empty for what does not exist.
  [[nodiscard]] std::string attributes() const;

 private:
  Place(const Json* value, std::string key) : value_(value), key_(std::move(key)) {}
  [[nodiscard]] std::string element(std::string_view tag, Unit unit) const;

  const Json* value_;
  std::string key_;
};

}  // namespace finemote::gen::report
