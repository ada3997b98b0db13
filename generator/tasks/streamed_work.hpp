// The frames that update() takes apart: fewer than fit two periods where its response time is known.
#pragma once

#include "generator/forest/forest.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// Shortens the assumed execution times of devices whose parts send by themselves. The robot's count the frames of two
/// periods, which is what two looks are apart at most while deadlines are met; with the response times that follow, two
/// looks are a period and a response time apart at most. Leaves the model as it is where a deadline may be missed. May
/// throw Overflow.
void shorten_streamed_work(const Robot& robot, const Forest& forest, Model& model);

}  // namespace finemote::gen::timing
