#include "generator/image/constants.hpp"

#include <dwarf.h>

#include <optional>
#include <string_view>

#include "generator/image/debug_file.hpp"

namespace finemote::gen {
namespace {

/// Types in types: deeper ones are not looked into.
constexpr int kDeepest = 32;
/// Elements of an array that are looked at.
constexpr std::uint32_t kMostElements = 4096;

std::optional<Dwarf_Die> type_of(Dwarf_Die* die) {
  Dwarf_Attribute attribute;
  Dwarf_Die type;
  if (dwarf_attr_integrate(die, DW_AT_type, &attribute) == nullptr) return std::nullopt;
  if (dwarf_formref_die(&attribute, &type) == nullptr) return std::nullopt;
  return type;
}

std::optional<std::uint32_t> number(Dwarf_Die* die, unsigned name) {
  Dwarf_Attribute attribute;
  Dwarf_Word value = 0;
  if (dwarf_attr_integrate(die, name, &attribute) == nullptr || dwarf_formudata(&attribute, &value) != 0)
    return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

/// Where a variable with static storage lies.
std::optional<std::uint32_t> address_of(Dwarf_Die* variable) {
  Dwarf_Attribute attribute;
  Dwarf_Op* operations = nullptr;
  std::size_t count = 0;
  if (dwarf_attr(variable, DW_AT_location, &attribute) == nullptr) return std::nullopt;
  if (dwarf_getlocation(&attribute, &operations, &count) != 0 || count != 1) return std::nullopt;
  if (operations[0].atom != DW_OP_addr || operations[0].number == 0) return std::nullopt;
  return static_cast<std::uint32_t>(operations[0].number);
}

std::uint32_t size_of(Dwarf_Die* type) {
  Dwarf_Word size = 0;
  return dwarf_aggregate_size(type, &size) == 0 ? static_cast<std::uint32_t>(size) : 0;
}

std::string_view name_of(Dwarf_Die* die) {
  const char* name = dwarf_diename(die);
  return name == nullptr ? std::string_view() : std::string_view(name);
}

/// Declared neither in the runtime, by the name that it is compiled under, nor with the compiler.
bool is_users(Dwarf_Die* type) {
  const char* const file = dwarf_decl_file(type);
  const std::string_view name = file == nullptr ? std::string_view() : std::string_view(file);
  return name.rfind("finemote/runtime/", 0) != 0 && name.find("/include/c++/") == std::string_view::npos;
}

class Search {
 public:
  explicit Search(Liberties liberties) : liberties_(liberties) {}
  KeptMembers found;

  /// Looks at a variable of this type at this place.
  void look_at_variable(Dwarf_Die type, std::uint32_t at, bool is_in_function) {
    constant_ = is_in_function ? &found.constant_in_functions : &found.constant;
    is_member_ = false;
    look(type, at, 0);
  }

 private:
  void look(Dwarf_Die type, std::uint32_t at, int depth) {
    if (depth > kDeepest) return;
    switch (dwarf_tag(&type)) {
      case DW_TAG_const_type:
      case DW_TAG_reference_type:
        if (is_member_ && !liberties_.makes_anew && !has_mutable(type, 0)) keep_parts(type, at, 0);
        return;
      case DW_TAG_typedef:
        if (const auto inner = type_of(&type)) look(*inner, at, depth + 1);
        return;
      case DW_TAG_array_type:
        return each_element(type, at,
                            [&](const Dwarf_Die& element, std::uint32_t place) { look(element, place, depth + 1); });
      case DW_TAG_structure_type:
      case DW_TAG_class_type:
        if (name_of(&type).rfind("AtStart<", 0) == 0) return keep(found.at_start, at, size_of(&type));
        return each_member(type, at, [&](const Dwarf_Die& member, std::uint32_t place) {
          is_member_ = true;
          look(member, place, depth + 1);
        });
      default:
        return;
    }
  }

  /// A part of it may change although it is const.
  [[nodiscard]] bool has_mutable(Dwarf_Die type, int depth) const {
    if (depth > kDeepest) return true;
    const int tag = dwarf_tag(&type);
    const bool is_class = tag == DW_TAG_structure_type || tag == DW_TAG_class_type || tag == DW_TAG_union_type;
    if (!is_class) {
      const bool is_pointer = tag == DW_TAG_pointer_type || tag == DW_TAG_reference_type;
      const auto inner = is_pointer ? std::nullopt : type_of(&type);
      return tag == DW_TAG_volatile_type || (inner && has_mutable(*inner, depth + 1));
    }
    if (liberties_.has_mutable && is_users(&type)) return true;
    Dwarf_Die member;
    if (dwarf_child(&type, &member) != 0) return false;
    do {
      if (dwarf_tag(&member) != DW_TAG_member && dwarf_tag(&member) != DW_TAG_inheritance) continue;
      const auto inner = type_of(&member);
      if (dwarf_hasattr(&member, DW_AT_mutable) != 0 || (inner && has_mutable(*inner, depth + 1))) return true;
    } while (dwarf_siblingof(&member, &member) == 0);
    return false;
  }

  /// The numbers and pointers of a constant: between and after them other members may lie, which are none.
  void keep_parts(Dwarf_Die type, std::uint32_t at, int depth) {
    if (depth > kDeepest) return;
    switch (dwarf_tag(&type)) {
      case DW_TAG_const_type:
      case DW_TAG_typedef:
        if (const auto inner = type_of(&type)) keep_parts(*inner, at, depth + 1);
        return;
      case DW_TAG_array_type:
        return each_element(
            type, at, [&](const Dwarf_Die& element, std::uint32_t place) { keep_parts(element, place, depth + 1); });
      case DW_TAG_structure_type:
      case DW_TAG_class_type:
        return each_member(type, at,
                           [&](const Dwarf_Die& member, std::uint32_t place) { keep_parts(member, place, depth + 1); });
      case DW_TAG_union_type:  // which of its parts it holds, and so where it ends, is not known
        return;
      default:
        return keep(*constant_, at, size_of(&type));
    }
  }

  static void keep(std::vector<ImageRange>& ranges, std::uint32_t at, std::uint32_t size) {
    if (size != 0) ranges.push_back({at, at + size});
  }

  /// Calls act(type, place) for each.
  template <typename Act>
  static void each_element(Dwarf_Die& array, std::uint32_t at, const Act& act) {
    const auto element = type_of(&array);
    if (!element) return;
    Dwarf_Die copy = *element;
    const std::uint32_t size = size_of(&copy), whole = size_of(&array);
    if (size == 0 || whole / size > kMostElements) return;
    for (std::uint32_t offset = 0; offset + size <= whole; offset += size) act(*element, at + offset);
  }

  /// The same of members and bases, but for bit fields.
  template <typename Act>
  static void each_member(Dwarf_Die& type, std::uint32_t at, const Act& act) {
    Dwarf_Die member;
    if (dwarf_child(&type, &member) != 0) return;
    do {
      const int tag = dwarf_tag(&member);
      const auto offset = number(&member, DW_AT_data_member_location);
      if ((tag != DW_TAG_member && tag != DW_TAG_inheritance) || !offset) continue;
      if (dwarf_hasattr(&member, DW_AT_bit_size) != 0 || dwarf_hasattr(&member, DW_AT_data_bit_offset) != 0) continue;
      if (const auto inner = type_of(&member)) act(*inner, at + *offset);
    } while (dwarf_siblingof(&member, &member) == 0);
  }

  const Liberties liberties_;
  std::vector<ImageRange>* constant_ = nullptr;  ///< of `found`
  bool is_member_ = false;
};

/// The variables of a unit, namespaces and functions included.
void search_in(Dwarf_Die parent, Search& search, int depth, bool is_in_function = false) {
  Dwarf_Die child;
  if (depth > kDeepest || dwarf_child(&parent, &child) != 0) return;
  do {
    if (dwarf_tag(&child) == DW_TAG_variable) {
      const auto at = address_of(&child);
      const auto type = at ? type_of(&child) : std::nullopt;
      if (type) search.look_at_variable(*type, *at, is_in_function);
    } else {
      search_in(child, search, depth + 1, is_in_function || dwarf_tag(&child) == DW_TAG_subprogram);
    }
  } while (dwarf_siblingof(&child, &child) == 0);
}

}  // namespace

KeptMembers kept_members(const std::string& path, Liberties liberties, Diagnostics& diagnostics) {
  const DebugFile file(path);
  if (!file.is_open()) {
    diagnostics.error(code::bad_image, {}, "cannot read the image '" + path + "'");
    return {};
  }
  if (file.dwarf() == nullptr) return {};
  Search search(liberties);
  Dwarf_Off offset = 0, next = 0;
  std::size_t header = 0;
  for (; dwarf_nextcu(file.dwarf(), offset, &next, &header, nullptr, nullptr, nullptr) == 0; offset = next) {
    Dwarf_Die unit;
    if (dwarf_offdie(file.dwarf(), offset + header, &unit) != nullptr) search_in(unit, search, 0);
  }
  return std::move(search.found);
}

}  // namespace finemote::gen
