// Did-you-mean: finds the valid names nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen {

struct Diagnostic;

/// At most three candidates within a small edit distance (a third of the length, at least 2; letter case counts half);
/// without such, those that hold the word or lie in it (`m3508`), then those that share a part with it (`rm_imu`).
std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& candidates);

/// `did you mean 'a' or 'b'?`; when nothing is near, `valid here: 'a', 'b', ...` (at most twelve); empty for no
/// candidates.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// `did you mean 'a' or 'b'?` as a list to append to a message; empty when nothing is near.
std::vector<std::string> near_hint(std::string_view word, const std::vector<std::string>& candidates);

/// Adds the text of did_you_mean() to a finding, unless it is empty.
void suggest(Diagnostic& finding, std::string_view word, const std::vector<std::string>& candidates);

/// Whether a word is a name with a typing mistake: one letter off (two in names of seven and more), letters in another
/// order, or another letter case. For words among which many are right and simply not ours: far stricter than the
/// others here.
bool is_mistyped(std::string_view word, std::string_view name);

}  // namespace finemote::gen
