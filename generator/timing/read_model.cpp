#include "generator/timing/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>

#include "generator/diagnostic/suggest.hpp"
#include "generator/json/parse.hpp"

namespace finemote::gen::timing {
namespace {

using json::Value;
constexpr Ns kMax = std::numeric_limits<Ns>::max();

class Reader {
 public:
  Reader(const Value& root, Diagnostics& diagnostics) : root_(root), diagnostics_(diagnostics) {}

  Model read() {
    check_members(root_, "the model", {"tick_ns", "buses", "devices", "costs", "flushes"});
    model_.tick_ns = required(root_, "the model", "tick_ns", 1);
    if (const Value* buses = optional_array(root_, "buses")) {
      for (const Value& bus : buses->items) read_bus(bus);
    }
    read_devices();
    read_costs();
    read_flushes();
    resolve_later();
    return std::move(model_);
  }

 private:
  Diagnostic& error(Code code, const Value& where, std::string message) {
    return diagnostics_.error(code, where.at, std::move(message)).underline(where.length);
  }

  bool check_object(const Value& v, std::string_view what) {
    if (v.is(Value::Kind::object)) return true;
    error(code::json_type, v, fmt::format("{} is {}, not an object", what, describe(v.kind)));
    return false;
  }

  void check_members(const Value& object, std::string_view what, const std::vector<std::string>& known) {
    for (const json::Member& m : object.members) {
      if (std::find(known.begin(), known.end(), m.key) != known.end()) continue;
      auto& d = diagnostics_.error(code::json_unknown_member, m.at, fmt::format("{} has no member '{}'", what, m.key));
      d.underline(m.key.size() + 2);
      if (const auto hint = did_you_mean(m.key, known); !hint.empty()) d.hint(hint);
    }
  }

  const Value* optional_array(const Value& object, std::string_view key) {
    const Value* v = object.find(key);
    if (v == nullptr) return nullptr;
    model_.has_target |= key != "buses" && key != "devices";
    if (v->is(Value::Kind::array)) return v;
    error(code::json_type, *v, fmt::format("'{}' is {}, not an array", key, describe(v->kind)));
    return nullptr;
  }

  Ns integer(const Value& v, std::string_view key, Ns least) {
    if (!v.is(Value::Kind::number)) {
      error(code::json_type, v, fmt::format("'{}' is {}, not an integer", key, describe(v.kind)));
      return least;
    }
    Ns number = 0;
    const char* end = v.text.data() + v.text.size();
    const auto [rest, status] = std::from_chars(v.text.data(), end, number);
    if (status == std::errc::result_out_of_range || (rest == end && number < least)) {
      error(code::json_number_range, v, fmt::format("'{}' is {}, outside {} to {}", key, v.text, least, kMax));
      return least;
    }
    if (rest != end) {
      error(code::json_type, v, fmt::format("'{}' is {}, not an integer", key, v.text))
          .hint("write it without fraction and exponent");
      return least;
    }
    return number;
  }

  Ns required(const Value& object, std::string_view what, std::string_view key, Ns least) {
    const Value* v = object.find(key);
    if (v != nullptr) return integer(*v, key, least);
    error(code::json_missing_member, object, fmt::format("{} has no '{}'", what, key));
    return least;
  }

  /// A member only profile `target` knows.
  Ns extension(const Value& object, std::string_view key, Ns fallback = 0, Ns least = 0) {
    const Value* v = object.find(key);
    if (v == nullptr) return fallback;
    model_.has_target = true;
    return integer(*v, key, least);
  }

  bool flag(const Value& object, std::string_view key, bool fallback) {
    const Value* v = object.find(key);
    if (v == nullptr) return fallback;
    model_.has_target = true;
    if (!v->is(Value::Kind::boolean)) {
      error(code::json_type, *v, fmt::format("'{}' is {}, not true or false", key, describe(v->kind)));
    }
    return v->truth;
  }

  std::string text(const Value& object, std::string_view what, std::string_view key) {
    const Value* v = object.find(key);
    if (v == nullptr) {
      error(code::json_missing_member, object, fmt::format("{} has no '{}'", what, key));
    } else if (!v->is(Value::Kind::string)) {
      error(code::json_type, *v, fmt::format("'{}' is {}, not a string", key, describe(v->kind)));
    } else if (v->text.empty()) {
      error(code::timing_name, *v, fmt::format("'{}' of {} is empty", key, what));
    } else {
      return v->text;
    }
    return {};
  }

