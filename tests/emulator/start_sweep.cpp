// What generate accepts starts without a safe stop: every shipped leaf type at every port that serves it, alone or
// behind an expander, with the usual, the lowest and the highest value of each param, of the rate and of the period.
//
//   start_sweep [--all] [--keep DIR]
//
// The seats are drawn from schemas/, not by hand: a new type, port or param takes part. Each is tried by itself; those
// that are accepted share robots as far as they need different ports and pins, and these run on the emulated board.
// Without --all every type takes each port once, the values in turn; with it, once for each set of values. The last
// line counts seats, accepted seats, robots and failures; exit 1 when there are any.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.hpp"
#include "errors/pipeline.hpp"

using namespace finemote;
using namespace finemote::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

enum class Values { usual, lowest, highest };
constexpr Values kValues[] = {Values::usual, Values::lowest, Values::highest};
const char* const kValueNames[] = {"usual", "lowest", "highest"};

/// A device with the buses it sits on.
struct Seat {
  std::string name;              ///< `led at pwm1, lowest`
  std::set<std::string> claims;  ///< ports and pins
  std::string tags;
};

Json read_json(const std::string& name) { return Json::parse(read_file(source_path(name))); }

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

bool has(const Json& list, const std::string& word) {
  return std::find(list.begin(), list.end(), Json(word)) != list.end();
}

/// `<param>`s of a descriptor at one end of their ranges.
std::string params_at(const Json& descriptor, Values values) {
  std::string tags;
  if (values == Values::usual || !descriptor.contains("params")) return tags;
  const bool low = values == Values::lowest;
  for (const Json& param : descriptor["params"]) {
    std::string value;
    if (param.contains("range")) value = text_of(param["range"][low ? 0 : 1]);
    if (param.contains("values")) value = text_of(low ? param["values"].front() : param["values"].back());
    if (param["type"] == "bool") value = low ? "false" : "true";
    if (!value.empty()) tags += "<param name=\"" + param["name"].get<std::string>() + "\">" + value + "</param>";
  }
  return tags;
}

std::string period_at(Values values) {
  return values == Values::usual ? "10ms" : values == Values::lowest ? "1ms" : "1s";
}

/// The slowest or fastest rate that port and type have in common, as the bus writes it.
std::string rate_at(const Json& port, const Json& bus, const std::string& kind, Values values) {
  const bool low = values == Values::lowest;
  std::int64_t least = port["min_rate"], most = port["max_rate"];
  if (bus.contains("max_clock_hz")) most = std::min<std::int64_t>(most, bus["max_clock_hz"]);
  if (kind == "spi") {
    const std::int64_t clock = port["clock_hz"];
    int power = low ? 8 : 1;
    while (!low && clock >> power > most) ++power;
    return " clock=\"" + std::to_string(clock >> power) + "Hz\"";
  }
  if (bus.contains("rates")) least = bus["rates"].front(), most = bus["rates"].back();
  const std::string rate = std::to_string(low ? least : most);
  if (kind == "i2c") return " clock=\"" + rate + "Hz\"";
  if (kind == "can") return " bitrate=\"" + rate + "bit/s\"";
  if (kind == "pwm" || kind == "gpio") return "";
  return " baud=\"" + (values == Values::usual && !bus.contains("rates") ? "115200" : rate) + "baud\"";
}

/// Draws the seats of one set of values.
class Draw {
 public:
  Draw() : board_(read_json("schemas/boards/robomaster_type_c.json")) {
    for (const auto& entry : fs::directory_iterator(source_path("schemas/devices"))) {
      const Json type = Json::parse(read_file(entry.path().string()));
      types_.emplace(type["type"].get<std::string>(), type);
    }
  }

  std::vector<Seat> seats(bool all) {
    std::vector<Seat> seats;
    for (const auto& [name, type] : types_) {
      if (type.contains("roles") || type.contains("link")) continue;
      if (!type.contains("bus")) {
        for (const Json& pin : board_["pins"]) add(seats, all, [&](Values v) { return at_pin(type, pin, v); });
        continue;
      }
      for (const Json& port : board_["ports"]) {
        for (const Json& kind : type["bus"]["types"]) {
          const auto word = kind.get<std::string>();
          if (has(port["buses"], word)) add(seats, all, [&](Values v) { return at_port(type, port, word, v); });
          if (word == "pwm" && has(port["buses"], "i2c"))
            add(seats, all, [&](Values v) { return behind(type, port, "pca9685", v); });
          if (word == "i2c" && has(port["buses"], "i2c"))
            add(seats, all, [&](Values v) { return behind(type, port, "tca9548a", v); });
        }
      }
    }
    return seats;
  }

