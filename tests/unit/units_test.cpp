#include "generator/units/units.hpp"

#include <clocale>
#include <cstdlib>
#include <limits>

#include "catch.hpp"
#include "unit/duration_literals.hpp"

using namespace finemote::gen;
using namespace finemote::gen::units;

namespace {

template <typename T>
void accepts(const Result<T>& result, T value) {
  REQUIRE(static_cast<bool>(result));
  CHECK(*result == value);
}

template <typename T>
void refuses(const Result<T>& result, Code code, const std::string& message, const std::string& hint) {
  REQUIRE_FALSE(static_cast<bool>(result));
  CHECK(result.fault().code.number == code.number);
  CHECK(result.fault().message == message);
  CHECK(result.fault().hint == hint);
}

}  // namespace

TEST_CASE("quantities are exact in the base unit") {
  accepts(parse_duration("5ms"), 5_ms);
  accepts(parse_duration("5 ms"), 5_ms);
  accepts(parse_duration("2.5us"), 2500_ns);
  accepts(parse_duration("0.10 us"), 100_ns);
  accepts(parse_duration("0.000000001s"), 1_ns);
  accepts(parse_duration("1.000ns"), 1_ns);
  accepts(parse_duration("007ms"), 7_ms);
  accepts(parse_duration("9223372036854775807ns"), Duration::max());
  accepts(parse_frequency("400kHz"), std::int64_t{400'000});
  accepts(parse_frequency("10.5MHz"), std::int64_t{10'500'000});
  accepts(parse_bitrate("921600baud"), std::int64_t{921'600});
  accepts(parse_bitrate("1Mbit/s"), std::int64_t{1'000'000});
  accepts(parse_bits("20bit"), std::int64_t{20});
  accepts(parse_percent("40%"), 0.4);
  accepts(parse_percent("33.3 %"), 0.333);
}

TEST_CASE("a quantity without unit, or with another one, says what to write") {
  refuses(parse_duration("5"), code::unit_missing, "'5' has no unit, expected a duration",
          "write '5ms'; units are ns, us, ms, s");
  refuses(parse_bits("20"), code::unit_missing, "'20' has no unit, expected a number of bits", "write '20bit'");
  refuses(parse_duration("5Ms"), code::unit_wrong, "'Ms' is not a unit of a duration",
          "units are case-sensitive: write '5ms'");
  refuses(parse_duration("5min"), code::unit_wrong, "'min' is not a unit of a duration", "units are ns, us, ms, s");
  refuses(parse_frequency("400khz"), code::unit_wrong, "'khz' is not a unit of a frequency",
          "units are case-sensitive: write '400kHz'");
  refuses(parse_duration("400kHz"), code::unit_wrong, "'kHz' is not a unit of a duration",
          "write '2500ns'; units are ns, us, ms, s");
}

TEST_CASE("a rate for a period, and quantities of other neighbours, are offered converted where that is exact") {
  const std::string times = "units are ns, us, ms, s";
  refuses(parse_duration("500Hz"), code::unit_wrong, "'Hz' is not a unit of a duration", "write '2ms'; " + times);
  refuses(parse_duration("1khz"), code::unit_wrong, "'khz' is not a unit of a duration", "write '1ms'; " + times);
  refuses(parse_duration("300Hz"), code::unit_wrong, "'Hz' is not a unit of a duration", times);
  refuses(parse_duration("0Hz"), code::unit_wrong, "'Hz' is not a unit of a duration", times);
  refuses(parse_frequency("20ms"), code::unit_wrong, "'ms' is not a unit of a frequency",
          "write '50Hz'; units are Hz, kHz, MHz");
  refuses(parse_frequency("400kbit/s"), code::unit_wrong, "'kbit/s' is not a unit of a frequency",
          "write '400kHz'; units are Hz, kHz, MHz");
  refuses(parse_bitrate("1MHz"), code::unit_wrong, "'MHz' is not a unit of a bit rate",
          "write '1Mbit/s'; units are bit/s, kbit/s, Mbit/s, baud");
}

TEST_CASE("a value in another unit than its param's is offered converted") {
  accepts(parse_real("0.076", "m"), 0.076);
  accepts(parse_real("0.076m", "m"), 0.076);
  accepts(parse_real("0.3 N m", "N m"), 0.3);
  accepts(parse_integer("5rad", "rad"), std::int64_t{5});
  refuses(parse_real("5cm^2", "m^2"), code::unit_wrong, "'5cm^2' is not a number in 'm^2'", "the unit is m^2");
  refuses(parse_real("76mm", "m"), code::unit_wrong, "'76mm' is not a number in 'm'", "write '0.076 m'; the unit is m");
  refuses(parse_real("7.6 cm", "m"), code::unit_wrong, "'7.6 cm' is not a number in 'm'",
          "write '0.076 m'; the unit is m");
  refuses(parse_real("-90deg", "rad"), code::unit_wrong, "'-90deg' is not a number in 'rad'",
          "write '-1.57079632679 rad'; the unit is rad");
  refuses(parse_real("3000rpm", "rad/s"), code::unit_wrong, "'3000rpm' is not a number in 'rad/s'",
          "write '314.159265359 rad/s'; the unit is rad/s");
  refuses(parse_real("0.3Nm", "N m"), code::unit_wrong, "'0.3Nm' is not a number in 'N m'",
          "write '0.3 N m'; the unit is N m");
  refuses(parse_real("300mN*m", "N m"), code::unit_wrong, "'300mN*m' is not a number in 'N m'",
          "write '0.3 N m'; the unit is N m");
  refuses(parse_real("1013mbar", "Pa"), code::unit_wrong, "'1013mbar' is not a number in 'Pa'",
          "write '101300 Pa'; the unit is Pa");
  refuses(parse_real("3parsec", "m"), code::unit_wrong, "'3parsec' is not a number in 'm'", "the unit is m");
  refuses(parse_real("12%", ""), code::unit_wrong, "'12%' has a unit, expected a number without one", "write '0.12'");
  refuses(parse_real("5V", "1"), code::unit_wrong, "'5V' has a unit, expected a number without one", "");
  refuses(parse_integer("76mm", "m"), code::unit_wrong, "'76mm' is not a whole number in 'm'", "the unit is m");
  refuses(parse_real("0,076", "m"), code::quantity_malformed, "'0,076' is not a number", "write '0.076'");
  refuses(parse_real("5 1", "1"), code::quantity_malformed, "'5 1' is not a number", "");
  refuses(parse_real("0x10", ""), code::quantity_malformed, "'0x10' is not a number", "");
}

TEST_CASE("what is no quantity at all") {
  const std::string hint = "write a number and a unit, for example '10ms'";
  refuses(parse_duration(""), code::quantity_malformed, "empty value, expected a duration", hint);
  refuses(parse_duration("-5ms"), code::quantity_malformed, "'-5ms' is negative, expected a duration", hint);
  for (const std::string text : {"5  ms", " 5ms", "5ms ", "5 ms "})
    CHECK(parse_duration(text).fault().hint == "write '5ms'");
  CHECK(parse_duration("5 6ms").fault().hint == hint);  // not 56ms
  for (const std::string text : {"ms", "5  ms", " 5ms", "5ms ", "5.ms", ".5ms", "5,5ms", "1e3ms", "+5ms", "5\tms",
                                 "5 6ms", "0x5ms", "5.5.5ms", "5 "}) {
    INFO(text);
    const auto result = parse_duration(text);
    REQUIRE_FALSE(static_cast<bool>(result));
    const std::uint16_t number = result.fault().code.number;
    CHECK((number == code::quantity_malformed.number || number == code::unit_wrong.number));
  }
}

TEST_CASE("a number without unit is offered with one that brings it into the range") {
  const auto meant = [](const std::string& text, double least, double most) {
    return with_meant_unit(parse_frequency(text).fault(), text, {"kHz", "Hz", "MHz"}, parse_frequency, least, most)
        .hint;
  };
  CHECK(meant("50", 24, 1526) == "write '50Hz'; units are Hz, kHz, MHz");
  CHECK(meant("50", 1e3, 1e6) == "write '50kHz'; units are Hz, kHz, MHz");
  CHECK(meant("50", 1, 2) == "units are Hz, kHz, MHz");
  CHECK(meant("50K", 1, 1e9) == parse_frequency("50K").fault().hint);
}

TEST_CASE("values that are not whole or do not fit are errors, never rounded") {
  const std::string widest = "values fit 63 bits in their base unit, bare numbers 32 bits";
  refuses(parse_duration("0.5ns"), code::quantity_inexact, "'0.5ns' is not a whole number of ns", "write '0ns'");
  refuses(parse_frequency("0.0001kHz"), code::quantity_inexact, "'0.0001kHz' is not a whole number of Hz",
          "write '0Hz'");
  refuses(parse_duration("9223372036854775808ns"), code::quantity_overflow, "'9223372036854775808ns' is too large",
          widest);
  refuses(parse_duration("9223372037s"), code::quantity_overflow, "'9223372037s' is too large", widest);
  const std::string many(200, '9');
  CHECK(parse_duration(many + "s").fault().code == code::quantity_overflow);
  CHECK(parse_duration("0." + many + "s").fault().code == code::quantity_inexact);
}

TEST_CASE("bare integers are decimal or hexadecimal") {
  accepts(parse_bare("118"), std::uint32_t{118});
  accepts(parse_bare("0x76"), std::uint32_t{0x76});
  accepts(parse_bare("0X7f"), std::uint32_t{0x7f});
  accepts(parse_bare("010"), std::uint32_t{10});
  for (const std::string text : {"", "0x", "-1", "+1", " 1", "1 ", "0x7g", "1.0", "five", "76h"}) {
    INFO(text);
    CHECK(parse_bare(text).fault().code == code::bare_integer);
  }
  CHECK(parse_bare("4294967296").fault().code == code::quantity_overflow);
}

TEST_CASE("numbers of params without conversion") {
  accepts(parse_integer("-5"), std::int64_t{-5});
  accepts(parse_integer("0x10"), std::int64_t{16});
  accepts(parse_real("-1.5e-3"), -1.5e-3);
  accepts(parse_real("+2"), 2.0);
  CHECK(parse_integer("1.5").fault().code == code::quantity_malformed);
  CHECK(parse_real("nan").fault().code == code::quantity_malformed);
  CHECK(parse_real("inf").fault().code == code::quantity_malformed);
  CHECK(parse_real("1e999").fault().code == code::quantity_overflow);
}

TEST_CASE("no locale is consulted") {
  setenv("LOCPATH", FINEMOTE_LOCALES, 1);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    WARN("there is no locale de_DE.UTF-8");
    return;
  }
  REQUIRE(std::string(std::localeconv()->decimal_point) == ",");
  accepts(parse_real("1.5"), 1.5);
  accepts(parse_percent("2.5%"), 0.025);
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("durations are written in the largest unit that divides them") {
  CHECK(format_duration(10_ms) == "10ms");
  CHECK(format_duration(2500_us) == "2500us");
  CHECK(format_duration(2000_ms) == "2s");
  CHECK(format_duration(17_ns) == "17ns");
  CHECK(format_duration(Duration::zero()) == "0s");
  CHECK(spaced_duration(2500_us) == "2500 us");
  CHECK(readable_duration(10_ms) == "10ms");
  CHECK(readable_duration(2'500'001_ns) == "2.500001ms");
  CHECK(readable_duration(87'060_ns) == "87.06us");
  CHECK(readable_duration(999_ns) == "999ns");
  CHECK(readable_duration(Duration::zero()) == "0s");
  for (const std::int64_t ns : {1LL, 1'500LL, 123'456'789LL, 10'000'000'001LL, 9'223'372'036'854'775'807LL})
    CHECK(*parse_duration(readable_duration(nanoseconds(ns))) == nanoseconds(ns));
}
