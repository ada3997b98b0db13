#include <finemote/schedule.hpp>

#include "trees/rov.hpp"

extern "C" void finemote_line_48();
extern "C" void finemote_line_49();

namespace Rov14 {

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

}  // namespace Rov14

extern "C" void finemote_line_48() {
  Rov14::run_5ms();
  finemote::complete(0);
}
extern "C" void finemote_line_49() {
  Rov14::run_10ms();
  finemote::complete(1);
}
extern "C" const finemote::Schedule finemote_schedule{
    "Rov14", 1'000'000, Rov14::buckets, finemote::Overrun::skip, Rov14::start_buses, Rov14::safe_outputs, nullptr};
