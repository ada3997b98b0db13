#include "generator/timing/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "generator/diagnostic/suggest.hpp"
#include "generator/json/parse.hpp"
#include "generator/timing/case_file.hpp"
#include "generator/timing/check_cycles.hpp"
#include "generator/timing/model_words.hpp"
#include "generator/timing/object_reader.hpp"
#include "generator/units/clock_tolerance.hpp"

namespace finemote::gen::timing {
namespace {

using json::Value;

/// Reads by tables what stands in the model, and resolves names of devices when all are known.
class ModelReader {
 public:
  explicit ModelReader(Diagnostics& diagnostics) : values_(diagnostics) {}
  Model read(const Value& root);

 private:
  struct Tables;
  void read_bus(Model& model, const Value& v);
  void read_sources(Bus& bus, const Value& v);
  void read_source_name(InterruptSource& source, const Value& v) { source.name = values_.text(v, "a source", "name"); }
  void read_budget(InterruptSource& source, const Value& v);
  void read_devices(Model& model, const Value& v);
  void read_device(Model& model, const Value& v);
  void read_parent(Device& device, const Value& v);
  void read_observed(Device& device, const Value& v);
  void read_acquisition(Device& device, const Value& v);
  void read_transfer(Device& device, const Value& v);
  void read_undeclared(Device& device, const Value& v);
  void read_unknown_age(Device& device, const Value& v) {
    device.unknown_age = values_.one_of(v, "a device", "unknown_age", kUnknownAgeWords);
  }
  void read_transfer_bus(Transfer& transfer, const Value& v);
  void read_after(Transfer& transfer, const Value& v) {
    transfer.after = values_.one_of(v, "a transfer", "after", kAfterWords);
  }
  void read_cause(FrameBudget& budget, const Value& v) {
    budget.cause = values_.one_of(v, "a budget", "cause", kCauseWords);
  }
  void read_asked_in(FrameBudget& b, const Value& v) {
    b.asked_in = values_.one_of(v, "a budget", "asked_in", kAskedInWords);
  }
  void read_identifier(Transfer& transfer, const Value& v) {
    transfer.identifier = values_.integer(v, "identifier", 0);
  }
  void read_clock(Model& model, const Value& v);
  void read_costs(Model& model, const Value& v);
  void read_flush(Model& model, const Value& v);
  void read_flush_bus(Flush& flush, const Value& v);
  void read_flush_device(Flush& flush, const Value& v);
  void read_flush_identifier(Flush& flush, const Value& v) {
    flush.identifiers.push_back(values_.integer(v, "identifiers", 0));
  }
  void read_flush_output(Flush& flush, const Value& v) { flush.output = values_.text(v, "a flush", "output"); }
  void set_frame_time(Bus& bus, const Value& v);
  void check_period(const Device& device, const Value& v);
  void check_best_case(Duration bcet, Duration wcet, std::string_view key, const Value& v);

  template <class Id>
  std::string name(const Value& object, std::string_view what, std::map<std::string, Id>& names, Id id);
  std::optional<Rank> find_device(const std::string& device, const Value& where);
  std::optional<BusPlace> find_bus(const std::string& bus, const Value& where);

  [[nodiscard]] Rank last_device() const { return Rank{model_.devices.size() - 1}; }

  ObjectReader values_;
  Model model_;
  std::map<std::string, BusPlace> bus_names_;
  std::map<std::string, Rank> device_names_;
  std::vector<std::function<void()>> later_;  ///< references to devices, once all names are known
};

/// What may stand where (docs/timing.md), in the order it is read.
struct ModelReader::Tables {
  template <class Object>
  using Field = timing::Field<Object, ModelReader>;
  template <class Object>
  using Each = typename Field<Object>::Each;
  template <class Object>
  using Whole = typename Field<Object>::Whole;

