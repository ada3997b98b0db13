// The expression language: one line per expectation, text on the left, Python's answer on the right.
#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand.hpp"
#include "tests/escaped.hpp"

using namespace finemote::gen;
using finemote::test::escaped;

namespace {

struct Outcome {
  std::string value;    ///< of the attribute; empty after an error
  std::string message;  ///< first line of the report; empty without an error
};

Outcome expand_attribute(const std::string& text) {
  Sources sources;
  Diagnostics diagnostics;
  xacro::Dependencies dependencies;
  const std::string document = "<r xmlns:xacro='x' v=\"" + escaped(text) + "\"/>";
  const SourceFile* file = sources.add(SourceFile{"in.xacro", "in.xacro", document});
  const auto result = xacro::expand(*file, {}, {}, sources, diagnostics, dependencies);
  const std::string report = render_text(diagnostics, false);
  return {result ? result->root.attribute("v")->value : "", report.substr(0, report.find('\n'))};
}

/// The text an expression gives.
std::string value_of(const std::string& expression) {
  const Outcome outcome = expand_attribute("${" + expression + "}");
  CAPTURE(expression, outcome.message);
  return outcome.value;
}

/// The message an expression gives.
std::string error_of(const std::string& expression) {
  const Outcome outcome = expand_attribute("${" + expression + "}");
  CHECK(outcome.value.empty());
  const std::string tail = " when evaluating expression '" + expression + "'";
  const auto begin = outcome.message.find("]: ");
  const auto end = outcome.message.rfind(tail);
  if (begin == std::string::npos || end == std::string::npos) return outcome.message;
  return outcome.message.substr(begin + 3, end - begin - 3);
}

}  // namespace

TEST_CASE("xacro expression: integers have no bound and floor as Python's do") {
  CHECK(value_of("2**100") == "1267650600228229401496703205376");
  CHECK(value_of("-7//2") == "-4");
  CHECK(value_of("-7%3") == "2");
  CHECK(value_of("7%-3") == "-2");
  CHECK(value_of("10**25//3") == "3333333333333333333333333");
  CHECK(value_of("-(10**25)//3") == "-3333333333333333333333334");
  CHECK(value_of("-(10**25)%7") == std::to_string(7 - 3));
  CHECK(value_of("9223372036854775807+1") == "9223372036854775808");
  CHECK(value_of("-9223372036854775808-1") == "-9223372036854775809");
  CHECK(value_of("(2**64) >> 60") == "16");
  CHECK(value_of("-1 >> 100") == "-1");
  CHECK(value_of("-5 & 3") == "3");
  CHECK(value_of("(2**70) ^ -1") == "-1180591620717411303425");
  CHECK(value_of("0x1F + 0o17 + 0b11 + 1_000") == "1049");
  CHECK(value_of("True + True") == "2");
  CHECK(value_of("int('ff', 16)") == "255");
  CHECK(value_of("int(' -1_0 ')") == "-10");
  CHECK(value_of("10**30/10**10") == "1e+20");
  CHECK(value_of("(10**400)/(10**399)") == "10.0");
  CHECK(value_of("2**-2") == "0.25");
}

TEST_CASE("xacro expression: floats print as Python prints them") {
  CHECK(value_of("0.1+0.2") == "0.30000000000000004");
  CHECK(value_of("1e16") == "1e+16");
  CHECK(value_of("1e15") == "1000000000000000.0");
  CHECK(value_of("0.0001") == "0.0001");
  CHECK(value_of("0.00001") == "1e-05");
  CHECK(value_of("-0.0") == "-0.0");
  CHECK(value_of("1e400") == "inf");
  CHECK(value_of("-1e400") == "-inf");
  CHECK(value_of("inf-inf") == "nan");
  CHECK(value_of("5e-324") == "5e-324");
  CHECK(value_of("1e-400") == "0.0");
  CHECK(value_of("123456789.0*10") == "1234567890.0");
  CHECK(value_of("7.5//2") == "3.0");
  CHECK(value_of("-7.5%2") == "0.5");
  CHECK(value_of("float(2**70)") == "1.1805916207174113e+21");
}

TEST_CASE("xacro expression: rounding is half to even, and exact") {
  CHECK(value_of("round(2.5)") == "2");
  CHECK(value_of("round(-3.5)") == "-4");
  CHECK(value_of("round(2.675, 2)") == "2.67");
  CHECK(value_of("round(1234.5, -2)") == "1200.0");
  CHECK(value_of("round(1250, -2)") == "1200");
  CHECK(value_of("round(1350, -2)") == "1400");
  CHECK(value_of("round(1e20)") == "100000000000000000000");
  CHECK(value_of("'%.0f' % 0.5") == "0");
  CHECK(value_of("'%.2f' % 1.005") == "1.00");
}

