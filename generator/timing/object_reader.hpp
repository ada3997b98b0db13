// Objects of a JSON file by tables of their fields: what reads them, and what checks them, follows from the table.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

/// Whether a member has to be there, and whether it is one that only profile `target` knows.
enum class Need { optional, required, target };

/// One member of a JSON object that becomes an `Object`, and where its value goes.
template <class Object, class Reader>
struct Field {
  /// A function of `Reader` that takes the whole value, or, of an array, each of its elements.
  struct Whole {
    void (Reader::*read)(Object&, const json::Value&);
  };
  struct Each {
    void (Reader::*read)(Object&, const json::Value&);
  };
  /// Read apart.
  using Apart = std::monostate;
  using Target = std::variant<std::int64_t Object::*, Duration Object::*, bool Object::*, Whole, Each, Apart>;

  std::string_view name;
  Need need = Need::optional;
  Target target = Apart{};
  std::int64_t least = 0;  ///< of a number, or of the nanoseconds of a time
};

/// Reads values and reports what is wrong with them where they stand: FM4003 to FM4007. A mistake leaves a value that
/// is right in its place, so that reading goes on.
class ObjectReader {
 public:
  explicit ObjectReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  Diagnostic& error(Code code, const json::Value& where, std::string message);

  bool is_object(const json::Value& value, std::string_view what);
  bool is_array(const json::Value& value, std::string_view key);
  /// An integer from `least` to the largest of 64 bits; else `least`.
  std::int64_t integer(const json::Value& value, std::string_view key, std::int64_t least);
  bool flag(const json::Value& value, std::string_view key);
  /// A text that is not empty; else an empty one. `what` has the member.
  std::string text(const json::Value& value, std::string_view what, std::string_view key);
  /// The same of an object's member, which must be there.
  std::string member_text(const json::Value& object, std::string_view what, std::string_view key);

  /// What a text stands for, one of a few words; else the first.
  template <class Kind, std::size_t kCount>
  Kind one_of(const json::Value& value, std::string_view what, std::string_view key,
              const std::pair<Kind, std::string_view> (&words)[kCount]) {
    const std::string said = text(value, what, key);
    std::string list;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (words[i].second == said) return words[i].first;
      list += (i == 0 ? "" : i + 1 < kCount ? ", " : " or ") + std::string(words[i].second);
    }
    if (!said.empty()) report_other_word(value, key, said, list);
    return words[0].first;
  }

  /// Reads the members of an object in the order of the table, by `reader` where the table says so.
  /// @param what  the object in messages: `a bus`
  template <class Object, class Reader, std::size_t kCount>
  void read_fields(const json::Value& value, std::string_view what, const Field<Object, Reader> (&fields)[kCount],
                   Object& object, Reader& reader) {
    std::vector<std::string_view> names;
    for (const auto& field : fields) names.push_back(field.name);
    check_members(value, what, names);
    for (const auto& field : fields) {
      const json::Value* member = value.find(field.name);
      if (member != nullptr) {
        saw_target_ |= field.need == Need::target;
        std::visit([&](const auto& target) { assign(*member, field, target, object, reader); }, field.target);
      } else if (field.need == Need::required) {
        report_missing(value, what, field.name);
      }
    }
  }

  /// Whether a member that only profile `target` knows was among those read.
  [[nodiscard]] bool saw_target() const { return saw_target_; }

 private:
  void check_members(const json::Value& object, std::string_view what, const std::vector<std::string_view>& known);
  void report_other_word(const json::Value& value, std::string_view key, std::string_view said, std::string_view list);
  void report_missing(const json::Value& object, std::string_view what, std::string_view key);

  template <class Object, class Reader, class Target>
  void assign(const json::Value& value, const Field<Object, Reader>& field, const Target& target, Object& object,
              Reader& reader) {
    using AnyField = Field<Object, Reader>;
    if constexpr (std::is_same_v<Target, typename AnyField::Whole>) {
      (reader.*target.read)(object, value);
    } else if constexpr (std::is_same_v<Target, typename AnyField::Each>) {
      if (!is_array(value, field.name)) return;
      for (const json::Value& item : value.items) (reader.*target.read)(object, item);
    } else if constexpr (std::is_same_v<Target, bool Object::*>) {
      object.*target = flag(value, field.name);
    } else if constexpr (std::is_same_v<Target, Duration Object::*>) {
      object.*target = nanoseconds(integer(value, field.name, field.least));
    } else if constexpr (!std::is_same_v<Target, typename AnyField::Apart>) {
      object.*target = integer(value, field.name, field.least);
    }
  }

  Diagnostics& diagnostics_;
  bool saw_target_ = false;
};

}  // namespace finemote::gen::timing