  static constexpr Field<Model> kModel[] = {
      {"tick_ns", Need::required, &Model::tick, 1},
      {"buses", Need::optional, Each<Model>{&ModelReader::read_bus}},
      {"devices", Need::required, Whole<Model>{&ModelReader::read_devices}},
      {"clock_ppm", Need::target, Whole<Model>{&ModelReader::read_clock}},
      {"costs", Need::target, Whole<Model>{&ModelReader::read_costs}},
      {"flushes", Need::target, Each<Model>{&ModelReader::read_flush}},
  };
  static constexpr Field<Bus> kBus[] = {
      {"name"},
      {"baud_bps", Need::required, &Bus::baud_bps, 1},
      {"min_frame_bits", Need::required, &Bus::min_frame_bits, 1},
      {"wcet_ns", Need::required, &Bus::wcet},
      {"arbitrated", Need::target, &Bus::arbitrated},
      {"polled", Need::target, &Bus::polled},
      {"pins", Need::target, &Bus::is_pins},
      {"sources", Need::target, Whole<Bus>{&ModelReader::read_sources}},
  };
  static constexpr Field<InterruptSource> kSource[] = {
      {"name", Need::required, Whole<InterruptSource>{&ModelReader::read_source_name}},
      {"wcet_ns", Need::required, &InterruptSource::wcet},
      {"min_interval_ns", Need::required, &InterruptSource::min_interval, 1},
      {"budgets", Need::target, Each<InterruptSource>{&ModelReader::read_budget}},
      {"of_transfers", Need::target, &InterruptSource::of_transfers},
      {"ends_frame", Need::target, &InterruptSource::ends_frame},
      {"steals", Need::target, &InterruptSource::steals},
  };
  static constexpr Field<FrameBudget> kBudget[] = {
      {"device"},
      {"count", Need::required, &FrameBudget::count},
      {"every", Need::target, &FrameBudget::every, 1},
      {"interval_ns", Need::target, &FrameBudget::interval},
      {"carry_in", Need::target, &FrameBudget::carry_in, 1},
      {"cause", Need::target, Whole<FrameBudget>{&ModelReader::read_cause}},
      {"asked_in", Need::target, Whole<FrameBudget>{&ModelReader::read_asked_in}},
  };
  static constexpr Field<Device> kDevice[] = {
      {"name"},
      {"parent", Need::optional, Whole<Device>{&ModelReader::read_parent}},
      {"period_ns", Need::required, &Device::period, 1},
      {"update_wcet_ns", Need::required, &Device::update_wcet},
      {"handle_wcet_ns", Need::required, &Device::handle_wcet},
      {"update_bcet_ns", Need::target, &Device::update_bcet},
      {"handle_bcet_ns", Need::target, &Device::handle_bcet},
      {"update_extra_ns", Need::target, &Device::update_extra},
      {"handle_extra_ns", Need::target, &Device::handle_extra},
      {"output_ns", Need::target, &Device::output},
      {"sets_late", Need::target, &Device::sets_late},
      {"takes_command", Need::target, &Device::takes_command},
      {"unknown_age", Need::target, Whole<Device>{&ModelReader::read_unknown_age}},
      {"reads", Need::target, Each<Device>{&ModelReader::read_observed}},
      {"acquisition", Need::target, Whole<Device>{&ModelReader::read_acquisition}},
      {"transfers", Need::target, Each<Device>{&ModelReader::read_transfer}},
      {"undeclared", Need::target, Each<Device>{&ModelReader::read_undeclared}},
  };
  static constexpr Field<Acquisition> kAcquisition[] = {
      {"fixed_ns", Need::target, &Acquisition::fixed},
      {"interval_ns", Need::target, &Acquisition::interval},
      {"periods", Need::target, &Acquisition::periods},
      {"every", Need::target, &Acquisition::every, 1},
      {"begun_every", Need::target, &Acquisition::begun_every, 1},
      {"conversion_ns", Need::target, &Acquisition::conversion},
      {"conversions", Need::target, &Acquisition::conversions, 1},
      {"assumed", Need::target, &Acquisition::assumed},
  };
  static constexpr Field<Transfer> kTransfer[] = {
      {"bus", Need::required, Whole<Transfer>{&ModelReader::read_transfer_bus}},
      {"wire_ns", Need::required, &Transfer::wire},
      {"after", Need::target, Whole<Transfer>{&ModelReader::read_after}},
      {"min_interval_ns", Need::target, &Transfer::min_interval},
      {"interrupts", Need::target, &Transfer::interrupts},
      {"frames", Need::target, &Transfer::frames, 1},
      {"service_ns", Need::target, &Transfer::service},
      {"command", Need::target, &Transfer::command},
      {"slot", Need::target, &Transfer::slot},
      {"turns", Need::target, &Transfer::turns, 1},
      {"reads", Need::target, &Transfer::reads},
      {"receive", Need::target, &Transfer::receive},
      {"identifier", Need::target, Whole<Transfer>{&ModelReader::read_identifier}},
  };
  static constexpr Field<Costs> kCosts[] = {
      {"release_ns", Need::target, &Costs::release},
      {"release_per_bucket_ns", Need::target, &Costs::release_per_bucket},
      {"interrupt_ns", Need::target, &Costs::interrupt},
      {"job_ns", Need::target, &Costs::job},
      {"stage_ns", Need::target, &Costs::stage},
      {"masked_ns", Need::target, &Costs::masked},
      {"keeps_one_release", Need::target, &Costs::keeps_one_release},
      {"longest_release_ns", Need::target, &Costs::longest_release},
      {"event_entry_ns", Need::target, &Costs::event_entry},
      {"event_pause_ns", Need::target, &Costs::event_pause},
  };
  static constexpr Field<Flush> kFlush[] = {
      {"period_ns", Need::required, &Flush::period, 1},
      {"wcet_ns", Need::required, &Flush::wcet},
      {"bus", Need::target, Whole<Flush>{&ModelReader::read_flush_bus}},
      {"wire_ns", Need::target, &Flush::wire},
      {"interrupts", Need::target, &Flush::interrupts},
      {"service_ns", Need::target, &Flush::service},
      {"identifiers", Need::target, Each<Flush>{&ModelReader::read_flush_identifier}},
      {"devices", Need::target, Each<Flush>{&ModelReader::read_flush_device}},
      {"output", Need::target, Whole<Flush>{&ModelReader::read_flush_output}},
  };
};

Model ModelReader::read(const Value& root) {
  values_.read_fields(root, "the model", Tables::kModel, model_, *this);
  for (const auto& step : later_) step();
  model_.has_target = values_.saw_target();
  return std::move(model_);
}

/// The unique name of a bus or device, registered in `names` with its index.
template <class Id>
std::string ModelReader::name(const Value& object, std::string_view what, std::map<std::string, Id>& names, Id id) {
  std::string result = values_.member_text(object, what, "name");
  if (!result.empty() && !names.emplace(result, id).second) {
    values_.error(code::timing_name, *object.find("name"), fmt::format("{} '{}' is named twice", what, result));
  }
  return result;
}

void ModelReader::read_bus(Model& model, const Value& v) {
  const BusPlace place = model.buses.push_back({});
  Bus& bus = model.buses[place];
  if (!values_.is_object(v, "a bus")) return;
  bus.at = v.at;
  bus.name = name(v, "bus", bus_names_, place);
  values_.read_fields(v, "a bus", Tables::kBus, bus, *this);
  if (v.find("baud_bps") != nullptr && v.find("min_frame_bits") != nullptr) set_frame_time(bus, v);
}

void ModelReader::set_frame_time(Bus& bus, const Value& v) {
  const Value& bits = *v.find("min_frame_bits");
  try {
    bus.frame = floor_div(bus.min_frame_bits * seconds(1), bus.baud_bps);
  } catch (const Overflow&) {
    return void(values_.error(code::timing_overflow, bits, "the frame time does not fit signed 64 bits"));
  }
  if (bus.frame >= nanoseconds(1)) return;
  bus.frame = nanoseconds(1);
  values_.error(code::timing_frame_time, bits, fmt::format("the frame time of bus '{}' is below 1 ns", bus.name))
      .note(fmt::format("{} bits at {} bit/s", bus.min_frame_bits, bus.baud_bps));
}

void ModelReader::read_sources(Bus& bus, const Value& v) {
  if (!values_.is_array(v, "sources")) return;
  bus.sources.emplace();
  for (const Value& item : v.items) {
    InterruptSource& source = bus.sources->emplace_back();
    if (values_.is_object(item, "a source")) values_.read_fields(item, "a source", Tables::kSource, source, *this);
  }
}

void ModelReader::read_budget(InterruptSource&, const Value& v) {
  if (!values_.is_object(v, "a budget")) return;
  FrameBudget budget;
  const std::string device = values_.member_text(v, "a budget", "device");
  values_.read_fields(v, "a budget", Tables::kBudget, budget, *this);
  if (device.empty()) return;
  const BusPlace bus{model_.buses.size() - 1};
  const std::size_t source = model_.buses.back().sources->size() - 1;
  later_.emplace_back([this, bus, source, budget, device, where = v.find("device")]() mutable {
    const auto found = find_device(device, *where);
    if (!found) return;
    budget.device = *found;
    (*model_.buses[bus].sources)[source].budgets.push_back(budget);
  });
}

void ModelReader::read_devices(Model& model, const Value& v) {
  const bool is_list = values_.is_array(v, "devices");
  if (is_list && v.items.empty()) values_.error(code::timing_no_device, v, "the model has no device");
  for (const Value& item : v.items) read_device(model, item);
}

void ModelReader::read_device(Model& model, const Value& v) {
  const Rank rank = model.devices.push_back({});
  Device& device = model.devices[rank];
  if (!values_.is_object(v, "a device")) return;
  device.at = v.at;
  device.name = name(v, "device", device_names_, rank);
  values_.read_fields(v, "a device", Tables::kDevice, device, *this);
  check_period(device, v);
  check_best_case(device.update_bcet, device.update_wcet, "update_bcet_ns", v);
  check_best_case(device.handle_bcet, device.handle_wcet, "handle_bcet_ns", v);
}

void ModelReader::check_period(const Device& device, const Value& v) {
  const Value* period = v.find("period_ns");
  const Duration tick = model_.tick, below = round_down(device.period, tick);
  if (period == nullptr || below == device.period || period->text != std::to_string(device.period.ns())) return;
  const bool has_above = device.period <= Duration::max() - tick;
  values_
      .error(code::timing_period, *period,
             fmt::format("the period of device '{}' is not a multiple of the tick of {} ns", device.name, tick.ns()))
      .hint(fmt::format("write {} or {}", std::max(below, tick).ns(), (has_above ? below + tick : below).ns()));
}

void ModelReader::check_best_case(Duration bcet, Duration wcet, std::string_view key, const Value& v) {
  if (bcet > wcet)
    values_.error(code::json_number_range, *v.find(key), fmt::format("'{}' is above the worst case", key));
}

void ModelReader::read_parent(Device&, const Value& v) {
  if (v.is(Value::Kind::null)) return;
  if (!v.is(Value::Kind::string))
    return void(
        values_.error(code::json_type, v, fmt::format("'parent' is {}, not a string or null", describe(v.kind))));
  later_.emplace_back([this, rank = last_device(), &v] {
    const auto found = find_device(v.text, v);
    if (!found) return;
    Device& device = model_.devices[rank];
    if (*found > rank) {
      device.parent = *found;
    } else if (*found == rank) {
      values_.error(code::timing_parent, v, fmt::format("device '{}' is its own parent", device.name));
    } else {
      values_
          .error(code::timing_parent, v,
                 fmt::format("parent '{}' of device '{}' is registered before it", v.text, device.name))
          .hint("list every child before its parent");
    }
  });
}

std::optional<Rank> ModelReader::find_device(const std::string& device, const Value& where) {
  if (const auto found = device_names_.find(device); found != device_names_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, index] : device_names_) names.push_back(known);
  auto& d = values_.error(code::timing_parent, where, fmt::format("there is no device '{}'", device));
  if (names.size() <= 1000) suggest(d, device, names);
  return std::nullopt;
}

std::optional<BusPlace> ModelReader::find_bus(const std::string& bus, const Value& where) {
  if (const auto found = bus_names_.find(bus); found != bus_names_.end()) return found->second;
  if (!bus.empty()) values_.error(code::timing_parent, where, fmt::format("there is no bus '{}'", bus));
  return std::nullopt;
}

void ModelReader::read_observed(Device&, const Value& v) {
  if (values_.text(v, "a device", "reads").empty()) return;
  later_.emplace_back([this, rank = last_device(), &v] {
    if (const auto found = find_device(v.text, v)) model_.devices[rank].reads.push_back(*found);
  });
}

void ModelReader::read_acquisition(Device& device, const Value& v) {
  if (values_.is_object(v, "'acquisition'"))
    values_.read_fields(v, "an acquisition", Tables::kAcquisition, device.acquisition.emplace(), *this);
}

void ModelReader::read_undeclared(Device& device, const Value& v) {
  if (const auto bus = find_bus(values_.text(v, "a device", "undeclared"), v)) device.undeclared.push_back(*bus);
}

void ModelReader::read_transfer(Device& device, const Value& v) {
  if (values_.is_object(v, "a transfer"))
    values_.read_fields(v, "a transfer", Tables::kTransfer, device.transfers.emplace_back(), *this);
}

void ModelReader::read_transfer_bus(Transfer& transfer, const Value& v) {
  if (const auto found = find_bus(values_.text(v, "a transfer", "bus"), v)) transfer.bus = *found;
}

void ModelReader::read_clock(Model& model, const Value& v) {
  const std::int64_t ppm = values_.integer(v, "clock_ppm", 0);
  model.clock_ppm = ppm <= kMillion / 2 ? ppm : 0;
  if (ppm > model.clock_ppm) values_.error(code::json_number_range, v, "'clock_ppm' is above 500000");
}

void ModelReader::read_costs(Model& model, const Value& v) {
  if (values_.is_object(v, "'costs'")) values_.read_fields(v, "'costs'", Tables::kCosts, model.costs, *this);
}

void ModelReader::read_flush(Model& model, const Value& v) {
  if (!values_.is_object(v, "a flush")) return;
  Flush& flush = model.flushes.emplace_back();
  values_.read_fields(v, "a flush", Tables::kFlush, flush, *this);
  const bool is_known = std::any_of(model.devices.begin(), model.devices.end(),
                                    [&](const Device& d) { return d.period == flush.period; });
  if (!is_known) values_.error(code::timing_period, v, "no device has the period of this flush");
}

void ModelReader::read_flush_bus(Flush& flush, const Value& v) {
  flush.bus = find_bus(values_.text(v, "a flush", "bus"), v);
}

void ModelReader::read_flush_device(Flush&, const Value& v) {
  later_.emplace_back([this, index = model_.flushes.size() - 1, &v] {
    if (const auto found = find_device(v.text, v)) model_.flushes[index].devices.push_back(*found);
  });
}

}  // namespace

std::optional<Model> read_model(const SourceFile& file, Diagnostics& diagnostics) {
  const std::optional<Value> root = json::parse(file, diagnostics);
  if (!root) return std::nullopt;
  const Value* object = model_object(*root, diagnostics);
  if (object == nullptr) return std::nullopt;
  Model model = ModelReader(diagnostics).read(*object);
  if (!diagnostics.has_errors()) check_cycles(model, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : std::optional<Model>(std::move(model));
}

}  // namespace finemote::gen::timing
