#include "emulator/program/traffic_count.hpp"

#include <utility>

namespace finemote::emulator {

using Json = nlohmann::ordered_json;

namespace {

/// `[address, data bytes]` of every kind of transfer that came in between.
Json new_lengths(const BusStatistics& now, const BusStatistics& before) {
  Json lengths = Json::array();
  for (const auto& [kind, count] : now.lengths) {
    const auto earlier = before.lengths.find(kind);
    if (earlier == before.lengths.end() || earlier->second != count) lengths.push_back({kind.first, kind.second});
  }
  return lengths;
}

}  // namespace

TrafficCount::TrafficCount(Board& board, std::vector<std::string> ports)
    : board_(board),
      ports_(std::move(ports)),
      begin_ns_(board.now_ns()),
      before_(of_ports()),
      exceptions_before_(board.own_times().exceptions()) {}

std::vector<BusStatistics> TrafficCount::of_ports() const {
  std::vector<BusStatistics> all;
  for (const std::string& port : ports_) all.push_back(board_.bus(port));
  return all;
}

Json TrafficCount::document() const {
  Json ports = Json::array(), exceptions = Json::array();
  const std::vector<BusStatistics> now = of_ports();
  for (std::size_t i = 0; i < now.size(); ++i)
    ports.push_back({to_ns(now[i].busy - before_[i].busy), to_ns(now[i].received - before_[i].received),
                     new_lengths(now[i], before_[i])});
  for (const auto& [number, own] : board_.own_times().exceptions()) {
    const auto before = exceptions_before_.find(number);
    exceptions.push_back({number, own.runs - (before == exceptions_before_.end() ? 0 : before->second.runs)});
  }
  return {{"ns", board_.now_ns() - begin_ns_}, {"ports", std::move(ports)}, {"exceptions", std::move(exceptions)}};
}

}  // namespace finemote::emulator
