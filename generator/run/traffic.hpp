// Holds what buses carried in a run against what the devices on them declare, which the bounds are made from.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/measured.hpp"
#include "generator/tasks/robot_buses.hpp"

namespace finemote::gen {

/// Something that was seen, and the most that is declared; none: nothing bounds it.
template <class Amount>
struct Declared {
  Amount seen = {};
  std::optional<Amount> most = std::nullopt;

  [[nodiscard]] Judgement judged() const {
    if (!most) return Judgement::no_bound;
    return seen > *most ? Judgement::broken : Judgement::held;
  }
};

/// Adds another run: what it shows counts where it is above what is declared, and nothing was so far.
template <class Of>
void merge_judged(std::vector<Of>& all, const std::vector<Of>& more) {
  for (std::size_t i = 0; i < all.size() && i < more.size(); ++i) {
    if (all[i].judged() != Judgement::broken && more[i].judged() == Judgement::broken) all[i] = more[i];
  }
}

/// A transfer of I2C that moved more bytes than any that the devices of its address declare.
struct LongTransfer {
  DeviceId device;
  Declared<std::int64_t> bytes;
};

struct MeasuredTraffic {
  BusId bus;
  Duration window;                             ///< for so long it was looked at
  Declared<Duration> sent;                     ///< how long its wire was in use; of two lines that the board sends on
  std::optional<Declared<Duration>> received;  ///< of two lines that it receives on
  Declared<std::int64_t> interrupts;           ///< runs of its service routines
  std::vector<LongTransfer> too_long = {};

  /// `broken` where anything is above what is declared, else `held` where anything is declared.
  [[nodiscard]] Judgement judged() const;
};

/// Of one run on the emulated board: the buses that carry bits.
std::vector<MeasuredTraffic> measure_traffic(const Robot& robot, const timing::Model& model, const RunRecord& record);

/// That of a bus; null: nobody looked at it.
const MeasuredTraffic* find_traffic(const std::vector<MeasuredTraffic>& all, BusId bus);

/// Reports FM6015 for every bus on which more happens than is declared: its bounds are made from less.
/// @return  whether there is none
bool check_traffic(const Robot& robot, const std::vector<MeasuredTraffic>& traffic, Diagnostics& diagnostics);

}  // namespace finemote::gen