TEST_CASE("xacro expression: operators bind as in Python") {
  CHECK(value_of("-2**2") == "-4");
  CHECK(value_of("2**3**2") == "512");
  CHECK(value_of("2**-1") == "0.5");
  CHECK(value_of("1 + 2 * 3 - 4 / 2") == "5.0");
  CHECK(value_of("not 1 == 2") == "True");
  CHECK(value_of("1 < 2 < 3") == "True");
  CHECK(value_of("3 > 2 > 2") == "False");
  CHECK(value_of("0 or 'x' and 'y'") == "y");
  CHECK(value_of("1 if 0 else 2 if 0 else 3") == "3");
  CHECK(value_of("1 | 2 ^ 3 & 4 << 1") == "3");
  CHECK(value_of("'a' not in 'abc'") == "False");
  CHECK(value_of("None is not None") == "False");
  CHECK(value_of("1, 2") == "(1, 2)");
  CHECK(value_of("1,") == "(1,)");
  CHECK(value_of("*[1, 2], 3") == "(1, 2, 3)");
  CHECK(value_of("1if True else 2") == "1");
}

TEST_CASE("xacro expression: sequences") {
  CHECK(value_of("[1,2,3,4][::-2]") == "[4, 2]");
  CHECK(value_of("[1,2,3][-2:]") == "[2, 3]");
  CHECK(value_of("'äöü'[1:]") == "öü");
  CHECK(value_of("(1,2)+(3,)") == "(1, 2, 3)");
  CHECK(value_of("[1]*3") == "[1, 1, 1]");
  CHECK(value_of("'ab'*-1 + '|'") == "|");
  CHECK(value_of("sorted([3,1,2], reverse=True)") == "[3, 2, 1]");
  CHECK(value_of("python.sorted(['bb','a'], key=len)") == "['a', 'bb']");
  CHECK(value_of("list(python.zip([1,2],'ab'))") == "[(1, 'a'), (2, 'b')]");
  CHECK(value_of("list(python.enumerate('ab', 1))") == "[(1, 'a'), (2, 'b')]");
  CHECK(value_of("python.range(2, 9, 3)") == "range(2, 9, 3)");
  CHECK(value_of("list(python.range(5)[::-1])") == "[4, 3, 2, 1, 0]");
  CHECK(value_of("[1,2] < [1,3]") == "True");
  CHECK(value_of("max([1, 5, 3], key=lambda x: -x)") == "1");
  CHECK(value_of("min('b', 'a')") == "a");
  CHECK(value_of("python.sum([0.1]*3)") == "0.30000000000000004");
}

TEST_CASE("xacro expression: dictionaries and sets") {
  CHECK(value_of("dict(a=1, b=[2])") == "{'a': 1, 'b': [2]}");
  CHECK(value_of("dict([(1, 'x'), (True, 'y')])") == "{1: 'y'}");
  CHECK(value_of("dict(a=1).get('b', 7)") == "7");
  CHECK(value_of("list(dict(a=1, b=2).items())") == "[('a', 1), ('b', 2)]");
  CHECK(value_of("dict(a=1).keys()") == "dict_keys(['a'])");
  CHECK(value_of("dict(a=1) == dict([('a', 1.0)])") == "True");
  CHECK(value_of("python.set([3,1,2]) - python.set([1])") == "{2, 3}");
  CHECK(value_of("python.set()") == "set()");
  CHECK(value_of("python.set('ab') >= python.set('a')") == "True");
  CHECK(value_of("python.frozenset([1])") == "frozenset({1})");
  CHECK(value_of("xacro.dotify(dict(a=dict(b=2))).a.b") == "2");
}

TEST_CASE("xacro expression: comprehensions and lambdas have names of their own") {
  CHECK(value_of("[i*j for i in [1,2] for j in [i, 10]]") == "[1, 10, 4, 20]");
  CHECK(value_of("[a+b for a, b in [(1, 2), (3, 4)]]") == "[3, 7]");
  CHECK(value_of("[x for x in python.range(10) if x % 2 if x > 4]") == "[5, 7, 9]");
  CHECK(value_of("(lambda x, y=2: x*y)(4)") == "8");
  CHECK(value_of("(lambda x: lambda y: x-y)(5)(2)") == "3");
  CHECK(value_of("[[i for i in python.range(j)] for j in [1,2]]") == "[[0], [0, 1]]");
  CHECK(error_of("[i for i in [1]] + i") == "name 'i' is not defined");
}

