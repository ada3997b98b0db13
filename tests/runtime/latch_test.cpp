// Latches in every interleaving: the more urgent side is run between any two steps of the other one.
//
// A value is copied in two halves with a step between, so that a half-written one is seen if it can be seen at all.
#include "finemote/latch.hpp"

#include <functional>

#include "catch.hpp"
#include "finemote/interfaces.hpp"

namespace {

// What the analysis counts for the copy of a value of a shipped interface: generator/tasks/from_robot.cpp.
constexpr std::size_t kShippedBytes = 96;

template <class... Values>
constexpr bool fit = ((sizeof(Values) <= kShippedBytes) && ...);
static_assert(fit<finemote::Stamp, finemote::BatteryState, finemote::ButtonState, finemote::ImuState,
                  finemote::LightState, finemote::LightCommand, finemote::LinkState, finemote::MagnetometerState,
                  finemote::MotorState, finemote::MotorCommand, finemote::PressureState, finemote::RemoteState,
                  finemote::ServoState, finemote::ServoCommand, finemote::SounderState, finemote::SounderCommand,
                  finemote::ThrusterState, finemote::ThrusterCommand>);

struct Value {
  int first = 0;
  int second = 0;
};

bool whole(const Value& value) { return value.first == value.second; }

// Called at every step of the interrupted side; does what the interleaving asks for.
std::function<void()> at_step;
bool interrupted_now = false;

struct Interruptible {
  template <class T>
  static void copy(T& to, const T& from) {
    to.first = from.first;
    point();
    to.second = from.second;
  }
  static void point() {
    if (at_step && !interrupted_now) at_step();
  }
};

/// Runs `interrupting` at the steps whose bits are set, `times` times each, while `interrupted` runs; the interrupting
/// side is itself not interrupted. Returns the number of steps seen.
unsigned interleave(std::uint32_t steps, unsigned times, const std::function<void()>& interrupted,
                    const std::function<void()>& interrupting) {
  unsigned step = 0;
  at_step = [&] {
    if ((steps >> step++ & 1U) == 0) return;
    interrupted_now = true;
    for (unsigned i = 0; i < times; ++i) interrupting();
    interrupted_now = false;
  };
  interrupted();
  at_step = nullptr;
  return step;
}

}  // namespace

TEST_CASE("fast writer to slow reader: every interleaving reads whole, fresh and never older values") {
  unsigned interleavings = 0;
  // Up to three publications at any set of the reader's steps, with and without publications before.
  for (unsigned before = 0; before <= 3; ++before) {
    for (unsigned times = 1; times <= 4; ++times) {
      for (std::uint32_t steps = 0; steps < 1U << 9; ++steps) {
        finemote::LatchToSlow<Value, Interruptible> latch;
        int written = 0;
        const auto publish = [&] {
          ++written;
          latch.publish({written, written});
        };
        for (unsigned i = 0; i < before; ++i) publish();
        int last_read = 0;
        bool good = true;
        const auto read = [&] {
          const int finished = written;  // publications that had ended when the snapshot began
          const Value& seen = latch.snapshot();
          Value copy{};
          Interruptible::copy(copy, seen);  // the reader uses the reference while the writer goes on
          good = good && whole(copy) && copy.first >= finished && copy.first >= last_read;
          last_read = copy.first;
        };
        interleave(
            steps, times,
            [&] {
              for (int i = 0; i < 3; ++i) read();
            },
            publish);
        REQUIRE(good);
        ++interleavings;
      }
    }
  }
  CHECK(interleavings == 4 * 4 * 512);
}

TEST_CASE("fast writer to slow reader: three reads have nine steps, so that 2^9 interleavings are all") {
  finemote::LatchToSlow<Value, Interruptible> latch;
  const unsigned steps = interleave(
      0, 0,
      [&] {
        for (int i = 0; i < 3; ++i) {
          Value copy{};
          Interruptible::copy(copy, latch.snapshot());
        }
      },
      [] {});
  CHECK(steps == 9);
}

TEST_CASE("slow writer to fast reader: every interleaving reads whole, fresh and never older values") {
  for (std::uint32_t steps = 0; steps < 1U << 12; ++steps) {
    finemote::LatchToFast<Value, Interruptible> latch;
    int finished = 0;
    int last_read = 0;
    bool good = true;
    const auto read = [&] {
      const Value seen = latch.snapshot();
      good = good && whole(seen) && seen.first >= finished && seen.first <= finished + 1 && seen.first >= last_read;
      last_read = seen.first;
    };
    const unsigned seen_steps = interleave(
        steps, 1,
        [&] {
          for (int i = 1; i <= 3; ++i) {
            latch.publish({i, i});
            finished = i;
          }
        },
        read);
    REQUIRE(good);
    REQUIRE(seen_steps == 12);
    read();
    REQUIRE(last_read == 3);
  }
}

TEST_CASE("the interleaving test sees a latch that does not protect its reader") {
  // The latch one would write first: the reader takes the latest slot without saying so.
  struct Naive {
    void publish(const Value& value) {
      latest ^= 1;
      Interruptible::copy(slots[latest], value);
    }
    const Value& snapshot() { return slots[latest]; }
    Value slots[2];
    int latest = 0;
  };
  bool torn = false;
  for (std::uint32_t steps = 0; steps < 1U << 3; ++steps) {
    Naive latch;
    int written = 0;
    interleave(
        steps, 2,
        [&] {
          Value copy{};
          Interruptible::copy(copy, latch.snapshot());
          torn = torn || !whole(copy);
        },
        [&] {
          ++written, latch.publish({written, written});
        });
  }
  CHECK(torn);
}
