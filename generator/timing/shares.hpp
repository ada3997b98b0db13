// Who asks for the time of a bus, and which devices and buses a chain passes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/timing/chains.hpp"

namespace finemote::gen::timing {

/// Somebody's part of a load.
struct Share {
  std::string who;  ///< `'imu'`, `'thruster_1' and 7 more`
  double load = 0;
  bool autonomous = false;  ///< sent by the part itself, not by its device
};

/// Adds to the share of that name, or a new one.
void add_share(std::vector<Share>& shares, const std::string& who, double load, bool autonomous);

/// Who asks for the time of a bus (of its busier line), largest first.
std::vector<Share> bus_shares(const Model& model, BusPlace bus);

/// Devices that use the bus because they are due: longer periods of theirs make it less busy. Registration order.
std::vector<Rank> periodic_users(const Model& model, BusPlace bus);

/// All devices that use the bus, parts that send by themselves included. Registration order.
std::vector<Rank> bus_users(const Model& model, BusPlace bus);

/// The bus the command of a device goes over; none where its output is a pin of the chip.
std::optional<BusPlace> command_bus(const Model& model, Rank to);

/// The bus the samples of a device come over; none where there is none.
std::optional<BusPlace> sample_bus(const Model& model, Rank from);

/// That devices do not say what they send over the bus, for people; empty: all do.
std::string undeclared_text(const Model& model, BusPlace bus);

/// The devices from both ends of a chain to their roots, ends included.
std::vector<Rank> devices_between(const Model& model, const ChainResult& chain);

/// `'imu' by itself: 118.7 %, 'depth': 3.0 %`
std::string shares_text(const std::vector<Share>& shares);

}  // namespace finemote::gen::timing
