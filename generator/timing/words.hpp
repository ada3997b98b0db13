// Words that the messages and tables of the timing analysis share.
#pragma once

#include <string>
#include <string_view>

#include "generator/timing/chains.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// `assumed`, `declared`, `measured`, `static`; `given` where the model does not say.
std::string_view label_of(WcetSource source);

/// `acquire`, `decide`, `wire`.
std::string_view part_name(ChainPart part);

/// 0 and above; a whole of 0 counts as 1 ns.
double ratio(Duration part, Duration whole);

/// `38.2 %`
std::string percent(double fraction);

/// `38 %`
std::string whole_percent(double fraction);

/// `'imu'`
std::string quoted(const std::string& name);

/// `'a', 'b' and 3 more`: the names of devices, at most `most` of them.
std::string quoted_names(const Model& model, const std::vector<Rank>& devices, std::size_t most);

/// `the devices with period 1ms`
std::string bucket_text(Duration period);

}  // namespace finemote::gen::timing
