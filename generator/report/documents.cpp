#include "generator/report/documents.hpp"

namespace finemote::gen::report {

Place Documents::of_verdict() const { return of_timing()[of_timing()["profile"].text()]; }

Measurements::Measurements(const Documents& documents)
    : chains_(documents.of_run()["chains"]),
      responses_(documents.of_run()["responses"]),
      stages_(documents.of_run()["stages"]),
      nothing_(documents.of_run()["none"]),
      chain_at_(places_of(chains_, "from", "to")),
      response_at_(places_of(responses_, "device", "")),
      stage_at_(places_of(stages_, "device", "stage")) {}

Measurements::Places Measurements::places_of(const Place& list, const char* first, const char* second) {
  Places places;
  for (std::size_t i = 0; i < list.size(); ++i) places.emplace(Key{list[i][first].text(), list[i][second].text()}, i);
  return places;
}

Place Measurements::found(const Place& list, const Places& places, const Key& key) const {
  const auto at = places.find(key);
  return at == places.end() ? nothing_ : list[at->second];
}

Place Measurements::chain(const std::string& from, const std::string& to) const {
  return found(chains_, chain_at_, {from, to});
}

Place Measurements::response(const std::string& device) const { return found(responses_, response_at_, {device, ""}); }

Place Measurements::stage(const std::string& device, const std::string& stage) const {
  return found(stages_, stage_at_, {device, stage});
}

}  // namespace finemote::gen::report
