// What the models of parts make of tags: bytes of a sample carry its number, outputs tell where their bytes come from.
#include "catch.hpp"
#include "emulator/parts/bmi088.hpp"
#include "emulator/parts/dji_motor.hpp"
#include "emulator/parts/ist8310.hpp"
#include "emulator/parts/ms5837.hpp"
#include "emulator/parts/pca9685.hpp"
#include "emulator/parts/register_bank.hpp"
#include "emulator/parts/tca9548a.hpp"
#include "tests/emulator/motor_line.hpp"

using namespace finemote::emulator;

namespace {

constexpr Time kMs = from_ns(1'000'000);

/// Numbers samples from 1 on.
struct Counter {
  Tag next() { return Tag{++count}; }
  unsigned count = 0;
};

void send(I2cLine& line, std::uint8_t address, const std::vector<WireByte>& bytes) {
  REQUIRE(line.select(address, false));
  for (const WireByte byte : bytes) line.write(byte);
  line.stop();
}

std::vector<Tag> tags_read(I2cLine& line, std::uint8_t address, unsigned count) {
  REQUIRE(line.select(address, true));
  std::vector<Tag> tags;
  for (unsigned i = 0; i < count; ++i) tags.push_back(line.read().tag);
  line.stop();
  return tags;
}

}  // namespace