  /// The unique name of a bus or device, registered in `names` with its index.
  std::string name(const Value& object, std::string_view what, std::map<std::string, std::size_t>& names,
                   std::size_t index) {
    std::string result = text(object, what, "name");
    if (!result.empty() && !names.emplace(result, index).second) {
      error(code::timing_name, *object.find("name"), fmt::format("{} '{}' is named twice", what, result));
    }
    return result;
  }

  void read_bus(const Value& v) {
    const std::size_t index = model_.buses.size();
    Bus& bus = model_.buses.emplace_back();
    if (!check_object(v, "a bus")) return;
    check_members(v, "a bus", {"name", "baud_bps", "min_frame_bits", "wcet_ns", "arbitrated", "sources"});
    bus.at = v.at;
    bus.name = name(v, "bus", bus_names_, index);
    bus.baud_bps = required(v, "a bus", "baud_bps", 1);
    bus.min_frame_bits = required(v, "a bus", "min_frame_bits", 1);
    bus.wcet_ns = required(v, "a bus", "wcet_ns", 0);
    bus.arbitrated = flag(v, "arbitrated", false);
    if (v.find("baud_bps") != nullptr && v.find("min_frame_bits") != nullptr) set_frame_time(bus, v);
    if (const Value* sources = optional_array(v, "sources")) {
      bus.sources.emplace();
      for (const Value& s : sources->items) read_source(index, s);
    }
  }

