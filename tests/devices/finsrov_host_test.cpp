// The operator's text commands: whole messages count, others not.
#include "finemote/devices/finsrov_host.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Verb = FinsRovOrder::Verb;

struct Fixture {
  Fixture() {
    bench::reset();
    uart.start();
  }
  /// The verbs of one message, sent at once and followed by silence.
  std::vector<Verb> verbs(const std::string& text) {
    host::usart6.feed(now(), text);
    host::advance(20 * kMillisecond);
    return take();
  }
  std::vector<Verb> take() {
    std::vector<Verb> all;
    FinsRovOrder order;
    for (unsigned update = 0; update <= FinsRovHost::kMaxMessage / FinsRovHost::kMostPieces; ++update) {
      if (!host.receive(uart)) continue;
      while (host.next(order)) {
        all.push_back(order.verb);
        last = order;
      }
      break;
    }
    return all;
  }
  std::uint8_t ring[256];
  Uart uart{ports::usart6, 115200, ring, UartFormat::k8E1};
  FinsRovHost host;
  FinsRovOrder last;
};

}  // namespace

TEST_CASE_METHOD(Fixture, "every command of the host program") {
  const std::pair<const char*, Verb> all[] = {{"ON", Verb::kOn},
                                              {"OFF", Verb::kOff},
                                              {"UP", Verb::kUp},
                                              {"DN", Verb::kDown},
                                              {"H:250", Verb::kDepth},
                                              {"W", Verb::kForward},
                                              {"S", Verb::kBack},
                                              {"A", Verb::kLeft},
                                              {"D", Verb::kRight},
                                              {"Q", Verb::kTurnLeft},
                                              {"E", Verb::kTurnRight},
                                              {"Z", Verb::kStop},
                                              {"ACL:ON", Verb::kHeadingOn},
                                              {"ACL:OF", Verb::kHeadingOff},
                                              {"ANG:-90", Verb::kHeading},
                                              {"RPY:ON", Verb::kReportOn},
                                              {"RPY:OFF", Verb::kReportOff},
                                              {"MOT:1,2,3,4", Verb::kServos},
                                              {"CA", Verb::kCalibrate},
                                              {"VA", Verb::kValues},
                                              {"BEG", Verb::kNothing},
                                              {"END", Verb::kNothing},
                                              {"IVA", Verb::kNothing},
                                              {"TES:1,2,3,4,5,6,7,8", Verb::kTest}};
  for (const auto& [text, verb] : all) {
    INFO(text);
    CHECK(verbs(text) == std::vector<Verb>{verb});
  }
  CHECK(host.bad_messages() == 0);
}

TEST_CASE_METHOD(Fixture, "numbers") {
  verbs("TES:1500,1100,-3,4,5,6,7,1900");
  CHECK(last.value[0] == 1500);
  CHECK(last.value[2] == -3);
  CHECK(last.value[7] == 1900);
  verbs("ANG:-179");
  CHECK(last.value[0] == -179);
}

TEST_CASE_METHOD(Fixture, "messages the reader saw as one are all taken") {
  CHECK(verbs("WUPDNE") == std::vector<Verb>{Verb::kForward, Verb::kUp, Verb::kDown, Verb::kTurnRight});
  CHECK(verbs(" W\r\nUP\r\n") == std::vector<Verb>{Verb::kForward, Verb::kUp});
  CHECK(verbs("ACA") == std::vector<Verb>{Verb::kLeft, Verb::kCalibrate});
  CHECK(verbs("DDN") == std::vector<Verb>{Verb::kRight, Verb::kDown});
  CHECK(verbs("H:100ON") == std::vector<Verb>{Verb::kDepth, Verb::kOn});
}

TEST_CASE_METHOD(Fixture, "a message that arrives over several reads counts when the line falls silent") {
  host::usart6.feed(now(), "ACL:ON");
  host::advance(uart.wire_time(3));
  CHECK(take().empty());
  host::advance(1 * kMillisecond);
  CHECK(take() == std::vector<Verb>{Verb::kHeadingOn});
}

TEST_CASE_METHOD(Fixture, "a message with anything wrong in it does nothing at all") {
  for (const char* text : {"WX", "on", "H:", "H:x", "H:40000", "H:-", "TES:1,2,3", "TES:1,2,3,4,5,6,7,",
                           "ACL:", "ONH:", "MOT:1,2,3,4,5", ":", "W:"}) {
    INFO(text);
    CHECK(verbs(text).empty());
  }
  CHECK(host.bad_messages() == 13);
  CHECK(verbs("W") == std::vector<Verb>{Verb::kForward});
}

TEST_CASE_METHOD(Fixture, "a message that is too long is dropped whole, and the next one is taken") {
  CHECK(verbs(std::string(150, 'W')).empty());
  CHECK(verbs("S") == std::vector<Verb>{Verb::kBack});
  CHECK(verbs(std::string(100, 'W')).size() == 100);
}

TEST_CASE_METHOD(Fixture, "a message with a line error is dropped") {
  host::usart6.feed(now(), "ON");
  host::usart6.disturb(1);
  host::advance(5 * kMillisecond);
  CHECK(take().empty());
  CHECK(host.bad_messages() == 1);
  CHECK(verbs("ON") == std::vector<Verb>{Verb::kOn});
}

TEST_CASE_METHOD(Fixture, "any bytes at all leave it working") {
  std::uint32_t random = 7;
  for (int round = 0; round < 500; ++round) {
    std::vector<std::uint8_t> noise;
    random = random * 1664525 + 1013904223;
    for (std::uint32_t i = 0; i < random >> 25; ++i) {
      random = random * 1664525 + 1013904223;
      noise.push_back(static_cast<std::uint8_t>(random >> 24));
    }
    host::usart6.feed(now(), noise);
    host::advance(20 * kMillisecond);
    take();
  }
  CHECK(verbs("OFF") == std::vector<Verb>{Verb::kOff});
}

TEST_CASE_METHOD(Fixture, "what the operator's program sends every 10 ms is obeyed as it comes") {
  const std::string some = "TES:1500,1500,1400,1600,1500,1500,1400,1600\r\n";
  const std::string more = "MOT:1500,1500,1500,1500\r\nH:12345\r\nANG:-179\r\n";
  FinsRovOrder order;
  int obeyed = 0;
  for (int message = 0; message < 100; ++message) {
    host::usart6.feed(now(), message % 2 == 0 ? some + some : more + more);
    host::advance(10 * kMillisecond);
    if (!host.receive(uart)) continue;
    for (unsigned left = FinsRovHost::kMostOrders; left != 0 && host.next(order); --left) {
      if (order.verb != Verb::kNothing) ++obeyed;
    }
  }
  CHECK(obeyed == 50 * (2 + 6));
  CHECK(host.bad_messages() == 0);
  CHECK(uart.counters().lost == 0);
}
