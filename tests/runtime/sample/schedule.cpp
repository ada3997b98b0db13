#include <finemote/schedule.hpp>

#include "trees/rov.hpp"

#ifndef SAMPLE_OVERRUN
#define SAMPLE_OVERRUN finemote::Overrun::skip
#endif

extern "C" void finemote_line_48();
extern "C" void finemote_line_49();

namespace Sample {

void start_buses() {}
void safe_outputs() {}

/// Every 5 ms; priority 4; interrupt line 48.
void run_5ms() {
  rov::update_5ms();
  rov::handle_5ms();
}

/// Every 10 ms; priority 5; interrupt line 49.
void run_10ms() {
  rov::update_10ms();
  rov::handle_10ms();
}

namespace {
constexpr finemote::Bucket buckets[] = {
    {finemote_line_48, 5'000'000, 48, 4, 3},
    {finemote_line_49, 10'000'000, 49, 5, 3},
};
}  // namespace

}  // namespace Sample

extern "C" void finemote_line_48() {
  Sample::run_5ms();
  finemote::complete(0);
}
extern "C" void finemote_line_49() {
  Sample::run_10ms();
  finemote::complete(1);
}
extern "C" const finemote::Schedule finemote_schedule{
    "Sample", 1'000'000, Sample::buckets, SAMPLE_OVERRUN, Sample::start_buses, Sample::safe_outputs, nullptr};