  void set_frame_time(Bus& bus, const Value& v) {
    try {
      bus.frame_ns = multiply(bus.min_frame_bits, 1'000'000'000) / bus.baud_bps;
    } catch (const Overflow&) {
      error(code::timing_overflow, *v.find("min_frame_bits"), "the frame time does not fit signed 64 bits");
      return;
    }
    if (bus.frame_ns >= 1) return;
    bus.frame_ns = 1;
    error(code::timing_frame_time, *v.find("min_frame_bits"),
          fmt::format("the frame time of bus '{}' is below 1 ns", bus.name))
        .note(fmt::format("{} bits at {} bit/s", bus.min_frame_bits, bus.baud_bps));
  }

  void read_source(std::size_t bus, const Value& v) {
    InterruptSource source;
    if (!check_object(v, "a source")) return;
    check_members(v, "a source", {"name", "wcet_ns", "min_interval_ns", "budgets"});
    source.name = text(v, "a source", "name");
    source.wcet_ns = required(v, "a source", "wcet_ns", 0);
    source.min_interval_ns = required(v, "a source", "min_interval_ns", 1);
    const std::size_t index = model_.buses[bus].sources->size();
    if (const Value* budgets = optional_array(v, "budgets")) {
      for (const Value& b : budgets->items) read_budget(bus, index, b);
    }
    model_.buses[bus].sources->push_back(std::move(source));
  }

  void read_budget(std::size_t bus, std::size_t source, const Value& v) {
    if (!check_object(v, "a budget")) return;
    check_members(v, "a budget", {"device", "count", "every"});
    const std::string device = text(v, "a budget", "device");
    const Ns count = required(v, "a budget", "count", 0);
    const Ns every = v.find("every") != nullptr ? required(v, "a budget", "every", 1) : 1;
    const Value* where = v.find("device");
    if (device.empty()) return;
    later_.emplace_back([this, bus, source, device, count, every, where] {
      if (const auto d = find_device(device, *where)) {
        (*model_.buses[bus].sources)[source].budgets.push_back({*d, count, every});
      }
    });
  }

  void read_devices() {
    const Value* list = root_.find("devices");
    if (list == nullptr) {
      error(code::json_missing_member, root_, "the model has no 'devices'");
      return;
    }
    if (!list->is(Value::Kind::array)) {
      error(code::json_type, *list, fmt::format("'devices' is {}, not an array", describe(list->kind)));
    } else if (list->items.empty()) {
      error(code::timing_no_device, *list, "the model has no device");
    }
    for (const Value& v : list->items) read_device(v);
  }

  void read_device(const Value& v) {
    const std::size_t index = model_.devices.size();
    model_.devices.emplace_back();
    if (!check_object(v, "a device")) return;
    check_members(
        v, "a device",
        {"name", "parent", "period_ns", "update_wcet_ns", "handle_wcet_ns", "update_bcet_ns", "handle_bcet_ns",
         "update_extra_ns", "handle_extra_ns", "output_ns", "takes_command", "reads", "acquisition", "transfers"});
    Device& d = model_.devices[index];
    d.at = v.at;
    d.name = name(v, "device", device_names_, index);
    d.period_ns = required(v, "a device", "period_ns", 1);
    d.update_wcet_ns = required(v, "a device", "update_wcet_ns", 0);
    d.handle_wcet_ns = required(v, "a device", "handle_wcet_ns", 0);
    check_period(d, v);
    read_parent(index, v);
    read_extensions(index, v);
  }

  void check_period(const Device& d, const Value& v) {
    const Value* period = v.find("period_ns");
    if (period == nullptr || d.period_ns % model_.tick_ns == 0 || period->text != std::to_string(d.period_ns)) return;
    error(code::timing_period, *period,
          fmt::format("the period of device '{}' is not a multiple of the tick of {} ns", d.name, model_.tick_ns))
        .hint(fmt::format("write {} or {}", std::max(d.period_ns - d.period_ns % model_.tick_ns, model_.tick_ns),
                          d.period_ns > kMax - model_.tick_ns
                              ? d.period_ns - d.period_ns % model_.tick_ns
                              : d.period_ns - d.period_ns % model_.tick_ns + model_.tick_ns));
  }

  void read_parent(std::size_t index, const Value& v) {
    const Value* parent = v.find("parent");
    if (parent == nullptr || parent->is(Value::Kind::null)) return;
    if (!parent->is(Value::Kind::string)) {
      error(code::json_type, *parent, fmt::format("'parent' is {}, not a string or null", describe(parent->kind)));
      return;
    }
    later_.emplace_back([this, index, parent] {
      const auto found = find_device(parent->text, *parent);
      if (!found) return;
      Device& d = model_.devices[index];
      if (*found > index) {
        d.parent = *found;
      } else if (*found == index) {
        error(code::timing_parent, *parent, fmt::format("device '{}' is its own parent", d.name));
      } else {
        error(code::timing_parent, *parent,
              fmt::format("parent '{}' of device '{}' is registered before it", parent->text, d.name))
            .hint("list every child before its parent");
      }
    });
  }

  std::optional<std::size_t> find_device(const std::string& device, const Value& where) {
    const auto found = device_names_.find(device);
    if (found != device_names_.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, index] : device_names_) names.push_back(known);
    auto& d = error(code::timing_parent, where, fmt::format("there is no device '{}'", device));
    const std::string hint = names.size() <= 1000 ? did_you_mean(device, names) : "";
    if (!hint.empty()) d.hint(hint);
    return std::nullopt;
  }

  void read_extensions(std::size_t index, const Value& v) {
    Device& d = model_.devices[index];
    d.update_bcet_ns = extension(v, "update_bcet_ns");
    d.handle_bcet_ns = extension(v, "handle_bcet_ns");
    check_best_case(d.update_bcet_ns, d.update_wcet_ns, "update_bcet_ns", v);
    check_best_case(d.handle_bcet_ns, d.handle_wcet_ns, "handle_bcet_ns", v);
    d.update_extra_ns = extension(v, "update_extra_ns");
    d.handle_extra_ns = extension(v, "handle_extra_ns");
    d.output_ns = extension(v, "output_ns");
    d.takes_command = flag(v, "takes_command", true);
    if (const Value* reads = optional_array(v, "reads")) {
      for (const Value& r : reads->items) read_observed(index, r);
    }
    read_acquisition(d, v);
    if (const Value* transfers = optional_array(v, "transfers")) {
      for (const Value& t : transfers->items) read_transfer(index, t);
    }
  }

  void check_best_case(Ns bcet, Ns wcet, std::string_view key, const Value& v) {
    if (bcet > wcet) error(code::json_number_range, *v.find(key), fmt::format("'{}' is above the worst case", key));
  }

