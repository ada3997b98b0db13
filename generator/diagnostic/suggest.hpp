// Did-you-mean: finds the valid names nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

/// The candidates within a small edit distance (insert, delete, replace, swap of neighbours; a third of the
/// length, at least 2) of `word`, nearest first, at most three; letter case alone counts as half a step.
std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& candidates);

/// `did you mean 'a' or 'b'?`; when nothing is near, `valid here: 'a', 'b', ...` (at most twelve); empty for no
/// candidates.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// `did you mean 'a' or 'b'?` as a list to put behind a message; empty when nothing is near.
std::vector<std::string> near_hint(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace finemote::gen
