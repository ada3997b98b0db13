// Serial line: nothing lost, nothing torn, and what is lost is counted.
#include "finemote/uart.hpp"

#include <numeric>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

struct Fixture {
  Fixture() {
    bench::reset();
    uart.start();
  }
  Bytes read(std::size_t capacity = 600) {
    Bytes bytes(capacity);
    bytes.resize(uart.read(bytes.data(), capacity));
    return bytes;
  }
  static Bytes count(std::size_t size, std::uint8_t first = 0) {
    Bytes bytes(size);
    std::iota(bytes.begin(), bytes.end(), first);
    return bytes;
  }

  UartHardware& line = host::usart1;
  std::uint8_t ring[256];
  Uart uart{ports::usart1, 115200, ring};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "bytes come in order over many laps of the ring") {
  Bytes all, sent;
  for (int block = 0; block < 40; ++block) {
    const Bytes bytes = count(73, static_cast<std::uint8_t>(block * 5));
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    line.feed(now(), bytes);
    host::advance(7 * kMillisecond);
    const Bytes part = read();
    all.insert(all.end(), part.begin(), part.end());
  }
  CHECK(all == sent);
  CHECK(uart.counters().lost == 0);
}

TEST_CASE_METHOD(Fixture, "a read in the middle of a frame gives the part that has arrived") {
  line.feed(0, count(10));
  host::advance(5 * uart.wire_time(1) + 100 * kMicrosecond);
  CHECK(read() == count(6));
  CHECK_FALSE(uart.idle());
  host::advance(10 * kMillisecond);
  CHECK(read() == count(4, 6));
  CHECK(uart.idle());
}

TEST_CASE_METHOD(Fixture, "a silence behind what was read stays one, whatever comes since") {
  line.feed(0, count(10));
  host::advance(5 * kMillisecond);
  REQUIRE(read() == count(10));
  const Time last = uart.arrival();
  line.feed(now(), count(10, 10));
  host::advance(2 * uart.wire_time(1));  // the start of the next message
  CHECK(uart.idle());
  CHECK(uart.arrival() == last);
  host::advance(5 * kMillisecond);  // all of it, and the silence after it
  CHECK(uart.idle());
  CHECK(uart.arrival() == last);
  REQUIRE(read() == count(10, 10));
  CHECK(uart.idle());
  CHECK(uart.arrival() > last);
}

TEST_CASE_METHOD(Fixture, "a reader that comes too late loses old bytes, counted, and reads whole new ones") {
  line.feed(0, count(256));
  line.feed(0, count(100));
  host::advance(40 * kMillisecond);
  const Bytes bytes = read();
  CHECK(bytes.size() == 128);
  CHECK(bytes.back() == 99);
  CHECK(bytes.front() == 228);
  CHECK(uart.counters().lost == 356 - 128);
}

TEST_CASE_METHOD(Fixture, "a small buffer leaves the rest for the next read") {
  line.feed(0, count(10));
  host::advance(5 * kMillisecond);
  CHECK(read(4) == count(4));
  CHECK(read(4) == count(4, 4));
  CHECK(read(4) == count(2, 8));
}

TEST_CASE_METHOD(Fixture, "arrival is never later than the bytes arrived") {
  line.feed(2 * kMillisecond, count(10));
  host::advance(1 * kMillisecond);
  CHECK(read().empty());
  const Duration byte = 10 * kSecond / 115200;
  host::advance(1 * kMillisecond + 10 * byte + byte / 2);  // the line is not yet seen idle
  REQUIRE(read().size() == 10);
  const Time last = 2 * kMillisecond + 10 * byte;
  CHECK(uart.arrival() <= last);
  CHECK(uart.arrival() > last - 2 * byte);  // else the line would have been silent by then, or a byte would have come
  line.feed(now(), count(10));
  const Time sent = now() + 10 * byte;
  host::advance(20 * kMillisecond);
  REQUIRE(read().size() == 10);
  CHECK(uart.arrival() <= sent);
  CHECK(uart.arrival() > sent - byte);
}

