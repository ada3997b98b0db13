// Indices with types: turns "the third element of some vector" into "device 2", which only a table of devices accepts.
//
//   struct DeviceTag;
//   using DeviceId = Index<DeviceTag>;
//   Table<DeviceId, Device> devices;         // what robot.devices is
//   Table<DeviceId, std::size_t> bucket_of;  // one value per device
//
//   const DeviceId imu = devices.push_back(Device{});
//   devices[imu];                            // a Device
//   for (const DeviceId id : devices.ids()) bucket_of[id] = 0;
//
// An index is made from a number by name only and gives its number by name only. Whoever needs that number often has a
// vector that should be a Table, or an index of another kind.
#pragma once

#include <compare>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

namespace finemote::gen {

/// Position of one element in every Table of one index space. `Tag` names the space and need not be defined.
template <class Tag>
class Index {
 public:
  constexpr Index() = default;  ///< the first element
  constexpr explicit Index(std::size_t value) : value_(value) {}

  /// The position as a number, from 0: for output, and for arithmetic that means positions.
  [[nodiscard]] constexpr std::size_t value() const { return value_; }

  friend constexpr bool operator==(Index, Index) = default;
  friend constexpr auto operator<=>(Index, Index) = default;

 private:
  std::size_t value_ = 0;
};

/// The indices 0 to `count - 1` in order, to be walked by a range-based for or an algorithm.
template <class Id>
class Indices {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Id;
    using difference_type = std::ptrdiff_t;
    using pointer = const Id*;
    using reference = Id;

    constexpr Iterator() = default;
    constexpr explicit Iterator(std::size_t position) : position_(position) {}
    constexpr Id operator*() const { return Id{position_}; }
    constexpr Iterator& operator++() {
      ++position_;
      return *this;
    }
    constexpr Iterator operator++(int) { return Iterator{position_++}; }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    std::size_t position_ = 0;
  };

  constexpr explicit Indices(std::size_t count) : count_(count) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator{0}; }
  [[nodiscard]] constexpr Iterator end() const { return Iterator{count_}; }

 private:
  std::size_t count_;
};

/// A std::vector whose elements are named by `Id` alone. Access is unchecked, as in a vector.
template <class Id, class T>
class Table {
 public:
  using value_type = T;
  using reference = typename std::vector<T>::reference;
  using const_reference = typename std::vector<T>::const_reference;

  Table() = default;
  explicit Table(std::size_t count, const T& value = T()) : elements_(count, value) {}
  Table(std::initializer_list<T> elements) : elements_(elements) {}

  [[nodiscard]] reference operator[](Id id) { return elements_[id.value()]; }
  [[nodiscard]] const_reference operator[](Id id) const { return elements_[id.value()]; }
  [[nodiscard]] reference back() { return elements_.back(); }
  [[nodiscard]] const_reference back() const { return elements_.back(); }

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  [[nodiscard]] bool empty() const { return elements_.empty(); }
  /// Whether there is an element of that index.
  [[nodiscard]] bool contains(Id id) const { return id.value() < elements_.size(); }

  /// The indices of all elements, in order. Elements added meanwhile are not part of it.
  [[nodiscard]] Indices<Id> ids() const { return Indices<Id>{elements_.size()}; }
  /// The index that the next element added gets.
  [[nodiscard]] Id next_id() const { return Id{elements_.size()}; }

  /// Adds an element at the end and returns its index.
  Id push_back(T element) {
    elements_.push_back(std::move(element));
    return Id{elements_.size() - 1};
  }
  void resize(std::size_t count) { elements_.resize(count); }
  void reserve(std::size_t count) { elements_.reserve(count); }
  void assign(std::size_t count, const T& value) { elements_.assign(count, value); }

  [[nodiscard]] auto begin() { return elements_.begin(); }
  [[nodiscard]] auto end() { return elements_.end(); }
  [[nodiscard]] auto begin() const { return elements_.begin(); }
  [[nodiscard]] auto end() const { return elements_.end(); }
  [[nodiscard]] auto rbegin() const { return elements_.rbegin(); }
  [[nodiscard]] auto rend() const { return elements_.rend(); }

  friend bool operator==(const Table&, const Table&) = default;

 private:
  std::vector<T> elements_;
};

}  // namespace finemote::gen
