// Expressions whose operands are large: what they take is counted, so that they end. Each of these ran for minutes.
#include <string>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand.hpp"

using namespace finemote::gen;

namespace {

/// The error an expansion ends with, where the properties `big` and `other` have these values; empty: none.
std::string said(const std::string& big, const std::string& other, const std::string& expression) {
  const std::string document = "<r xmlns:xacro='x'><xacro:property name='big' value=\"${" + big +
                               "}\"/><xacro:property name='other' value=\"${" + other + "}\"/><a v=\"${" + expression +
                               "}\"/></r>";
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  const SourceFile* file = sources.add(SourceFile{"in.xacro", "in.xacro", document});
  xacro::expand(*file, {}, {}, sources, diagnostics, dependencies);
  for (const Diagnostic& finding : diagnostics.in_file_order()) {
    if (finding.severity == Severity::error) return finding.message;
  }
  return {};
}

bool is_bounded(const std::string& big, const std::string& other, const std::string& expression) {
  const std::string message = said(big, other, expression);
  if (!message.starts_with("the expression needs too many operations")) WARN(expression << ": " << message);
  return message.starts_with("the expression needs too many operations");
}

/// The expression, evaluated a million times.
bool is_bounded_in_a_loop(const std::string& big, const std::string& other, const std::string& expression) {
  return is_bounded(big, other, "len([0 for i in range(1000000) if " + expression + "])");
}

}  // namespace

TEST_CASE("xacro cost: a search counts what it may have to compare") {
  const std::string big = "'a' * 1000000";
  const std::string other = "'a' * 500000 + 'b'";
  for (const char* search : {"other in big", "big.find(other)", "big.rfind('b' + big[:500000])", "big.count(other)",
                             "big.split(other)", "big.partition(other)", "big.replace(other, '')"}) {
    CHECK(is_bounded(big, other, search));
  }
}

TEST_CASE("xacro cost: functions of a text count its length") {
  const std::string big = "'a' * 1000000";
  for (const char* call : {"big.upper()",
                           "big.isalpha()",
                           "big.center(2000000)",
                           "big.splitlines()",
                           "big.startswith('b')",
                           "big.expandtabs()",
                           "'b' in big",
                           "big == other",
                           "big &lt; other",
                           "big + 'b'",
                           "big[1:]",
                           "big[-1]",
                           "len(big)",
                           "python.repr(big)",
                           "dict([(big, 1)])",
                           "big.join(['a', 'b'])",
                           "'%s' % big",
                           "'%1000000d' % 1",
                           "'%.50000f' % 1.5",
                           "'a' * 1000000"}) {
    CHECK(is_bounded_in_a_loop(big, "'a' * 999999 + 'b'", call));
  }
}

TEST_CASE("xacro cost: large integers count their digits") {
  const std::string big = "7 ** 370000";
  for (const char* operation :
       {"7 ** 370000", "big * other", "big // other", "big % other", "big / big", "big + 1", "big >> 1000",
        "1 &lt;&lt; 1000000", "big &amp; other", "-big", "big &lt; big + 1", "'%x' % big", "dict([(big, 1)])",
        "round(big, -3999)", "math.factorial(5000)", "big.bit_length() == str(10 ** 4000)"}) {
    CHECK(is_bounded_in_a_loop(big, "3 ** 1000", operation));
  }
  CHECK(is_bounded(big, "3 ** 370000", "math.gcd(big, other)"));
  CHECK(is_bounded(big, "0", "python.sum([big] * 1000000)"));
}

TEST_CASE("xacro cost: lists and dictionaries count the items they copy and compare") {
  const std::string list = "[1] * 1000000";
  for (const char* operation : {"big == other", "big.reverse()", "big.copy()", "big[1:]", "big + other"}) {
    CHECK(is_bounded_in_a_loop(list, list, operation));
  }
  const std::string table = "dict([(i, i) for i in range(100000)])";
  for (const char* operation : {"big.copy()", "dict(big)", "big | other", "big == other"}) {
    CHECK(is_bounded_in_a_loop(table, table, operation));
  }
  CHECK(is_bounded_in_a_loop("python.set(range(100000))", "0", "big.copy()"));
}

TEST_CASE("xacro cost: ordinary operands cost nothing beside their step") {
  CHECK(said("'left_front_wheel'", "'wheel'", "len([0 for i in range(100000) if other in big + '_link'])").empty());
  CHECK(said("2 ** 64", "3", "python.sum([big * i // other for i in range(100000)]) % 7").empty());
}

TEST_CASE("xacro cost: elements are counted even where no expression is") {
  std::string body;
  for (int i = 0; i < 10'000; ++i) body += "<xacro:if value='true'/>";
  std::string calls;
  for (int i = 0; i < 10'000; ++i) calls += "<xacro:a/>";
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  const std::string document = "<r xmlns:xacro='x'><xacro:macro name='a'>" + body + "</xacro:macro>" + calls + "</r>";
  const SourceFile* file = sources.add(SourceFile{"in.xacro", "in.xacro", document});
  xacro::expand(*file, {}, {}, sources, diagnostics, dependencies);
  CHECK(render_text(diagnostics, false).find("error[FM1011]: the expansion needs too many operations") !=
        std::string::npos);
}