TEST_CASE("xacro expression: texts") {
  CHECK(value_of("'it\\'s'") == "it's");
  CHECK(value_of("['a', \"it's\"]") == "['a', \"it's\"]");
  CHECK(value_of("'a' \"b\"") == "ab");
  CHECK(value_of("r'a\\n'") == "a\\n");
  CHECK(value_of("'\\u00e9\\x41\\101'") == "éAA");
  CHECK(value_of("'a b  c'.split()") == "['a', 'b', 'c']");
  CHECK(value_of("'a b c d'.split(None, 2)") == "['a', 'b', 'c d']");
  CHECK(value_of("' 1  2   3  '.split(None, 1)") == "['1', '2   3  ']");
  CHECK(value_of("'  1   2 3 '.rsplit(None, 1)") == "['  1   2', '3']");
  CHECK(value_of("'a à'.split(None, 1)") == "['a', 'à']");
  CHECK(value_of("'a.b.c'.rsplit('.', 1)") == "['a.b', 'c']");
  CHECK(value_of("'left_arm'.title()") == "Left_Arm");
  CHECK(value_of("'STRASSE'.lower() + 'ß'.upper()") == "strasseSS");
  CHECK(value_of("'abc'.center(6, '*')") == "*abc**");
  CHECK(value_of("'-7'.zfill(4)") == "-007");
  CHECK(value_of("'aXbX'.replace('X', '--', 1)") == "a--bX");
  CHECK(value_of("'abab'.rfind('ab')") == "2");
  CHECK(value_of("'x=1'.partition('=')") == "('x', '=', '1')");
  CHECK(value_of("'abc'.startswith(('x', 'a'))") == "True");
  CHECK(value_of("xacro.tokenize('a, b;c')") == "['a', 'b', 'c']");
}

TEST_CASE("xacro expression: formatting") {
  CHECK(value_of("'%5.1f|%-4d|%04x|%s' % (3.14159, 7, 255, [1])") == "  3.1|7   |00ff|[1]");
  CHECK(value_of("'%(a)s-%(b)03d' % dict(a=1, b=2)") == "1-002");
  CHECK(value_of("'%g %g %g' % (1e-5, 123456789, 1.0)") == "1e-05 1.23457e+08 1");
  CHECK(value_of("'%+.2e' % 12345.678") == "+1.23e+04");
  CHECK(value_of("'%c%%' % 65") == "A%");
  // format() fields hold a closing brace, which ends ${}: they are reached through other texts only.
  CHECK(value_of("'ab'.format()") == "ab");
}

TEST_CASE("xacro expression: fields of format()") {
  const auto formatted = [](const std::string& field, const std::string& value) {
    return value_of("('\\x7b" + field + "\\x7d').format(" + value + ")");
  };
  const auto refused = [](const std::string& field, const std::string& value) {
    return error_of("('\\x7b" + field + "\\x7d').format(" + value + ")");
  };
  CHECK(formatted(":010,", "1234") == "00,001,234");
  CHECK(formatted(":08,", "1234") == "0,001,234");
  CHECK(formatted(":010,", "-1234") == "-0,001,234");
  CHECK(formatted(":012,.2f", "1234.5") == "0,001,234.50");
  CHECK(formatted(":#012_x", "70000") == "0x0_0001_1170");
  CHECK(formatted(":08_b", "5") == "000_0101");
  CHECK(formatted(":*=10,", "1234") == "*****1,234");
  CHECK(formatted(":0>10,", "1234") == "000001,234");
  CHECK(formatted(":010,", "float('inf')") == "0000000inf");
  CHECK(formatted(":=010,", "1234") == "00,001,234");
  CHECK(formatted(": <010", "1234") == "1234      ");
  CHECK(formatted(": =010", "-12") == "-       12");
  CHECK(formatted(":010,", "1e20") == "00,001e+20");
  CHECK(formatted(":012,g", "1e300") == "000,001e+300");
  CHECK(formatted(":015,.1", "123456789.0") == "000,000,001e+08");
  CHECK(formatted(":010", "'ab'") == "ab00000000");
  CHECK(formatted(":c", "233") == "\xC3\xA9");
  CHECK(formatted(":5c", "65") == "    A");
  CHECK(formatted(":05c", "65") == "0000A");
  CHECK(refused(":,x", "5") == "Cannot specify ',' with 'x'.");
  CHECK(refused(":_n", "5") == "Cannot specify '_' with 'n'.");
  CHECK(refused(":,", "'a'") == "Cannot specify ',' with 's'.");
  CHECK(refused(":c", "-1") == "%c arg not in range(0x110000)");
  CHECK(refused(":c", "1114112") == "%c arg not in range(0x110000)");
  CHECK(refused(":c", "55296") == "surrogates not allowed");
  CHECK(refused("99999999999999999999", "'x'") == "Too many decimal digits in format string");
  CHECK(error_of("'%c' % 55296") == "surrogates not allowed");
}

