// Which interrupts windows of jobs hold, beside those of any window.
#include <algorithm>

#include "catch.hpp"
#include "duration_literals.hpp"
#include "generator/timing/demand.hpp"
#include "generator/timing/profile.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

Device device(const std::string& name, Duration period) {
  Device d;
  d.name = name;
  d.period = period;
  d.update_wcet = d.handle_wcet = 10_ns;
  return d;
}

// Of a bucket with one device.
constexpr Stages kUpdate{0, 0}, kHandle{1, 1}, kAll;

/// Three buckets of one device each, of which the one in the middle uses a bus.
class Robot {
 public:
  explicit Robot(InterruptCause cause, bool in_update = false) {
    model.has_target = true;
    model.tick = 1000_ns;
    Bus bus;
    bus.name = "bus";
    InterruptSource source{"source", 5_ns, 1_ns, {}};
    source.budgets.push_back({Rank{1}, 3, 1, {}});
    source.budgets.back().cause = cause;
    source.budgets.back().asked_in = in_update ? AskedIn::update : AskedIn::handle;
    if (cause == InterruptCause::look) source.budgets.back().carry_in = 2;
    bus.sources = {source};
    model.buses.push_back(bus);
    for (const Duration period : {1000_ns, 2000_ns, 4000_ns}) model.devices.push_back(device("d", period));
    Transfer transfer;
    transfer.bus = BusPlace{0};
    transfer.wire = 100_ns;
    transfer.interrupts = 0;
    transfer.after = in_update ? Transfer::After::update : Transfer::After::handle;
    model.devices[Rank{1}].transfers.push_back(transfer);
  }

  using Windows = const std::vector<Stream>& (TaskSet::*)(std::size_t bucket) const;

  /// The bus's budget of other buckets' jobs in windows of one bucket.
  [[nodiscard]] Stream::Budget budget(std::size_t bucket, Windows windows = &TaskSet::in_job) const {
    const TaskSet set = analyse_deadlines(model, Profile::target).set;
    const auto& streams = (set.*windows)(bucket);
    REQUIRE(streams.front().budgets.size() == 1);
    return streams.front().budgets.front();
  }
  /// What the job of the middle bucket raises itself while these stages run.
  [[nodiscard]] std::int64_t raised(const Stages& stages, Windows windows = &TaskSet::in_job) const {
    const TaskSet set = analyse_deadlines(model, Profile::target).set;
    const Stream& stream = (set.*windows)(1).front();
    REQUIRE(stream.budgets.empty());
    std::int64_t sum = 0;
    for (const Raised& raised : stream.raised) sum += raised.in(stages);
    return sum;
  }

  Model model;
};

}  // namespace

TEST_CASE("a request runs with the stage that asks, and once where a masked section holds it back") {
  const Robot later(InterruptCause::request), early(InterruptCause::request, true);
  CHECK(later.budget(2).carry_in == 0);  // a more urgent job asks: as often as it is released
  CHECK(later.budget(2).most == kUnlimited);
  CHECK(later.raised(kAll) == 3);
  CHECK(later.raised(kUpdate) == 0);
  CHECK(early.raised(kUpdate) == 3);
  CHECK(later.budget(0).most == 1);  // a less urgent one asked just before
}

TEST_CASE("a flush asks behind all handles") {
  Robot robot(InterruptCause::request);
  robot.model.buses[BusPlace{0}].sources->front().budgets.front().asked_in = AskedIn::flush;
  CHECK(robot.raised({0, 1}) == 0);
  CHECK(robot.raised(kAll) == 3);
  CHECK(robot.raised(kAll, &TaskSet::inside_job) == 3);
  // The job ends with it, even where nobody says how long the flush takes.
  const Responses responses = analyse_deadlines(robot.model, Profile::target).responses;
  CHECK(responses.bucket[1] == responses.r_minus[Rank{1}] + 3 * 5_ns);
}

