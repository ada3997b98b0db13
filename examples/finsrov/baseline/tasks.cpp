#include "tasks.hpp"

extern "C" void finemote_line_48() {
  baseline::kernel_tick();
  finemote::drain_stores();
}

constexpr finemote::Bucket kTick[] = {{finemote_line_48, finemote::kMillisecond, 48, 4, 3}};
extern "C" constexpr finemote::Schedule finemote_schedule =
    baseline::tick_alone("tasks", kTick, baseline::start_robot_parts);