 private:
  template <typename Make>
  void add(std::vector<Seat>& seats, bool all, Make make) {
    for (const Values values : kValues) {
      if (!all && values != kValues[turn_ % 3]) continue;
      Seat seat = make(values);
      seat.name += std::string(", ") + kValueNames[static_cast<int>(values)];
      seats.push_back(std::move(seat));
    }
    ++turn_;
  }
  /// The further hardware that a device needs, and with other values than the usual ones all that it can have.
  std::string uses(const Json& type, const std::string& bus, Values values, Seat& seat) {
    std::string tags;
    for (const Json& use : type.value("uses", Json::array())) {
      if (use.value("min", 0) == 0 && values == Values::usual) continue;
      const std::string role = "<use role=\"" + use["name"].get<std::string>() + "\" ";
      if (has(use["types"], "spi")) {
        tags += role + "bus=\"" + bus + "\" channel=\"1\"/>";
      } else if (has(use["types"], "gpio")) {
        if (const std::string pin = pin_for(use.value("function", "input"), seat); !pin.empty())
          tags += role + "pin=\"" + pin + "\"/>";
      } else if (has(use["types"], "pwm")) {
        if (const std::string other = pwm_bus(seat); !other.empty()) tags += role + "bus=\"" + other + "\"/>";
      }
    }
    return tags;
  }
  std::string pin_for(const std::string& function, Seat& seat) {
    for (const Json& pin : board_["pins"]) {
      const auto name = pin["name"].get<std::string>();
      if (has(pin["functions"], function) && seat.claims.insert(pin["pin"]).second) return name;
    }
    return {};
  }
  std::string pwm_bus(Seat& seat) {
    const auto& ports = board_["ports"];
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const Json& port = ports[(turn_ + i) % ports.size()];
      const auto name = port["name"].get<std::string>();
      if (!has(port["buses"], "pwm") || !claim(port, seat)) continue;
      seat.tags += "<bus name=\"@" + name + "\" type=\"pwm\" port=\"" + name + "\"/>\n";
      return "@" + name;
    }
    return {};
  }
  static bool claim(const Json& port, Seat& seat) {
    if (!seat.claims.insert(port["name"]).second) return false;
    for (const Json& pin : port["pins"]) seat.claims.insert(pin["pin"]);
    for (const Json& pin : port.value("selects", Json::array())) seat.claims.insert(pin);
    return true;
  }
  static std::string place(const Json& bus) {
    std::string text;
    if (bus.contains("channel")) text += " channel=\"0\"";
    if (bus.contains("id")) text += " id=\"" + bus["id"].value("min", Json(1)).dump() + "\"";
    return text;
  }
  void put_device(const Json& type, const std::string& bus, Values values, Seat& seat) {
    const auto name = type["type"].get<std::string>();
    const std::string further = uses(type, bus, values, seat);
    seat.tags += "<device name=\"@" + name + "\" type=\"" + name + "\" period=\"" + period_at(values) + "\"";
    if (!bus.empty()) seat.tags += " bus=\"" + bus + "\"" + place(type["bus"]);
    seat.tags += ">" + further + params_at(type, values) + "</device>\n";
  }

  Seat at_pin(const Json& type, const Json& pin, Values values) {
    const auto name = type["type"].get<std::string>();
    Seat seat{name + " at pin " + pin["name"].get<std::string>(), {pin["pin"]}, {}};
    seat.tags = "<device name=\"@" + name + "\" type=\"" + name + "\" period=\"" + period_at(values) + "\">";
    for (const Json& use : type.value("uses", Json::array()))
      seat.tags +=
          "<use role=\"" + use["name"].get<std::string>() + "\" pin=\"" + pin["name"].get<std::string>() + "\"/>";
    seat.tags += params_at(type, values) + "</device>\n";
    return seat;
  }
  Seat at_port(const Json& type, const Json& port, const std::string& kind, Values values) {
    const auto name = port["name"].get<std::string>();
    Seat seat{type["type"].get<std::string>() + " at " + name, {}, {}};
    claim(port, seat);
    seat.tags = "<bus name=\"@bus\" type=\"" + kind + "\" port=\"" + name + "\"" +
                rate_at(port, type["bus"], kind, values) + "/>\n";
    put_device(type, "@bus", values, seat);
    return seat;
  }
  Seat behind(const Json& type, const Json& port, const std::string& model, Values values) {
    const Json part = read_json("schemas/expanders/" + model + ".json");
    const auto name = port["name"].get<std::string>();
    Seat seat{type["type"].get<std::string>() + " behind " + model + " at " + name, {}, {}};
    claim(port, seat);
    seat.tags = "<bus name=\"@bus\" type=\"i2c\" port=\"" + name + "\"" + rate_at(port, part["bus"], "i2c", values) +
                "/>\n<expander name=\"@part\" model=\"" + model + "\" bus=\"@bus\" address=\"" +
                part["bus"]["address"]["default"].get<std::string>() + "\">";
    const bool named = part["kind"] == "mux";
    if (named) seat.tags += "<channel index=\"0\" name=\"@channel\"/>";
    // Of its params the default clock: an individual part's is no choice of the robot.
    if (values != Values::usual && !named)
      seat.tags +=
          std::string("<param name=\"frequency\">") + (values == Values::lowest ? "24Hz" : "350Hz") + "</param>";
    seat.tags += "</expander>\n";
    put_device(type, named ? "@channel" : "@part", values, seat);
    return seat;
  }

  Json board_;
  std::map<std::string, Json> types_;
  std::size_t turn_ = 0;
};

