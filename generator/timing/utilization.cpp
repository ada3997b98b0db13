#include "generator/timing/utilization.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>

namespace finemote::gen::timing {
namespace {

using Big = boost::multiprecision::cpp_int;

/// A decision in long double is trusted when it is further than this from equality; rounding stays below 1e-15 for up
/// to ten thousand terms. Nearer ones are decided in integers.
constexpr long double kGuard = 1e-12L;

struct BucketShare {
  Duration cost;
  Duration period = nanoseconds(1);
};

/// A sum of fractions over one growing common denominator; reduced only when asked.
class Fraction {
 public:
  void add(const BucketShare& s) {
    const Big period = s.period.ns();
    const Big factor = period / boost::multiprecision::gcd(denominator_, period);
    numerator_ *= factor;
    denominator_ *= factor;
    numerator_ += denominator_ / period * s.cost.ns();
    approximate_ += static_cast<long double>(s.cost.ns()) / static_cast<long double>(s.period.ns());
  }
  [[nodiscard]] const Big& numerator() const { return numerator_; }
  [[nodiscard]] const Big& denominator() const { return denominator_; }
  [[nodiscard]] long double approximate() const { return approximate_; }
  [[nodiscard]] std::string text() const {
    const Big divisor = boost::multiprecision::gcd(numerator_, denominator_);
    return Big(numerator_ / divisor).str() + "/" + Big(denominator_ / divisor).str();
  }

 private:
  Big numerator_ = 0, denominator_ = 1;
  long double approximate_ = 0;
};

std::vector<BucketShare> shares(const Model& model) {
  std::vector<BucketShare> list;
  for (const Bus& bus : model.buses) list.push_back({bus.wcet, std::min(bus.frame, model.tick)});
  for (const TaskBucket& bucket : make_task_set(model, Profile::paper).buckets) {
    list.push_back({bucket.cost, bucket.period});
  }
  return list;
}

bool liu_layland_holds(const Fraction& u, std::size_t n) {
  const long double distance = n * std::log1p(u.approximate() / n) - std::log(2.0L);
  if (std::fabs(distance) > kGuard) return distance < 0;
  const Big scaled = u.denominator() * n;
  const Big left = boost::multiprecision::pow(Big(scaled + u.numerator()), static_cast<unsigned>(n));
  return left <= 2 * boost::multiprecision::pow(scaled, static_cast<unsigned>(n));
}

bool hyperbolic_holds(const std::vector<BucketShare>& list) {
  long double distance = -std::log(2.0L);
  for (const BucketShare& s : list) {
    distance += std::log1p(static_cast<long double>(s.cost.ns()) / static_cast<long double>(s.period.ns()));
  }
  if (std::fabs(distance) > kGuard) return distance < 0;
  Big left = 1, right = 2;
  for (const BucketShare& s : list) {
    left *= Big(s.period.ns()) + s.cost.ns();
    right *= s.period.ns();
  }
  return left <= right;
}

/// One for each length after which budgets allow more: large robots have thousands of budgets, and few such lengths.
std::vector<BucketShare> shares_of_budgets(const Stream& stream) {
  std::map<Duration, Duration> cost_in;
  for (const Stream::Budget& b : stream.budgets) cost_in[b.period * b.every] += b.count * stream.cost;
  std::vector<BucketShare> list;
  for (const auto& [period, cost] : cost_in) list.push_back({cost, period});
  return list;
}

/// Adds the long-run rate of a stream: of its separation, or of its budgets where they are slower.
void add_rate(const Stream& stream, Fraction& total) {
  const std::vector<BucketShare> list = shares_of_budgets(stream);
  Fraction budgets;
  for (const BucketShare& share : list) budgets.add(share);
  const BucketShare separation{stream.cost, stream.separation};
  const bool slower =
      !list.empty() && budgets.numerator() * separation.period.ns() < budgets.denominator() * separation.cost.ns();
  if (!slower) return total.add(separation);
  for (const BucketShare& share : list) total.add(share);
}

}  // namespace

UtilizationTests test_utilization(const Model& model) {
  const std::vector<BucketShare> list = shares(model);
  Fraction total;
  for (const BucketShare& s : list) total.add(s);
  const std::size_t n = list.size();
  UtilizationTests result;
  result.utilization = {total.text(), static_cast<double>(total.approximate()),
                        total.numerator() > total.denominator()};
  result.liu_layland = {n, static_cast<double>(n) * std::expm1(std::log(2.0) / static_cast<double>(n)),
                        liu_layland_holds(total, n)};
  result.hyperbolic_ok = hyperbolic_holds(list);
  return result;
}

namespace {

/// Long-run load of the streams and of the buckets before one.
Fraction load_above(const TaskSet& set, std::size_t bucket) {
  Fraction total;
  for (const Stream& s : set.streams) add_rate(s, total);
  for (std::size_t w = 0; w < bucket; ++w) total.add({set.buckets[w].cost, set.buckets[w].period});
  return total;
}

/// Not less than that, quickly.
long double most_load_above(const TaskSet& set, std::size_t bucket) {
  const auto share = [](Duration cost, Duration period) {
    return static_cast<long double>(cost.ns()) / static_cast<long double>(period.ns());
  };
  long double load = 0;
  for (const Stream& s : set.streams) load += share(s.cost, s.separation);
  for (std::size_t w = 0; w < bucket; ++w) load += share(set.buckets[w].cost, set.buckets[w].period);
  return load;
}

/// More work than its rate says a stream makes at most, in any window.
Big burst_of(const Stream& stream) {
  Big arrivals = 1;  // as many as fit by separation, or by every budget, and one or its carried ones more
  for (const Stream::Budget& b : stream.budgets) arrivals += Big(b.count) * (b.carry_in + 1);
  return arrivals * stream.cost.ns();
}

}  // namespace

bool is_saturated(const TaskSet& set, std::size_t bucket) {
  if (most_load_above(set, bucket) < 1 - kGuard) return false;
  const Fraction total = load_above(set, bucket);
  if (total.approximate() < 1 - kGuard) return false;
  return total.numerator() >= total.denominator();
}

Duration closed_fixed_point(const TaskSet& set, std::size_t bucket, Duration base) {
  const Fraction load = load_above(set, bucket);
  const Big left = load.denominator() - load.numerator();
  if (left <= 0) return Duration::max();
  Big at_once = base.ns();
  for (const Stream& s : set.streams) at_once += burst_of(s);
  for (std::size_t w = 0; w < bucket; ++w) at_once += set.buckets[w].cost.ns();
  const Big x = at_once * load.denominator() / left + 1;
  return x < Duration::max().ns() ? nanoseconds(x.convert_to<std::int64_t>()) : Duration::max();
}

}  // namespace finemote::gen::timing
