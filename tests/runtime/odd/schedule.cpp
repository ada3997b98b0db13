// Three periods whose hyperperiod has far more instants than the release ring has slots, and one longer than the timer.
#include <finemote/constinit.hpp>
#include <finemote/schedule.hpp>
#include <finemote/stage.hpp>
#include <finemote/time.hpp>

extern "C" void finemote_line_38();
extern "C" void finemote_line_41();
extern "C" void finemote_line_61();
extern "C" void finemote_line_62();

namespace Odd {

using finemote::Stage;

void start_buses() {}
void safe_outputs() {}
template <std::uint16_t stage>
void work(finemote::Duration duration) {
  const Stage<stage> bracket;
  finemote::busy(duration);
}

namespace {
constexpr finemote::Bucket buckets[] = {
    {finemote_line_38, 7'000'000, 38, 4, 3},
    {finemote_line_41, 11'000'000, 41, 5, 3},
    {finemote_line_61, 13'000'000, 61, 6, 3},
    {finemote_line_62, 250'000'000, 62, 7, 3},
};
}  // namespace

}  // namespace Odd

extern "C" void finemote_line_38() { Odd::work<0>(1'513'000); }
extern "C" void finemote_line_41() { Odd::work<2>(2'327'000); }
extern "C" void finemote_line_61() { Odd::work<4>(2'141'000); }
extern "C" void finemote_line_62() { Odd::work<6>(8'757'000); }

extern "C" const finemote::Schedule finemote_schedule{
    "Odd", 1'000'000, Odd::buckets, finemote::Overrun::skip, Odd::start_buses, Odd::safe_outputs, nullptr};
