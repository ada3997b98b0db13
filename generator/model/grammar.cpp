#include "generator/model/grammar.hpp"

#include <algorithm>
#include <array>

namespace finemote::gen::grammar {
namespace {

using A = AttributeRule;

constexpr std::array kFinemote{A{"version", false, "1"}};
constexpr std::array<std::string_view, 5> kInFinemote{"board", "bus", "expander", "device", "require"};

constexpr std::array kBoard{A{"name", true}, A{"tick", false, "1ms"}};
constexpr std::array<std::string_view, 1> kOnlyParam{"param"};

constexpr std::array kBus{A{"name", true, "imu_uart"},    A{"type", true, "uart"},       A{"port", false, "usart1"},
                          A{"baud", false, "115200baud"}, A{"clock", false, "400kHz"},   A{"bitrate", false, "1Mbit/s"},
                          A{"isr_wcet", false, "2us"},    A{"min_frame", false, "20bit"}};

constexpr std::array kExpander{A{"name", true, "mux"}, A{"model", true}, A{"bus", true, "i2c"},
                               A{"address", true, "0x70"}};
constexpr std::array<std::string_view, 2> kInExpander{"channel", "param"};
constexpr std::array kChannel{A{"index", true, "0"}, A{"name", true, "segment_0"}};

constexpr std::array kDevice{A{"name", true, "imu"},
                             A{"type", true, "h30_imu"},
                             A{"parent", false, "rov"},
                             A{"role", false, "imu"},
                             A{"period", false, "10ms"},
                             A{"bus", false, "i2c"},
                             A{"address", false, "0x76"},
                             A{"channel", false, "0"},
                             A{"id", false, "1"},
                             A{"link", false},
                             A{"joint", false}};
constexpr std::array<std::string_view, 5> kInDevice{"device", "reads", "use", "wcet", "param"};

constexpr std::array kReads{A{"device", true, "remote"}, A{"role", true, "remote"}};
constexpr std::array kUse{A{"role", true, "host"}, A{"bus", false, "tether"}, A{"pin", false, "PB12"},
                          A{"channel", false, "0"}};
constexpr std::array kWcet{A{"update", true, "5us"}, A{"handle", true, "5us"}, A{"source", false, "budget"}};
constexpr std::array kParam{A{"name", true}};
constexpr std::array kRequire{A{"latency", false, "imu -> thruster_1"}, A{"of", false, "decision"},
                              A{"utilization", false, "cpu"}, A{"jitter", false, "imu"}, A{"max", true, "20ms"}};

constexpr std::array kRules{ElementRule{"finemote", kFinemote, kInFinemote},
                            ElementRule{"board", kBoard, kOnlyParam},
                            ElementRule{"bus", kBus, kOnlyParam},
                            ElementRule{"expander", kExpander, kInExpander},
                            ElementRule{"channel", kChannel, {}},
                            ElementRule{"device", kDevice, kInDevice},
                            ElementRule{"reads", kReads, {}},
                            ElementRule{"use", kUse, {}},
                            ElementRule{"wcet", kWcet, {}},
                            ElementRule{"param", kParam, {}, true},
                            ElementRule{"require", kRequire, {}}};

}  // namespace

bool ElementRule::allows_child(std::string_view child) const {
  return std::find(children.begin(), children.end(), child) != children.end();
}

const ElementRule* rule(std::string_view element) {
  for (const ElementRule& candidate : kRules) {
    if (candidate.name == element) return &candidate;
  }
  return nullptr;
}

std::span<const ElementRule> rules() { return kRules; }

}  // namespace finemote::gen::grammar