/// `@` in names becomes `s<n>_`.
std::string numbered(const std::string& tags, std::size_t number) {
  std::string text;
  for (const char c : tags) {
    if (c == '@') {
      text += "s" + std::to_string(number) + "_";
    } else {
      text += c;
    }
  }
  return text;
}

std::string robot_of(const std::vector<Seat>& seats) {
  std::string text =
      "<robot name=\"sweep\">\n<link name=\"base\"/>\n<finemote version=\"1\">\n<board name=\"robomaster_type_c\"/>\n";
  for (std::size_t i = 0; i < seats.size(); ++i) text += numbered(seats[i].tags, i);
  return text + "</finemote>\n</robot>\n";
}

bool is_accepted(gen::Pipeline& pipeline, const std::vector<Seat>& seats) {
  const auto kind = pipeline.run(robot_of(seats)).kind;
  return kind == gen::Outcome::Kind::generated || kind == gen::Outcome::Kind::unschedulable;
}

/// As few robots as first come, first served makes.
std::vector<std::vector<Seat>> pack(gen::Pipeline& pipeline, std::vector<Seat> seats) {
  std::vector<std::vector<Seat>> robots;
  const auto fits = [&](const std::vector<Seat>& robot, const Seat& seat) {
    for (const Seat& other : robot) {
      for (const std::string& claim : seat.claims) {
        if (other.claims.contains(claim)) return false;
      }
    }
    std::vector<Seat> together = robot;
    together.push_back(seat);
    return is_accepted(pipeline, together);
  };
  for (Seat& seat : seats) {
    const auto room = std::find_if(robots.begin(), robots.end(), [&](const auto& robot) { return fits(robot, seat); });
    if (room != robots.end()) {
      room->push_back(std::move(seat));
    } else {
      robots.push_back({std::move(seat)});
    }
  }
  return robots;
}

/// What went wrong at the start; empty: nothing.
std::string complaint(const std::string& robot, const std::string& folder) {
  const std::string file = folder + "/robot.urdf";
  write_file(file, robot);
  const auto result = run_finemote({"run", file, "--duration", "100ms", "--allow-unschedulable", "--format", "json"});
  const auto begin = result.output.find("{\n");
  if (result.exit_status > 1 || begin == std::string::npos) return result.output;
  const auto line = result.output.substr(begin);
  const Json document = Json::parse(line);
  if (document["resets"] != 0) return "resets: " + document["resets"].dump();
  if (result.output.find("FM6002") != std::string::npos) return result.output;
  return {};
}

int sweep(bool all, const std::string& keep) {
  gen::Pipeline pipeline(source_path("examples"));
  const std::vector<Seat> drawn = Draw().seats(all);
  std::vector<Seat> accepted;
  for (const Seat& seat : drawn) {
    if (is_accepted(pipeline, {seat})) accepted.push_back(seat);
  }
  const std::size_t count = accepted.size();
  const auto robots = pack(pipeline, std::move(accepted));
  const TemporaryFolder folder;
  std::size_t failures = 0;
  for (const auto& robot : robots) {
    const std::string text = robot_of(robot);
    const std::string said = complaint(text, folder.path());
    if (said.empty()) continue;
    ++failures;
    std::printf("FAILED: %s\n%s\n", said.substr(0, 2000).c_str(), text.c_str());
    if (!keep.empty()) write_file(keep + "/" + std::to_string(failures) + ".urdf", text);
  }
  std::printf("%zu seats, %zu accepted, %zu robots, %zu failures\n", drawn.size(), count, robots.size(), failures);
  return failures == 0 && count > drawn.size() / 3 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  bool all = false;
  std::string keep;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--all") all = true;
    if (word == "--keep" && i + 1 < argc) keep = argv[++i];
  }
  try {
    return sweep(all, keep);
  } catch (const std::exception& problem) {
    std::printf("%s\n", problem.what());
    return 1;
  }
}