  void read_observed(std::size_t index, const Value& r) {
    if (!r.is(Value::Kind::string)) {
      error(code::json_type, r, fmt::format("an element of 'reads' is {}, not a string", describe(r.kind)));
      return;
    }
    later_.emplace_back([this, index, &r] {
      if (const auto found = find_device(r.text, r)) model_.devices[index].reads.push_back(*found);
    });
  }

  void read_acquisition(Device& d, const Value& v) {
    const Value* a = v.find("acquisition");
    if (a == nullptr || !check_object(*a, "'acquisition'")) return;
    model_.has_target = true;
    check_members(*a, "an acquisition", {"fixed_ns", "interval_ns", "periods", "every", "conversion_ns", "assumed"});
    d.acquisition =
        Acquisition{extension(*a, "fixed_ns"),    extension(*a, "interval_ns"),   extension(*a, "periods"),
                    extension(*a, "every", 1, 1), extension(*a, "conversion_ns"), flag(*a, "assumed", false)};
  }

  void read_transfer(std::size_t index, const Value& v) {
    if (!check_object(v, "a transfer")) return;
    check_members(v, "a transfer",
                  {"bus", "wire_ns", "after", "min_interval_ns", "interrupts", "command", "receive", "identifier"});
    Transfer t;
    const std::string bus = text(v, "a transfer", "bus");
    t.wire_ns = required(v, "a transfer", "wire_ns", 0);
    t.min_interval_ns = extension(v, "min_interval_ns");
    t.interrupts = extension(v, "interrupts", 1);
    if (v.find("identifier") != nullptr) t.identifier = extension(v, "identifier");
    t.command = flag(v, "command", false);
    t.receive = flag(v, "receive", false);
    read_after(t, v);
    if (bus.empty()) return;
    if (const auto found = find_bus(bus, *v.find("bus"))) {
      t.bus = *found;
      model_.devices[index].transfers.push_back(t);
    }
  }

  void read_after(Transfer& t, const Value& v) {
    if (v.find("after") == nullptr) return;
    const std::string after = text(v, "a transfer", "after");
    if (after == "update") {
      t.after = Transfer::After::update;
    } else if (after == "bucket") {
      t.after = Transfer::After::bucket;
    } else if (after == "autonomous") {
      t.after = Transfer::After::autonomous;
    } else if (after != "handle" && !after.empty()) {
      error(code::json_type, *v.find("after"),
            fmt::format("'after' is '{}', not update, handle, bucket or autonomous", after));
    }
  }

  void read_costs() {
    const Value* v = root_.find("costs");
    if (v == nullptr || !check_object(*v, "'costs'")) return;
    model_.has_target = true;
    check_members(*v, "'costs'",
                  {"release_ns", "release_per_bucket_ns", "interrupt_ns", "job_ns", "stage_ns", "masked_ns"});
    model_.costs = {extension(*v, "release_ns"),   extension(*v, "release_per_bucket_ns"),
                    extension(*v, "interrupt_ns"), extension(*v, "job_ns"),
                    extension(*v, "stage_ns"),     extension(*v, "masked_ns")};
  }

  void read_flushes() {
    const Value* list = optional_array(root_, "flushes");
    if (list == nullptr) return;
    for (const Value& v : list->items) {
      if (!check_object(v, "a flush")) continue;
      read_flush(v);
    }
  }

  void read_flush(const Value& v) {
    check_members(v, "a flush",
                  {"period_ns", "wcet_ns", "bus", "wire_ns", "interrupts", "identifiers", "devices", "output"});
    const std::size_t index = model_.flushes.size();
    model_.flushes.emplace_back();
    Flush& flush = model_.flushes.back();
    flush.period_ns = required(v, "a flush", "period_ns", 1);
    flush.wcet_ns = required(v, "a flush", "wcet_ns", 0);
    flush.wire_ns = extension(v, "wire_ns");
    flush.interrupts = extension(v, "interrupts", 1);
    if (const Value* identifiers = optional_array(v, "identifiers")) {
      model_.has_target = true;
      for (const Value& i : identifiers->items) flush.identifiers.push_back(integer(i, "identifiers", 0));
    }
    if (v.find("output") != nullptr) flush.output = text(v, "a flush", "output");
    const bool known = std::any_of(model_.devices.begin(), model_.devices.end(),
                                   [&](const Device& d) { return d.period_ns == flush.period_ns; });
    if (!known) error(code::timing_period, v, "no device has the period of this flush");
    if (v.find("bus") != nullptr) flush.bus = find_bus(text(v, "a flush", "bus"), *v.find("bus"));
    if (const Value* devices = optional_array(v, "devices")) {
      for (const Value& d : devices->items) {
        later_.emplace_back([this, index, &d] {
          if (const auto found = find_device(d.text, d)) model_.flushes[index].devices.push_back(*found);
        });
      }
    }
  }