TEST_CASE("who raises nothing does not stand for those that do") {
  Robot robot(InterruptCause::request);
  std::vector<FrameBudget>& budgets = robot.model.buses[BusPlace{0}].sources->front().budgets;
  budgets.insert(budgets.begin(), budgets.front());
  budgets.front().count = 0;
  const TaskSet set = analyse_deadlines(robot.model, Profile::target).set;
  const auto& others = set.in_job(0).front().budgets;
  CHECK(std::any_of(others.begin(), others.end(), [](const Stream::Budget& b) { return b.count > 0 && b.most == 1; }));
}

TEST_CASE("a stage counts what earlier ones of its job raise, and not what later ones do") {
  Robot robot(InterruptCause::request, true);
  robot.model.devices.push_back(device("second", 2000_ns));
  InterruptSource& source = robot.model.buses[BusPlace{0}].sources->front();
  FrameBudget other = source.budgets.front();
  other.device = Rank{3};
  other.count = 5;
  source.budgets.push_back(other);
  CHECK(robot.raised({0, 0}) == 3);
  CHECK(robot.raised({0, 1}) == 8);
  CHECK(robot.raised({1, 1}, &TaskSet::inside_job) == 5);
  CHECK(robot.raised({2, 3}, &TaskSet::inside_job) == 0);
  // The other handle of the job ends no earlier for it, but the update of the first device does.
  const ProfileAnalysis analysis = analyse_deadlines(robot.model, Profile::target);
  CHECK(analysis.responses.r_plus[Rank{3}] - analysis.responses.r_plus[Rank{1}] == 10_ns + 5 * 5_ns);
}

TEST_CASE("a transfer goes on after its job, until it has ended") {
  const Robot later(InterruptCause::transfer), early(InterruptCause::transfer, true);

  const Responses responses = analyse_deadlines(later.model, Profile::target).responses;
  const Stream::Budget above = later.budget(2);
  CHECK(above.carry_in == 0);
  CHECK(above.jitter >= responses.r_minus[Rank{1}] + 100_ns);
  CHECK(above.jitter < 400_ns);
  CHECK(above.most == kUnlimited);
  CHECK(later.raised(kAll) == 3);
  CHECK(later.raised(kUpdate) == 0);
  CHECK(early.raised(kUpdate) == 3);
  CHECK(later.budget(0).most == 3);  // of the job before
}

TEST_CASE("where transfers may last as long as the period, windows of jobs hold what any window does") {
  Robot slow(InterruptCause::transfer);
  slow.model.devices[Rank{1}].transfers.front().wire = 1990_ns;
  for (const std::size_t bucket : {0U, 1U, 2U}) {
    CHECK(slow.budget(bucket).carry_in == 2);  // one more may be under way
    CHECK(slow.budget(bucket).jitter == 0_ns);
    CHECK(slow.budget(bucket).most == kUnlimited);
  }
  slow.model.devices[Rank{1}].transfers.clear();  // it is unknown when they end
  CHECK(slow.budget(0).most == kUnlimited);
}

TEST_CASE("transfers that have not ended when more urgent work may hold the window open count twice") {
  Robot slow(InterruptCause::transfer);
  const Responses responses = analyse_deadlines(slow.model, Profile::target).responses;
  slow.model.devices[Rank{1}].transfers.front().wire = 2000_ns - responses.r_minus[Rank{1}] - 35_ns;
  CHECK(slow.budget(2).jitter > 1900_ns);
  CHECK(slow.budget(1).carry_in == 1);
  CHECK(slow.budget(1).most == kUnlimited);
}

TEST_CASE("where releases are lost, nothing knows when transfers end") {
  Robot robot(InterruptCause::transfer);
  robot.model.costs.keeps_one_release = true;
  robot.model.costs.release = 1500_ns;
  const TaskSet set = analyse_deadlines(robot.model, Profile::target).set;
  for (const std::vector<Stream>* streams : {&set.streams, &set.sources})
    CHECK(streams->front().budgets.front().carry_in == 2);
  CHECK(set.of_jobs.empty());
}