TEST_CASE("a pressure carries the number of its conversion, a temperature and an early read carry none") {
  Time now = 0;
  Counter samples;
  Ms5837 part(
      Ms5837::Variant::k30BA, [&] { return now; }, [](Time) { return 101'325.0; });
  std::vector<Time> from;
  part.on_sample = [&](Time at) {
    from.push_back(at);
    return samples.next();
  };
  I2cLine line;
  line.attach(part);
  now = 20 * kMs;
  send(line, 0x76, {0x48});
  send(line, 0x76, {0x00});
  CHECK(tags_read(line, 0x76, 3) == std::vector<Tag>(3, Tag::none));  // not done
  send(line, 0x76, {0x48});
  now = 40 * kMs;
  send(line, 0x76, {0x00});
  CHECK(tags_read(line, 0x76, 3) == std::vector<Tag>(3, Tag{2}));
  send(line, 0x76, {0x58});
  now = 60 * kMs;
  send(line, 0x76, {0x00});
  CHECK(tags_read(line, 0x76, 3) == std::vector<Tag>(3, Tag::none));
  CHECK(from == std::vector<Time>{20 * kMs, 20 * kMs});
}

TEST_CASE("the compass's data carry their measurement, its other registers nothing") {
  Time now = 10 * kMs;
  Counter samples;
  EventQueue queue;
  Ist8310 part(0x0E,
               {[&] { return now; }, [&](Time at, EventQueue::Action action) { queue.at(at, std::move(action)); }},
               [](Time) { return Eigen::Vector3d(20e-6, 0, 0); });
  std::vector<Time> from;
  part.on_read = [&](Time at) {
    from.push_back(at);
    return samples.next();
  };
  I2cLine line;
  line.attach(part);
  send(line, 0x0E, {0x0A, 0x01});
  now = 20 * kMs;
  queue.run(now);
  send(line, 0x0E, {0x02});
  const Tag none = Tag::none, first{1};
  CHECK(tags_read(line, 0x0E, 8) == std::vector<Tag>{none, first, first, first, first, first, first, none});
  send(line, 0x0E, {0x03});
  CHECK(tags_read(line, 0x0E, 1)[0] == Tag{2});  // every read is counted, but nothing new was measured
  CHECK(from == std::vector<Time>{10 * kMs, 10 * kMs});
}

TEST_CASE("a part of plain registers numbers its reads and tells of what is written, also behind a mux") {
  Counter samples;
  Tca9548a mux(0x70);
  RegisterBank part(0x20);
  part.on_sample = [&] { return samples.next(); };
  std::vector<Tag> read, written;
  part.on_read = [&](Tag sample) { read.push_back(sample); };
  part.on_write = [&](unsigned, WireByte byte) { written.push_back(byte.tag); };
  I2cLine line;
  line.attach(mux);
  mux.channel(3).attach(part);
  send(line, 0x70, {0x08});
  send(line, 0x20, {0x05, {1, Tag{41}}, {2, Tag{42}}});
  CHECK(written == std::vector<Tag>{Tag{41}, Tag{42}});
  CHECK(tags_read(line, 0x20, 2) == std::vector<Tag>(2, Tag{1}));
  CHECK(tags_read(line, 0x20, 1) == std::vector<Tag>(1, Tag{2}));
  CHECK(read == std::vector<Tag>{Tag{1}, Tag{2}});
}

TEST_CASE("every output of the expander tells where the bytes of its own registers come from") {
  Pca9685 part(0x40);
  I2cLine line;
  line.attach(part);
  std::vector<std::pair<unsigned, Tag>> told;
  part.on_command = [&](unsigned channel, std::uint64_t, Tag origin) { told.emplace_back(channel, origin); };
  send(line, 0x40, {0x00, 0x20});
  told.clear();
  send(line, 0x40, {0x06, 0, 0, {0x33, Tag{5}}, {0x01, Tag{5}}, 0, 0, {0x66, Tag{6}}, {0x02, Tag{6}}});
  CHECK(told == std::vector<std::pair<unsigned, Tag>>{{0, Tag{5}}, {1, Tag{6}}});
  told.clear();  // the same pulse of a later command; the other output is said again
  send(line, 0x40, {0x06, 0, 0, {0x33, Tag{7}}, {0x01, Tag{7}}, 0, 0, {0x66, Tag{6}}, {0x02, Tag{6}}});
  CHECK(told == std::vector<std::pair<unsigned, Tag>>{{0, Tag{7}}});
}

TEST_CASE("a motor's report carries its sample unless it is damaged, and its command comes from its own word") {
  finemote::test::MotorLine motors;
  auto& [world, line, heard, command] = motors;
  DjiMotor::Figures figures;
  figures.word = 1;
  DjiMotor motor(world, line, figures, {});
  Counter samples;
  std::vector<Tag> reports, commands;
  motor.on_sample = [&] { return samples.next(); };
  motor.on_report = [&](Tag sample) { reports.push_back(sample); };
  motor.on_command = [&](int, Tag origin) { commands.push_back(origin); };
  world.queue().run(from_ns(500'000));
  REQUIRE(heard.size() == 1);
  CHECK(heard[0].tags[0] == Tag{1});
  CHECK(reports == std::vector<Tag>{Tag{1}});
  motor.damaged_reports = 1;
  world.queue().run(from_ns(1'500'000));
  REQUIRE(heard.size() == 2);
  CHECK(heard[1].tags[0] == Tag::none);
  CHECK(reports.size() == 1);
  command = CanFrame{0x200, 8, {}, {Tag{1}, Tag{1}, Tag{9}, Tag{9}, Tag{3}, Tag{3}, Tag{12}, Tag{12}}};
  line.request();
  world.queue().run(from_ns(1'900'000));
  CHECK(commands == std::vector<Tag>{Tag{9}});
}

TEST_CASE("rates and acceleration of the inertial sensor are samples of their own") {
  Time now = 0;
  Bmi088 part(
      {[&] { return now; }, [](Time, EventQueue::Action) {}}, [](Time) { return Motion(); }, [](Time) { return 25; });
  SpiPart accelerometer = part.accelerometer(), gyroscope = part.gyroscope();
  const auto tags = [](SpiPart& chip, const std::vector<int>& bytes) {
    std::vector<Tag> tags;
    chip.select(true);
    for (const int byte : bytes) tags.push_back(chip.exchange(static_cast<std::uint8_t>(byte)).tag);
    chip.select(false);
    return tags;
  };
  now = 40 * kMs;
  tags(accelerometer, {0x80, 0, 0});
  tags(accelerometer, {0x7D, 0x04});
  tags(accelerometer, {0x7C, 0x00});
  tags(accelerometer, {0x40, 0xAB});
  Counter samples;
  std::vector<std::pair<Bmi088::Quantity, Tag>> read;
  std::vector<Time> from;
  part.on_sample = [&](Bmi088::Quantity, Time at) {
    from.push_back(at);
    return samples.next();
  };
  part.on_read = [&](Bmi088::Quantity quantity, Tag sample) { read.emplace_back(quantity, sample); };
  now = 52 * kMs;
  CHECK(tags(accelerometer, {0x80, 0, 0}) == std::vector<Tag>(3, Tag::none));  // the identity
  const Tag none = Tag::none;
  CHECK(tags(accelerometer, {0x92, 0, 0, 0, 0, 0, 0, 0, 0}) ==
        std::vector<Tag>{none, none, Tag{1}, Tag{1}, Tag{1}, Tag{1}, Tag{1}, Tag{1}, none});
  CHECK(tags(gyroscope, {0x82, 0, 0, 0, 0, 0, 0}) ==
        std::vector<Tag>{none, Tag{2}, Tag{2}, Tag{2}, Tag{2}, Tag{2}, Tag{2}});
  CHECK(read == std::vector<std::pair<Bmi088::Quantity, Tag>>{{Bmi088::Quantity::acceleration, Tag{1}},
                                                              {Bmi088::Quantity::rates, Tag{2}}});
  CHECK(from == std::vector<Time>{from_ns(51'250'000), 52 * kMs});
}
