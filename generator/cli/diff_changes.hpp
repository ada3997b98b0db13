// Two sets of facts to what changed between them, and that to text for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/cli/diff_facts.hpp"

namespace finemote::gen {

/// A subject that came or went, or one property of it that is another now.
struct ModelChange {
  enum class Kind { added, removed, changed };
  Kind kind = Kind::changed;
  std::string subject;        ///< `device 'imu'`
  std::string property;       ///< of Kind::changed: `period`
  std::string before, after;  ///< its values; `none` for what is not there
};

/// The robot first, then devices, buses, what is asked of them, bounds, sizes, and the rest of the URDF.
std::vector<ModelChange> changes_of(const Facts& before, const Facts& after);

/// `device 'imu': period 10ms -> 5ms`
std::string line_of(const ModelChange& change);

/// `subject`, `property`, `before` and `after`; null for what does not apply.
nlohmann::ordered_json json_of(const ModelChange& change);

/// Changes as a table and the text below it folded up, for a comment on a code host. Text beyond what a comment holds
/// is left out.
/// @param remark  a line below the table; empty: none
std::string markdown_of(const std::vector<ModelChange>& changes, const std::string& remark,
                        const std::string& text_diff);

}  // namespace finemote::gen