TEST_CASE("what is asked for once in several jobs may last as a whole turn of it") {
  Robot slow(InterruptCause::transfer);
  slow.model.buses[BusPlace{0}].sources->front().budgets.front().every = 3;
  slow.model.devices[Rank{1}].transfers.front().wire = 1990_ns;
  CHECK(slow.budget(1).carry_in == 1 + 3);
}

TEST_CASE("a look allows what it allows, beside what was left before it") {
  const Robot robot(InterruptCause::look);
  CHECK(robot.budget(2).carry_in == 1);
  CHECK(robot.raised(kUpdate) == 6);
  CHECK(robot.budget(0).most == 3);
}

TEST_CASE("a window that begins in a job holds what is asked for in that part of it") {
  const Robot later(InterruptCause::request), early(InterruptCause::request, true);
  CHECK(early.raised(kAll, &TaskSet::inside_job) == 3);
  CHECK(early.raised(kHandle, &TaskSet::inside_job) == 0);
  CHECK(later.raised(kHandle, &TaskSet::inside_job) == 3);
  CHECK(later.budget(2, &TaskSet::inside_job).most == kUnlimited);  // a more urgent job asks
  CHECK(later.budget(0, &TaskSet::inside_job).most == 0);           // a less urgent one is not in a masked section
}

TEST_CASE("frames of a less urgent job go along with the next request of a window that begins in a job") {
  Robot robot(InterruptCause::request);
  InterruptSource& source = robot.model.buses[BusPlace{0}].sources->front();
  FrameBudget other = source.budgets.front();
  other.device = Rank{0};
  source.budgets.push_back(other);
  const TaskSet set = analyse_deadlines(robot.model, Profile::target).set;
  const Stream& stream = set.inside_job(0).front();
  const auto most = [&](const Stages& stages) {
    std::int64_t sum = stream.budgets.front().most;
    for (const Raised& raised : stream.raised) sum += raised.in(stages);
    return sum;
  };
  CHECK(most(kHandle) == 3 + 1);
  CHECK(most(kUpdate) == 0);  // nobody asks
}

TEST_CASE("in a window that begins in a job, transfers are those of the job: the ones before have ended") {
  Robot slow(InterruptCause::transfer);
  const Responses responses = analyse_deadlines(slow.model, Profile::target).responses;
  slow.model.devices[Rank{1}].transfers.front().wire = 2000_ns - responses.r_minus[Rank{1}] - 35_ns;
  CHECK(slow.budget(1).most == kUnlimited);
  CHECK(slow.raised(kUpdate, &TaskSet::inside_job) == 0);
  CHECK(slow.raised(kHandle, &TaskSet::inside_job) == 3);
}

TEST_CASE("what was asked for before a window that begins in a job goes on in it") {
  const Robot early(InterruptCause::transfer, true);
  CHECK(early.raised(kHandle, &TaskSet::inside_job) == 3);
}

TEST_CASE("behind the updates of a job only what was left before its look can come") {
  const Robot robot(InterruptCause::look);
  CHECK(robot.raised(kAll, &TaskSet::inside_job) == 6);
  CHECK(robot.raised(kHandle, &TaskSet::inside_job) == 3);
}

TEST_CASE("what no job causes counts as in any window") {
  const Robot robot(InterruptCause::clock);
  for (const std::size_t bucket : {0U, 1U, 2U}) {
    CHECK(robot.budget(bucket).carry_in == 1);
    CHECK(robot.budget(bucket).most == kUnlimited);
  }
}

TEST_CASE("requests at any distance are as many as their budgets allow, in the longest window too") {
  Stream requests{1_ns, 4000_ns, {}, "request"};
  Stream::Budget budget;
  budget.count = 2;
  budget.period = 1_ms;
  requests.budgets = {budget};
  const std::vector<Stream> streams{requests};
  Effort effort;
  Demand demand(effort);
  demand.add_streams(streams);
  CHECK(demand.at(1_ns) == 4000_ns);
  CHECK(demand.at(1_ms) == 8000_ns);
  CHECK(demand.at(kLongest) == ceil_div(kLongest, 1_ms) * 8000_ns);
}
