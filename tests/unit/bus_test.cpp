// Records of the kinds of bus, and the rules by which ports make rates.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "catch.hpp"
#include "generator/bus/bus_type.hpp"
#include "generator/bus/line_format.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using namespace finemote::gen;
using finemote::test::read;

namespace {

const fs::path kSource = finemote::test::source_dir();

}  // namespace

TEST_CASE("every kind of bus has one record, under its name") {
  for (const BusType* type : bus_types()) {
    INFO(type->name);
    CHECK(&bus_type(type->kind) == type);
    CHECK(bus_kind(type->name) == type->kind);
  }
  CHECK(bus_types().size() == static_cast<std::size_t>(BusKind::virtual_bus) + 1);
  CHECK_FALSE(bus_kind("usb"));
}

TEST_CASE("the record of a kind agrees with itself and with the runtime") {
  for (const BusType* type : bus_types()) {
    INFO(type->name);
    CHECK((type->reach == BusType::Reach::slot) == !type->slot_class.name.empty());
    CHECK((type->rate.form == nullptr) == (type->unit == nullptr));
    CHECK((type->flush == BusType::Flush::shared_frames) == (type->most_shared_frames > 0));
    if (type->bus_class.name.empty()) continue;
    const std::string_view header = type->bus_class.header;
    const std::string text = read(kSource / "runtime/include" / fs::path(header.substr(1, header.size() - 2)));
    CHECK(text.find("class " + std::string(type->bus_class.name) + " ") != std::string::npos);
    if (!type->slot_class.name.empty()) CHECK(text.find(std::string(type->slot_class.name)) != std::string::npos);
  }
}

TEST_CASE("a rate is written in the attribute and the units of its kind") {
  CHECK(rate_attribute(BusKind::spi) == "clock");
  CHECK(rate_attribute(BusKind::pwm).empty());
  CHECK(rate_text(BusKind::i2c, 400'000) == "400kHz");
  CHECK(rate_text(BusKind::can, 1'000'000) == "1Mbit/s");
  CHECK(rate_text(BusKind::spi, 328'125) == "328125Hz");
  CHECK(rate_text(BusKind::rs485, 3'000'000) == "3000000baud");
  for (const RateForm* form : rate_forms()) CHECK(std::is_sorted(form->usual.begin(), form->usual.end()));
}

TEST_CASE("a unit takes what its bytes and the frames around them take") {
  using Figures = std::tuple<std::int64_t, std::int64_t, std::int64_t>;  // bits, steps, ends
  const auto unit = [](BusKind kind, std::int64_t write, std::int64_t read, Mover mover = Mover::routine) -> Figures {
    const WireUnit use = bus_type(kind).unit({write, read, 10, mover});
    return {use.bits, use.steps, use.ends};
  };
  CHECK(unit(BusKind::uart, 3, 5) == Figures{80, 0, 1});
  CHECK(unit(BusKind::rs485, 3, 5) == Figures{80, 1, 1});
  CHECK(unit(BusKind::i2c, 1, 3) == Figures{2 + 19 + 37, 3 + 5, 1});
  CHECK(unit(BusKind::spi, 2, 9) == Figures{72, 9, 1});
  CHECK(unit(BusKind::spi, 2, 9, Mover::dma) == Figures{72, 0, 1});
  CHECK(unit(BusKind::can, 0, 0) == Figures{55, 0, 1});
  CHECK(unit(BusKind::can, 9, 0) == Figures{135 + 65, 0, 2});
  CHECK(unit(BusKind::i2c, 0, 0) == Figures{2 + 10, 2, 1});  // an address that is asked whether somebody answers
}

TEST_CASE("on CAN an answer is asked for by a frame, which may be without data; what a part sends by itself is not") {
  const WireUnit polled = bus_type(BusKind::can).unit({.read = 8}), written = bus_type(BusKind::can).unit({1, 8});
  CHECK(polled.bits == 55 + 135);
  CHECK(polled.ends == 1);
  CHECK(polled.answers == 1);
  CHECK(written.bits == 65 + 135);
  const WireUnit sent = bus_type(BusKind::can).unit({.read = 8, .is_asked_for = false});
  CHECK(sent.bits == 135);
  CHECK(sent.ends == 1);
  CHECK(sent.answers == 0);
}

TEST_CASE("a port makes the rate that its rule puts nearest to the one asked for") {
  const auto made = [](const char* rule, double clock, double wanted) {
    return std::llround(rate_rule(rule)->nearest(clock, wanted));
  };
  CHECK(made("stm32_usart", 84e6, 115'200) == 115'226);
  CHECK(made("stm32_usart", 84e6, 9e6) == 5'250'000);
  CHECK(made("stm32_i2c", 42e6, 400'000) == 400'000);
  CHECK(made("stm32_i2c", 42e6, 100'000) == 100'000);
  CHECK(made("stm32_spi", 84e6, 5e6) == 5'250'000);
  CHECK(made("stm32_can", 42e6, 800'000) == 750'000);
  CHECK(rate_rule("stm32_spi")->all(42'000'000).back() == 164'062);
  CHECK(rate_rule("by magic") == nullptr);
  CHECK(rate_rule("stm32_i2c")->slowest(42'000'000, 400'000) == 357'142);  // 105 clocks and 300 ns of rise
  CHECK(rate_rule("stm32_i2c")->slowest(42'000'000, 100'000) == 79'846);   // lowered to 87 kHz: 484 clocks and 1000 ns
  CHECK(rate_rule("stm32_spi")->slowest(84'000'000, 334'500) == 328'125);
  CHECK(rate_rule("stm32_spi")->slowest(84'000'000, 5'200'000) == 2'625'000);  // never faster than asked for
  CHECK(rate_rule("stm32_spi")->slowest(84'000'000, 100'000) == 100'000);      // the slowest there is, 328 kHz
  CHECK(rate_rule("stm32_can")->slowest(42'000'000, 1'010'000) == 1'000'000);
}

TEST_CASE("the schema of board files names the rules there are") {
  const auto schema = nlohmann::json::parse(read(kSource / "schemas/board.schema.json"));
  const auto& port = schema.at("properties").at("ports").at("items").at("properties");
  CHECK(port.at("rate_rule").at("enum").get<std::vector<std::string>>() == rate_rule_names());
}

TEST_CASE("a line format is read as it is written") {
  CHECK(line_format("8N1").bits_per_byte() == 10);
  CHECK(line_format("8E2").bits_per_byte() == 12);
  CHECK_FALSE(line_format("8E2").is_inverted);
  CHECK(line_format("8E1_inverted").is_inverted);
  CHECK(line_format("8E1_inverted").bits_per_byte() == 11);
}
