// The analysis once more, written from its definitions: slow, without any of the product's algorithms, and able to make
// the classic mistakes on demand.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "generator/timing/result.hpp"

namespace finemote::gen::timing {

using Ns = std::int64_t;  ///< whole nanoseconds

struct Mistakes {
  bool truncating_division = false;  ///< `/` instead of floor
  bool literal_zero_rule = false;    ///< least fixed point of an empty stage taken as it stands
  bool ceiled_frame_times = false;
};

class Reference {
 public:
  Reference(const Model& model, bool tight, Mistakes mistakes = {}) : m_(model), tight_(tight), mistakes_(mistakes) {
    for (const Device& d : m_.devices) periods_.insert(d.period.ns());
    for (const Bus& b : m_.buses) {
      const Ns bits = b.min_frame_bits * 1'000'000'000;
      const Ns frame = mistakes.ceiled_frame_times ? (bits + b.baud_bps - 1) / b.baud_bps : bits / b.baud_bps;
      streams_.push_back({tight ? frame : std::min(frame, m_.tick.ns()), b.wcet.ns()});
    }
    for (const Ns t : periods_) {
      Ns cost = 0;
      for (const Device& d : m_.devices) cost += d.period.ns() == t ? d.update_wcet.ns() + d.handle_wcet.ns() : 0;
      cost_[t] = cost;
    }
    for (const Ns t : periods_) ok_[t] = bucket_ok(t);
  }

  [[nodiscard]] bool ok(Rank d) const { return ok_.at(m_.devices[d].period.ns()); }

  [[nodiscard]] std::optional<Ns> r(Rank d, bool handle) const { return ok(d) ? general(d, handle) : std::nullopt; }

  /// R of one release (profile tight), capped by the general bound.
  Ns r_at(Rank d, bool handle, Ns t) {
    const auto key = std::make_tuple(d, handle, t - fl(t, repeat(d)) * repeat(d));
    if (const auto known = responses_.find(key); known != responses_.end()) return known->second;
    const Ns cap = *general(d, handle);
    if (!tight_) return cap;
    const Ns b = base(d, handle), e = extra(d, handle), period = m_.devices[d].period.ns();
    Ns worst = from_start(b, e, t, t, period);
    for (const Ns urgent : periods_) {
      if (urgent >= period || cost_[urgent] == 0) continue;
      for (Ns t0 = fl(t - 1, urgent) * urgent; t - t0 <= 2000; t0 -= urgent) {
        if (busy_beyond(t0, t, period)) worst = std::max(worst, from_start(b, e, t0, t, period));
      }
    }
    return responses_[key] = std::min(worst, cap);
  }

  Ns window_at(Rank d, Ns t) {
    const Device& device = m_.devices[d];
    const Ns e = extra(d, true), response = r_at(d, true, t);
    Ns w = 0;
    for (const Rank o : m_.devices.ids()) {
      if (o >= d && m_.devices[o].period.ns() == device.period.ns())
        w += m_.devices[o].update_wcet.ns() + m_.devices[o].handle_wcet.ns();
    }
    for (Ns x = w + e;;) {
      Ns need = w + e;
      for (const auto& [p, c] : streams_) need += (x + p - 1) / p * c;
      for (const Ns u : periods_) {
        if (u >= device.period.ns()) continue;
        const Ns k = fl(t + response - 1 + e, u) - fl(t, u);
        need += std::min((x + u - 1) / u, k) * cost_[u];
      }
      if (need <= x) return std::min(x - e, response);
      x = need;
    }
  }

  std::optional<Ns> window(Rank d) {
    if (!ok(d)) return std::nullopt;
    Ns worst = 0;
    for (Ns t = 0; t < repeat(d); t += m_.devices[d].period.ns()) worst = std::max(worst, window_at(d, t));
    return worst;
  }

  struct Path {
    Ns value = -1, release = 0, source = 0;
  };

  /// Terminal at `to`, source at `from`, turning at the root; nothing when a bucket on the way is not ok.
  std::optional<Path> path(Rank from, Rank to) {
    const std::vector<Rank> down = to_root(to), up = to_root(from);
    Ns common = 1;
    for (const auto& way : {down, up}) {
      for (std::size_t i = 0; i < way.size(); ++i) {
        if (!ok(way[i])) return std::nullopt;
        common = std::lcm(common, m_.devices[way[i]].period.ns());
        if (tight_) common = std::lcm(common, repeat(way[i]));
      }
    }
    Path worst;
    for (Ns t = 0; t < common; t += m_.devices[to].period.ns()) {
      Ns x = t;
      for (std::size_t i = 1; i < down.size(); ++i) x = back(x, down[i], down[i - 1], true);
      for (std::size_t i = up.size() - 1; i-- > 0;) x = back(x, up[i], up[i + 1], false);
      Ns value = t + r_at(to, true, t) - x;
      if (tight_ && from == to && x == t) value = std::min(value, window_at(to, t));
      if (value > worst.value) worst = {value, t, x};
    }
    return worst;
  }

