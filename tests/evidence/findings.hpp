// What our code makes of a vector: values by name, to be held against those of the vector's source.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/evidence/vectors.hpp"

namespace finemote::evidence {

/// What a value measures. Values are kept in SI units, temperatures in degrees Celsius; the name of a source's field
/// ends in its unit.
enum class Dimension {
  number,
  angle,
  angular_speed,
  acceleration,
  current,
  voltage,
  torque,
  temperature,
  pressure,
  field,
  time,
  frequency,
  share
};

/// How far two readings of the same bytes may be apart: what our numbers (single precision, whole steps) can show.
struct Tolerance {
  double relative = 1e-5;
  double absolute = 0;  ///< in the SI unit
};

struct Finding {
  Dimension dimension = Dimension::number;
  std::vector<double> values;
  Tolerance tolerance;
  double turn = 0;                 ///< values that differ by this mean the same; 0: none do
  std::vector<std::string> texts;  ///< instead of values
  bool at_least = false;           ///< the source states a minimum
};

/// A register and what is written to it.
struct Setting {
  unsigned address = 0, value = 0;
  std::int64_t wait = 0;  ///< ns until the next write
};

/// An entry of `writes`, with `min_wait_after_ns` as its wait.
std::vector<Setting> settings_of(const Json& writes);

class Findings {
 public:
  /// One finding under each of its names. A name without unit stands for all units of the dimension.
  void put(std::initializer_list<const char*> names, Dimension dimension, std::vector<double> values,
           Tolerance tolerance = {}, double turn = 0);
  void put(std::initializer_list<const char*> names, double value) { put(names, Dimension::number, {value}); }
  void put(std::initializer_list<const char*> names, std::vector<double> values) {
    put(names, Dimension::number, std::move(values));
  }
  /// Of a field that states a minimum.
  void put_least(const char* name, Dimension dimension, double value);
  void put_text(const char* name, std::vector<std::string> texts);
  /// A field that says in words what the vector's bytes say.
  void put_prose(const char* name) { prose_.push_back(name); }

  /// Something that has to come out of the vector whatever its fields are, as the bytes a part model answers.
  void check(const std::string& what, bool holds);

  /// Our code does not take the frame.
  void refuse() { refused_ = true; }
  [[nodiscard]] bool refused() const { return refused_; }

  std::optional<std::vector<Setting>> writes;

  /// The finding of a field's name and, where the name ends in a unit, that unit.
  struct Named {
    const Finding* finding = nullptr;
    double factor = 1, offset = 0;  ///< SI value = field * factor + offset
  };
  [[nodiscard]] Named find(const std::string& field) const;
  [[nodiscard]] bool is_prose(const std::string& field) const;
  [[nodiscard]] const std::vector<std::string>& failed_checks() const { return failed_; }

 private:
  std::map<std::string, Finding> findings_;
  std::vector<std::string> prose_, failed_;
  bool refused_ = false;
};

}  // namespace finemote::evidence