TEST_CASE("xacro expression: mathematics") {
  CHECK(value_of("radians(180) == pi") == "True");
  CHECK(value_of("math.sin(pi/6)") == "0.49999999999999994");
  CHECK(value_of("hypot(3, 4)") == "5.0");
  CHECK(value_of("floor(-2.5)") == "-3");
  CHECK(value_of("comb(5, 2) + factorial(5) + gcd(12, 18)") == "136");
  CHECK(value_of("log(8, 2)") == "3.0");
  CHECK(value_of("isqrt(10**20)") == "10000000000");
  CHECK(value_of("log10(10**400)") == "400.0");
  CHECK(error_of("sqrt(-1)") == "math domain error");
  CHECK(error_of("exp(1000)") == "math range error");
  CHECK(error_of("log(0)") == "math domain error");
}

TEST_CASE("xacro expression: errors say what Python says") {
  CHECK(error_of("1/0") == "division by zero");
  CHECK(error_of("5 % 0") == "integer modulo by zero");
  CHECK(error_of("1.0/0") == "float division by zero");
  CHECK(error_of("foo + 1") == "name 'foo' is not defined");
  CHECK(error_of("'a' + 1") == "can only concatenate str (not \"int\") to str");
  CHECK(error_of("1 + 'a'") == "unsupported operand type(s) for +: 'int' and 'str'");
  CHECK(error_of("1 < 'a'") == "'<' not supported between instances of 'int' and 'str'");
  CHECK(error_of("[1,2][5]") == "list index out of range");
  CHECK(error_of("dict(a=1)['b']") == "'b'");
  CHECK(error_of("pi(1)") == "'float' object is not callable");
  CHECK(error_of("'a'.nope()") == "'str' object has no attribute 'nope'");
  CHECK(error_of("len(3)") == "object of type 'int' has no len()");
  CHECK(error_of("int('x')") == "invalid literal for int() with base 10: 'x'");
  CHECK(error_of("float('x')") == "could not convert string to float: 'x'");
  CHECK(error_of("'%d' % 'x'") == "%d format: a real number is required, not str");
  CHECK(error_of("[a for a, b in [[1]]]") == "not enough values to unpack (expected 2, got 1)");
  CHECK(error_of("dict([[1]])") == "dictionary update sequence element #0 has length 1; 2 is required");
  CHECK(error_of("python.set([[]])") == "unhashable type: 'list'");
}

TEST_CASE("xacro expression: a function says which arguments it takes") {
  CHECK(error_of("'a'.center()") == "center() missing required argument 'width' (pos 1)");
  CHECK(error_of("'a'.casefold(1)") == "lower() takes at most 0 arguments (1 given)");
  CHECK(error_of("'a'.find('a', sub='b')") == "find() got multiple values for argument 'sub'");
  CHECK(error_of("'a'.strip(x=1)") == "strip() got an unexpected keyword argument 'x'");
  CHECK(error_of("python.set([1]).union(x=1)") == "union() takes no keyword arguments");
  CHECK(error_of("python.range()") == "range expected at least 1 argument, got 0");
  CHECK(error_of("python.range(1, 2, 3, 4)") == "range expected at most 3 arguments, got 4");
  CHECK(error_of("sin()") == "math function() missing required argument 'x' (pos 1)");
  CHECK(error_of("int('1', 2, 3)") == "int() takes at most 2 arguments (3 given)");
}

TEST_CASE("xacro expression: syntax errors say what Python says") {
  CHECK(error_of("") == "invalid syntax (<expression>, line 0)");
  CHECK(error_of("1 +") == "invalid syntax (<expression>, line 1)");
  CHECK(error_of("a = 1") == "invalid syntax (<expression>, line 1)");
  CHECK(error_of("(1") == "'(' was never closed (<expression>, line 1)");
  CHECK(error_of("{'a': 1") == "'{' was never closed (<expression>, line 1)");
  CHECK(error_of("1)") == "unmatched ')' (<expression>, line 1)");
  CHECK(error_of("(1]") == "closing parenthesis ']' does not match opening parenthesis '(' (<expression>, line 1)");
  CHECK(error_of("'a") == "unterminated string literal (detected at line 1) (<expression>, line 1)");
  CHECK(error_of("max(1 2)") == "invalid syntax. Perhaps you forgot a comma? (<expression>, line 1)");
  CHECK(error_of("1 if 2") == "expected 'else' after 'if' expression (<expression>, line 1)");
  CHECK(error_of("007") ==
        "leading zeros in decimal integer literals are not permitted; use an 0o prefix for octal integers "
        "(<expression>, line 1)");
  CHECK(error_of("import os") == "invalid syntax (<expression>, line 1)");
}

