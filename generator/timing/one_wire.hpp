// What the ends of frames on one wire can raise together: frames end one after the other, whoever sends them.
#pragma once

#include <vector>

#include "generator/timing/task_set.hpp"

namespace finemote::gen::timing {

/// The same interrupts of one bus, in streams whose sum is no more work in any window, and less where several kinds
/// come from the ends of frames. Two frames end at least the shortest of them apart, so that a window holds no more
/// ends of all kinds than of the shortest one, while each kind by itself still has its budgets.
///
/// With costs c1 >= c2 >= ... of the kinds, work is the sum over j of (cj - cj+1) times the ends of the first j kinds;
/// each term is a stream, with the budgets of those kinds and the least of their separations.
/// @param sources  of one bus
/// @param bit      its time on the wire: what a frame raises at its receiver comes one earlier than what it raises at
///                 its sender (ISO 11898-1, 10.7), and a node sets its clock by less than another one
std::vector<Stream> one_wire(std::vector<Stream> sources, Duration bit);

}  // namespace finemote::gen::timing
