// Changes of a robot's description that a hint may propose, and the models they lead to.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// One change: a longer or shorter period, another rate of a bus, another bus, less work.
struct Change {
  enum class Kind {
    period,  ///< `devices` get `period`
    rate,    ///< `bus` gets the rate `value` [bit/s]
    bus,     ///< `devices` leave `bus` for a new one of its kind and rate
    work,    ///< update and handle of `devices` take `value` thousandths of what they take, rounded down
  };
  Kind kind = Kind::period;
  std::vector<Rank> devices = {};
  BusPlace bus = {};
  Duration period = {};  ///< the new one
  std::int64_t value = 0;
};

/// The model of the description with these changes, in the same order of devices and buses, new buses last; none where
/// such a description would be refused, or where it is not known what a change would do.
using Remodel = std::function<std::optional<Model>(const std::vector<Change>&)>;

/// For a model that comes from no description: devices and flushes get the periods. Buses cannot be changed. The model
/// is copied.
Remodel model_remodel(const Model& model);

/// Applies the changes of work to a model; the others have no effect.
void change_work(Model& model, const std::vector<Change>& changes);

/// Whether every output that several devices share stays with one period: such devices move together.
bool keeps_outputs_together(const Model& before, const Model& after);

}  // namespace finemote::gen::timing