  std::optional<std::size_t> find_bus(const std::string& bus, const Value& where) {
    const auto found = bus_names_.find(bus);
    if (found != bus_names_.end()) return found->second;
    if (!bus.empty()) error(code::timing_parent, where, fmt::format("there is no bus '{}'", bus));
    return std::nullopt;
  }

  void resolve_later() {
    for (const auto& step : later_) step();
  }

  const Value& root_;
  Diagnostics& diagnostics_;
  Model model_;
  std::map<std::string, std::size_t> bus_names_, device_names_;
  std::vector<std::function<void()>> later_;  ///< references by name, once all names are known
};

/// The model object of the file: the root, or its `model` member.
const Value* model_object(const Value& root, Diagnostics& diagnostics) {
  const auto not_an_object = [&](const Value& v, std::string_view what) {
    diagnostics.error(code::json_type, v.at, fmt::format("{} is {}, not an object", what, describe(v.kind)))
        .underline(v.length);
    return nullptr;
  };
  if (!root.is(Value::Kind::object)) return not_an_object(root, "the root");
  const Value* model = root.find("model");
  if (model == nullptr) return &root;
  for (const json::Member& m : root.members) {
    if (m.key != "model" && m.key != "name" && m.key != "description" && m.key != "expected") {
      diagnostics.error(code::json_unknown_member, m.at, fmt::format("a case file has no member '{}'", m.key))
          .underline(m.key.size() + 2);
    }
  }
  return model->is(Value::Kind::object) ? model : not_an_object(*model, "'model'");
}

/// Reads edges and parents together must not form a cycle: data would be older than itself.
void check_reads(const Model& model, Diagnostics& diagnostics) {
  enum class Mark : char { fresh, open, done };
  const std::size_t count = model.devices.size();
  std::vector<std::vector<std::size_t>> producers(count);
  for (std::size_t d = 0; d < count; ++d) {
    if (const auto parent = model.devices[d].parent) producers[*parent].push_back(d);
    for (const std::size_t observed : model.devices[d].reads) producers[d].push_back(observed);
  }
  std::vector<Mark> mark(count, Mark::fresh);
  std::vector<std::pair<std::size_t, std::size_t>> stack;
  for (std::size_t start = 0; start < count; ++start) {
    if (mark[start] != Mark::fresh) continue;
    stack.assign(1, {start, 0});
    mark[start] = Mark::open;
    while (!stack.empty()) {
      auto& [device, next] = stack.back();
      if (next == producers[device].size()) {
        mark[device] = Mark::done;
        stack.pop_back();
        continue;
      }
      const std::size_t producer = producers[device][next++];
      if (mark[producer] == Mark::open) {
        const Device& d = model.devices[device];
        diagnostics.error(code::timing_cycle, d.at, fmt::format("device '{}' reads data made from its own", d.name));
      } else if (mark[producer] == Mark::fresh) {
        mark[producer] = Mark::open;
        stack.emplace_back(producer, 0);
      }
    }
  }
}

}  // namespace

std::optional<Model> read_model(const SourceFile& file, Diagnostics& diagnostics) {
  const std::optional<Value> root = json::parse(file, diagnostics);
  if (!root) return std::nullopt;
  const Value* object = model_object(*root, diagnostics);
  if (object == nullptr) return std::nullopt;
  Model model = Reader(*object, diagnostics).read();
  if (!diagnostics.has_errors()) check_reads(model, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return model;
}

}  // namespace finemote::gen::timing
