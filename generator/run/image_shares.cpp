#include "generator/run/image_shares.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "generator/image/sizes.hpp"

namespace finemote::gen {
namespace {

using Kind = ImageShare::Kind;
using Owner = std::pair<Kind, std::string>;

/// What follows `prefix`; empty where it is another.
std::string_view behind(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix ? text.substr(prefix.size()) : std::string_view();
}

std::string_view without_kind(std::string_view name) {
  for (const char* kind : {"vtable for ", "typeinfo name for ", "typeinfo for ", "guard variable for "}) {
    if (const auto rest = behind(name, kind); !rest.empty()) return rest;
  }
  return name;
}

/// The owners of a robot's image, by the names of C++.
class Owners {
 public:
  explicit Owners(const Robot& robot) : robot_(robot.name.cpp + "::") {
    for (const Device& device : robot.devices) {
      shares_.push_back({Kind::device, device.name.text});
      devices_.emplace(device.name.cpp, device.name.text);
    }
    for (const Bus& bus : robot.buses) {
      shares_.push_back({Kind::bus, bus.name.text});
      buses_.emplace(bus.name.cpp, bus.name.text);
    }
    for (const Device& device : robot.devices) {
      if (types_.emplace(device.type->cpp_class, device.type->name).second)
        shares_.push_back({Kind::type, device.type->name});
    }
    shares_.push_back({Kind::generated});
    shares_.push_back({Kind::rest});
  }

  void add(const ImageSymbol& symbol, bool is_flash, bool is_ram) {
    const auto owner = owner_of(symbol);
    const auto is_it = [&](const ImageShare& share) { return share.kind == owner.first && share.name == owner.second; };
    ImageShare& share = *std::find_if(shares_.begin(), shares_.end(), is_it);
    if (is_flash) share.flash += symbol.size;
    if (is_ram) share.ram += symbol.size;
  }

  /// What is left of the sizes belongs to the rest.
  std::vector<ImageShare> finish(const ImageSizes& sizes) {
    ImageShare& rest = shares_.back();
    rest.flash = sizes.flash;
    rest.ram = sizes.ram;
    for (std::size_t i = 0; i + 1 < shares_.size(); ++i) {
      rest.flash -= shares_[i].flash;
      rest.ram -= shares_[i].ram;
    }
    return std::move(shares_);
  }

 private:
  [[nodiscard]] Owner owner_of(const ImageSymbol& symbol) const {
    const std::string readable = readable_name(symbol.name);
    const std::string_view name = without_kind(readable);
    if (const auto inner = behind(name, robot_); !inner.empty())
      return symbol.kind == ImageSymbol::Kind::object ? owner_of_object(inner) : Owner{Kind::generated, ""};
    for (const auto& [cpp, type] : types_) {
      const auto rest = behind(name, cpp);
      if (!rest.empty() && (rest.front() == '<' || rest.substr(0, 2) == "::")) return {Kind::type, type};
    }
    return {Kind::rest, ""};
  }

  /// `rov::imu`, `slots::imu`, `imu_uart`
  [[nodiscard]] Owner owner_of_object(std::string_view name) const {
    const std::size_t end = name.rfind("::");
    const bool is_outer = end == std::string_view::npos;
    const std::string last(is_outer ? name : name.substr(end + 2));
    const auto& names = is_outer ? buses_ : devices_;
    const auto found = names.find(last);
    if (found == names.end()) return {Kind::generated, ""};
    return {is_outer ? Kind::bus : Kind::device, found->second};
  }

  std::string robot_;
  std::map<std::string, std::string> devices_, buses_, types_;  ///< names in C++ to those of the robot
  std::vector<ImageShare> shares_;
};

}  // namespace

const char* share_name(Kind kind) {
  switch (kind) {
    case Kind::device:
      return "device";
    case Kind::bus:
      return "bus";
    case Kind::type:
      return "type";
    case Kind::generated:
      return "generated";
    case Kind::rest:
      return "rest";
  }
  return "";
}

std::vector<ImageShare> image_shares(const Image& image, const Robot& robot) {
  Owners owners(robot);
  std::uint64_t end = 0;  // of what is counted already: several symbols may name the same bytes
  for (const ImageSymbol& symbol : image.symbols) {
    const ImageSection& section = image.sections[symbol.section];
    if (!section.allocated || symbol.size == 0 || section.name == ".stack" || symbol.address < end) continue;
    end = std::uint64_t{symbol.address} + symbol.size;
    owners.add(symbol, section.has_bytes, section.writable && section.name != ".init_array");
  }
  return owners.finish(measure_image(image));
}

}  // namespace finemote::gen