TEST_CASE("xacro expression: nothing but the language is reachable") {
  CHECK(error_of("().__class__") == "Use of invalid name(s):  __class__");
  CHECK(error_of("__import__('os')") == "Use of invalid name(s):  __import__");
  CHECK(error_of("[x.__class__ for x in [1]]") == "Use of invalid name(s):  __class__");
  CHECK(error_of("open('x')") == "name 'open' is not defined");
  CHECK(error_of("eval('1')") == "name 'eval' is not defined");
  CHECK(error_of("getattr(1, 'x')") == "name 'getattr' is not defined");
  CHECK(error_of("abs(1)") == "name 'abs' is not defined");
}

TEST_CASE("xacro expression: work is bounded") {
  const auto is_bounded = [](const std::string& expression) {
    const Outcome outcome = expand_attribute("${" + expression + "}");
    CAPTURE(expression, outcome.message);
    return outcome.message.find("in.xacro:1:") == 0;
  };
  CHECK(is_bounded("9**9**9"));
  CHECK(is_bounded("2**(2**40)"));
  CHECK(is_bounded("1 << 10**12"));
  CHECK(is_bounded("'a'*10**12"));
  CHECK(is_bounded("[0]*10**12"));
  CHECK(is_bounded("list(python.range(10**12))"));
  CHECK(is_bounded("'%1000000000d' % 1"));
  CHECK(is_bounded("factorial(10**9)"));
  CHECK(
      is_bounded("[[[[0 for a in python.range(999)] for b in python.range(999)] for c in python.range(999)] for d in "
                 "python.range(999)]"));
  CHECK(is_bounded("(lambda f: f(f))(lambda f: f(f))"));
  CHECK(is_bounded(std::string(100'000, '(') + "1" + std::string(100'000, ')')));
  CHECK(is_bounded(std::string(100'000, '-') + "1"));
  CHECK(is_bounded("str(10**5000)"));
  CHECK(is_bounded("'a'.ljust(10**12)"));
  CHECK(is_bounded("(lambda l: l.append(l))([])"));
  CHECK(is_bounded("python.sum([10**4000 for i in python.range(10**7)])"));
}

TEST_CASE("xacro expression: a slice fits itself to a length") {
  CHECK(value_of("python.slice(1, None, 2).indices(5)") == "(1, 5, 2)");
  CHECK(value_of("python.slice(None, None, -1).indices(3)") == "(2, -1, -1)");
  CHECK(value_of("python.slice(-10**30, 10**30).indices(4)") == "(0, 4, 1)");
  CHECK(value_of("python.slice(None, None, 10**30).indices(3)") == "(0, 3, 1000000000000000000000000000000)");
  CHECK(value_of("python.range(*python.slice(7).indices(3))") == "range(0, 3)");
  CHECK(value_of("[python.slice(1, 2).start, python.slice(1, 2).stop, python.slice(1, 2).step]") == "[1, 2, None]");
  CHECK(value_of("[python.range(1, 9, 2).start, python.range(1, 9, 2).stop, python.range(1, 9, 2).step]") ==
        "[1, 9, 2]");
  CHECK(error_of("python.slice(1).indices(-1)") == "length should not be negative");
  CHECK(error_of("python.slice(1).indices('a')") == "'str' object cannot be interpreted as an integer");
  CHECK(error_of("python.slice(0, 1, 0).indices(3)") == "slice step cannot be zero");
  CHECK(error_of("python.slice('a').indices(3)") ==
        "slice indices must be integers or None or have an __index__ method");
  CHECK(error_of("python.slice(1).indices()") == "indices() missing required argument 'len' (pos 1)");
}

TEST_CASE("xacro expression: a slice of a range does not leave 64 bits") {
  CHECK(value_of("python.range(0, 10, 2)[::2]") == "range(0, 10, 4)");
  CHECK(value_of("python.range(1, 10, 3)[::-1]") == "range(7, -2, -3)");
  CHECK(value_of("python.range(10)[5:2]") == "range(5, 2)");
  CHECK(error_of("python.range(0, 4 * 10**12, 10**12)[::10**12]") == "the range reaches beyond 64 bits");
}