 private:
  [[nodiscard]] Ns fl(Ns a, Ns b) const {
    if (mistakes_.truncating_division) return a / b;
    return a >= 0 ? a / b : -((-a + b - 1) / b);
  }

  [[nodiscard]] Ns base(Rank d, bool handle) const {
    Ns sum = 0;
    for (const Rank o : m_.devices.ids()) {
      if (m_.devices[o].period.ns() != m_.devices[d].period.ns()) continue;
      if (handle || o <= d) sum += m_.devices[o].update_wcet.ns();
      if (handle && o >= d) sum += m_.devices[o].handle_wcet.ns();
    }
    return sum;
  }

  [[nodiscard]] Ns extra(Rank d, bool handle) const {
    if (mistakes_.literal_zero_rule) return 0;
    return (handle ? m_.devices[d].handle_wcet.ns() : m_.devices[d].update_wcet.ns()) == 0 ? 1 : 0;
  }

  [[nodiscard]] std::optional<Ns> general(Rank d, bool handle) const {
    const Ns period = m_.devices[d].period.ns(), e = extra(d, handle), b = base(d, handle) + e;
    for (Ns x = b;;) {
      if (x - e > period) return std::nullopt;
      Ns need = b;
      for (const auto& [p, c] : streams_) need += (x + p - 1) / p * c;
      for (const auto& [u, c] : cost_) need += u < period ? (x + u - 1) / u * c : 0;
      if (need == x) return x - e;
      x = need;
    }
  }

  [[nodiscard]] bool bucket_ok(Ns period) const {
    for (const Rank d : m_.devices.ids()) {
      if (m_.devices[d].period.ns() == period) return general(d, true).has_value();
    }
    return false;
  }

  [[nodiscard]] Ns rel(Ns a, Ns b, Ns t) const { return fl(b - 1, t) - fl(a - 1, t); }

  Ns more_urgent(Ns t0, Ns x, Ns period) {
    Ns work = 0;
    for (const auto& [p, c] : streams_) work += (x + p - 1) / p * c;
    for (const auto& [u, c] : cost_) work += u < period ? rel(t0, t0 + x, u) * c : 0;
    return work;
  }

  bool busy_beyond(Ns t0, Ns t, Ns period) {
    for (Ns x = 1; x <= t - t0; ++x) {
      if (more_urgent(t0, x, period) <= x) return false;
    }
    return true;
  }

  Ns from_start(Ns b, Ns e, Ns t0, Ns t, Ns period) {
    for (Ns x = std::max(t - t0 + 1, b + e);; ++x) {
      if (b + e + more_urgent(t0, x, period) <= x) return x - e - (t - t0);
      if (x > 100'000) return x;
    }
  }

  /// All releases of the device's bucket look alike again after this.
  [[nodiscard]] Ns repeat(Rank d) const {
    Ns common = 1;
    for (const Ns t : periods_) common = t <= m_.devices[d].period.ns() ? std::lcm(common, t) : common;
    return common;
  }

  [[nodiscard]] std::vector<Rank> to_root(Rank d) const {
    std::vector<Rank> way{d};
    while (m_.devices[way.back()].parent) way.push_back(*m_.devices[way.back()].parent);
    return way;
  }

  Ns back(Ns x, Rank producer, Rank consumer, bool handle) {
    const Ns period = m_.devices[producer].period.ns();
    const bool slower = period > m_.devices[consumer].period.ns();
    if (!tight_) return fl(x - (slower ? *general(producer, handle) : 0), period) * period;
    const Ns q = fl(x, period) * period;
    return slower && q + r_at(producer, handle, q) > x ? q - period : q;
  }

  const Model& m_;
  bool tight_;
  Mistakes mistakes_;
  std::set<Ns> periods_;
  std::vector<std::pair<Ns, Ns>> streams_;
  std::map<Ns, Ns> cost_;
  std::map<Ns, bool> ok_;
  std::map<std::tuple<Rank, bool, Ns>, Ns> responses_;
};

}  // namespace finemote::gen::timing
