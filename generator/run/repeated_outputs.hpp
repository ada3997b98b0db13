// Which outputs of an expander say nothing of the command that they carry.
#pragma once

#include <vector>

#include "generator/model/robot.hpp"
#include "generator/run/record.hpp"

namespace finemote::gen {

/// A command that changes nothing is not sent by itself: it goes along when its expander is written for another reason.
/// Where several buckets drive the expander, that can be the flush of any of them, at any time until the next command.
/// Such outputs are those of an expander with devices of several periods that show the value they have shown before.
/// `parts` is in the order of time.
void note_repeated(const Robot& robot, std::vector<PartRecord>& parts);

}  // namespace finemote::gen