TEST_CASE_METHOD(Fixture, "the arrival of a byte with others behind it is never later than that of the byte") {
  const Duration byte = 10 * kSecond / 115200;
  line.feed(2 * kMillisecond, count(10));
  line.feed(5 * kMillisecond, count(6));
  host::advance(5 * kMillisecond + 6 * byte + byte / 2);  // the line is not yet seen idle
  REQUIRE(read().size() == 16);
  const Time tenth = 2 * kMillisecond + 10 * byte;
  CHECK(uart.arrival() > tenth + 5 * byte);  // six bytes after the silence
  CHECK(uart.arrival() <= 5 * kMillisecond + 6 * byte);
  CHECK(uart.arrival(6) <= tenth);  // the silence came after it
  CHECK(uart.arrival(6) > tenth - byte);
  CHECK(uart.arrival(10) < 2 * kMillisecond);  // nothing is known but that it came after the beginning
  host::advance(byte);
  read();
  CHECK(uart.arrival() > 5 * kMillisecond + 5 * byte);  // now it is known
}

TEST_CASE_METHOD(Fixture, "reception that stopped is started again and old bytes are not read as new") {
  line.feed(0, count(10));
  host::advance(2 * kMillisecond);
  CHECK(read() == count(10));
  line.halt_reception();
  line.feed(now(), count(20, 50));
  host::advance(5 * kMillisecond);
  CHECK(read().empty());
  CHECK(uart.counters().recoveries == 1);
  const Time restarted = now();
  line.feed(now(), count(3, 100));
  host::advance(2 * uart.wire_time(1) + uart.wire_time(1) / 2);
  CHECK(read() == count(2, 100));
  CHECK(uart.arrival() > restarted);
  CHECK(uart.arrival() <= restarted + 2 * uart.wire_time(1));
  host::advance(5 * kMillisecond);
  CHECK(read() == count(1, 102));
}

TEST_CASE_METHOD(Fixture, "one block is sent at a time; one that never leaves is given up") {
  const Bytes block = count(20);
  CHECK(uart.write(block.data(), block.size()));
  CHECK_FALSE(uart.write(block.data(), block.size()));
  host::advance(2 * kMillisecond);
  CHECK(uart.write(block.data(), 5));
  REQUIRE(line.sent.size() == 2);
  CHECK(line.sent[0].bytes == block);
  host::advance(2 * kMillisecond);
  CHECK_FALSE(uart.write(block.data(), uart.capacity() + 1));
  CHECK_FALSE(uart.write(block.data(), 0));

  line.block_sending(true);
  CHECK(uart.write(block.data(), block.size()));
  host::advance(3 * kMillisecond);
  CHECK_FALSE(uart.write(block.data(), block.size()));
  host::advance(3 * kMillisecond);
  line.block_sending(false);
  CHECK(uart.write(block.data(), block.size()));
  CHECK(uart.counters().overdue == 1);
}

TEST_CASE_METHOD(Fixture, "an update gets no more bytes than its line allows it, and the next one the others") {
  std::uint8_t other_ring[256];
  Uart limited{ports::usart1, 115200, other_ring, UartFormat::k8N1, {16, 20}};
  limited.start();
  const auto update = [&](std::size_t capacity) {
    Bytes all, bytes(capacity);
    limited.read_all(bytes.data(), capacity, [&](std::size_t size) {
      all.insert(all.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    });
    return all;
  };
  line.feed(now(), count(50));
  host::advance(10 * kMillisecond);
  CHECK(update(16) == count(20));
  CHECK_FALSE(limited.idle());
  CHECK(update(20) == count(20, 20));  // its second read brings none
  CHECK(update(16) == count(10, 40));
  CHECK(limited.idle());
}
