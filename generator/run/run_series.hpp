// What a run has seen over time, as members of its document.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "generator/run/chains.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// `{part, value, unit, from_ns, every_ns, lowest, highest, last, values}` of every series; null where nothing was
/// seen. Times are since the first release.
nlohmann::ordered_json value_list(const std::vector<ValueSeries>& series);

/// `{t_ns, age_ns}`, two lists of one length: when the command of a chain took effect, and how old its data were then.
/// Of commands that follow one another closely the oldest, so that no list is longer than `most`.
nlohmann::ordered_json ages_of(const MeasuredChain& chain, std::size_t most);

/// How many ages of each chain a document holds, of this many chains.
std::size_t most_ages(std::size_t chains);

}  // namespace finemote::gen
