// When a transfer's last bit is on its wire, and how busy every bus is.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "generator/timing/response.hpp"

namespace finemote::gen::timing {

struct BusLoad {
  Duration wire_per_s;  ///< in every second; of the busier line where a bus has two
  double utilization = 0;
};

/// Everything that goes over the buses, with its worst wait. A bus takes what is queued in rate-monotonic order, as the
/// runtime's interrupt does, and finishes what it began. Frames a part sends by itself count as more urgent than
/// anything; where identifiers decide (CAN), everything counts as more urgent than everything else.
///
/// Source: non-preemptive fixed priorities with release jitter, sufficient form (Davis, Burns, Bril and Lukkien,
/// Real-Time Systems 35(3), 2007, section 3.4): the longest transfer of lower urgency blocks once, and where the bus
/// may stay busy until the next hand-over, one of its own.
class TransferBounds {
 public:
  /// Everything must outlive this.
  TransferBounds(const Model& model, Profile profile, const TaskSet& set, const Responses& responses, Effort& effort);

  /// Hand-over to last bit of a transfer; none where one may still be queued when the next is handed over.
  [[nodiscard]] std::optional<Duration> of(Rank device, std::size_t transfer) const;
  /// The same without service routines, and with the look that sees it: when its last bit is there. Where frames
  /// arbitrate it holds if all of ours leave, see all_leave(); one that another node hands over up to a bit later may
  /// still go first there (Davis et al., their tau_bit).
  [[nodiscard]] std::optional<Duration> arrival(Rank device, std::size_t transfer) const;
  /// Whether every frame of ours has left its bus before the next one of its slot is handed over.
  [[nodiscard]] bool all_leave(BusPlace bus) const;
  /// The shortest time from one hand-over to the next, which arrival() is above by a bit at most.
  [[nodiscard]] Duration interval(Rank device, std::size_t transfer) const {
    return items_[item_of_[device][transfer]].period;
  }
  /// Hand-over to last bit of what the flush of one bucket hands over, if its data are sent; 0 where it hands over
  /// nothing.
  [[nodiscard]] std::optional<Duration> of_flush(std::size_t flush) const;

  /// For every bus and bucket: how long after the release of a job all that it hands over has ended; none where that
  /// may be later than the next release, or is not known.
  [[nodiscard]] Table<BusPlace, std::vector<std::optional<Duration>>> ended() const;

  [[nodiscard]] const Table<BusPlace, BusLoad>& loads() const { return loads_; }

 private:
  struct Item {
    BusPlace bus;
    bool receive = false;
    bool autonomous = false;
    Duration period = nanoseconds(1);
    Duration jitter;          ///< release to hand-over
    Duration wire;            ///< occupation of the bus, service routines included
    Duration pure;            ///< the same without them
    std::size_t rank = 0;     ///< 0 is the most urgent
    bool bounded = true;      ///< its bucket is ok
    bool arbitrated = false;  ///< on a bus that arbitrates frame by frame
    Duration bit = {};        ///< there: nodes that begin within it arbitrate
    /// Identifiers of its first and last frame there; none: not known.
    std::optional<std::pair<std::int64_t, std::int64_t>> identifiers = std::nullopt;
    std::int64_t frames = 1;  ///< that it is sent in, all equally long
    Duration late = {};       ///< from its hand-over to when the part begins to answer, at the latest
    bool is_split = false;    ///< in frames of which the length of the last is unknown
    std::size_t bucket = 0;   ///< whose jobs hand it over
    /// On a polled bus: from the end of a transfer to the look that sees it, and begins the next one.
    Duration look = {};
    [[nodiscard]] Duration frame() const { return ceil_div(on_wire(), frames); }
    /// Whether `other` goes first where both wait.
    [[nodiscard]] bool yields_to(const Item& other) const {
      if (!arbitrated) return other.rank <= rank || (autonomous && !receive);  // its part may answer before it sends it
      return !identifiers || !other.identifiers || other.identifiers->first <= identifiers->second;
    }
    /// How long it keeps others off the wire. Neither a part that sends by itself nor a frame in a mailbox of the
    /// controller waits for our service routines on the wire; between frames the wire is free for others.
    [[nodiscard]] Duration on_wire() const { return autonomous || arbitrated ? pure : wire + look; }
  };

  void collect();
  [[nodiscard]] Duration latest_answer(const Device& device, const Transfer& transfer) const;
  void add_looks();
  void add_load();
  std::size_t add_item(Item item, std::int64_t interrupts, Duration service);
  [[nodiscard]] Duration with_service(const Item& item, std::int64_t interrupts, Duration service) const;
  [[nodiscard]] std::optional<Duration> wait(const Item& own) const;
  [[nodiscard]] bool finds_mailbox(const Item& own) const;
  [[nodiscard]] std::optional<Duration> bound(std::size_t item) const;
  [[nodiscard]] Duration at_begin(const Item& own) const;
  [[nodiscard]] Duration blocking(const Item& own) const;
  [[nodiscard]] std::optional<Duration> least_wait(const Item& own, Duration base, Duration limit,
                                                   bool with_begin) const;
  [[nodiscard]] std::optional<Duration> more_urgent(const Item& own, Duration time, bool with_begin) const;
  static bool competes(const Item& item, const Item& own);

  const Model& model_;
  Profile profile_;
  const TaskSet& set_;
  const Responses& responses_;
  Effort& effort_;
  std::vector<Stream> streams_;  ///< of any window
  bool is_saturated_;            ///< by them alone
  std::vector<Item> items_;
  Table<Rank, std::vector<std::size_t>> item_of_;  ///< per transfer
  std::vector<std::optional<std::size_t>> flush_item_;
  Table<BusPlace, BusLoad> loads_;
  Table<BusPlace, bool> is_declared_;  ///< all that goes over the bus is among the items
};

/// Place of the bucket that a flush belongs to.
std::size_t bucket_of(const TaskSet& set, const Flush& flush);

/// Whether the flushes of two buckets hand over the same data.
bool share_slot(const Flush& a, const Flush& b);

}  // namespace finemote::gen::timing
