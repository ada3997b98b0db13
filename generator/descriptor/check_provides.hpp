// What a device type provides: names that the generated code gives to members.
#pragma once

#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/device_type.hpp"

namespace finemote::gen {

/// Reports members and fields whose names C++ or the stamp of a State takes, fields given twice, one member for State
/// and Command, and fields of a Command that there is not.
void check_provides(const std::vector<Interface>& provides, const Contradictions& found);

}  // namespace finemote::gen
