#include "tests/structure/definitions.hpp"

#include "catch.hpp"

using namespace finemote::test;

namespace {

/// `f run 2-4, t Lexer 1-5`: each definition in the order of their ends.
std::string found(std::string_view text) {
  std::string all;
  for (const Definition& definition : definitions_in(text)) {
    if (!all.empty()) all += ", ";
    all += definition.kind == DefinitionKind::function ? "f " : "t ";
    all += definition.name + " " + std::to_string(definition.first_line);
    if (definition.lines() > 1) all += "-" + std::to_string(definition.last_line);
  }
  return all;
}

}  // namespace

TEST_CASE("a function goes from its first word to its closing brace") {
  CHECK(found("int f() { return 1; }\n\nvoid g(int a,\n       int b)\n{\n}\n") == "f f 1, f g 3-6");
  CHECK(found("template <typename T>\nT f(T a) {\n}\n") == "f f 1-3");
  CHECK(found("/// What it does.\n[[nodiscard]]\nint f() {\n}") == "f f 2-4");
}

TEST_CASE("declarations define nothing") {
  CHECK(found("int f();\nclass Lexer;\nextern int x;\nFoo() = default;\nusing Call = int (*)(int);").empty());
  CHECK(found("enum class Kind : int { a, b };\nenum { c };").empty());
}

TEST_CASE("a function carries the name it is defined with") {
  CHECK(found("void Lexer::run() {}") == "f Lexer::run 1");
  CHECK(found("Lexer::Lexer() {}\nLexer::~Lexer() {}") == "f Lexer::Lexer 1, f Lexer::~Lexer 2");
  CHECK(found("bool operator==(A a, B b) {}\nint A::operator()(int) const {}") == "f operator== 1, f A::operator() 2");
  CHECK(found("A::operator bool() const {}\nA& A::operator=(A&&) noexcept {}") ==
        "f A::operator bool 1, f A::operator= 2");
  CHECK(found("template <>\nint Trait<std::pair<int, int>>::size() {}\ntemplate <> void f<int>() {}") ==
        "f Trait<std::pair<int,int>>::size 1-2, f f<int> 3");
}

TEST_CASE("what may stand between parameters and body changes nothing") {
  CHECK(found("auto f() const noexcept(true) -> std::vector<int> {}") == "f f 1");
  CHECK(found("int f() const& override final {}") == "f f 1");
  CHECK(found("int f(Options o = {}, int (&a)[2] = {1, 2}) {}") == "f f 1");
  CHECK(found("template <typename T>\nrequires(sizeof(T) > 1)\nint f(T a) {\n}") == "f f 1-4");
  CHECK(found("int f() __attribute__((naked)) {}\nALWAYS_INLINE int g() NOEXCEPT {}") == "f f 1, f g 2");
  CHECK(found("struct Pair make() { return {}; }") == "f make 1");
  CHECK(found("void f() try {\n} catch (...) {\n}").rfind("f f 1-2", 0) == 0);
}

TEST_CASE("the braces of members' values are no body") {
  CHECK(found("A::A(int a)\n    : Base<int>{a}, a_{a},\n      b_(b) {\n}") == "f A::A 1-4");
  CHECK(found("A::A() : a_{[] { return 1; }()} {\n}") == "f A::A 1-2");
  CHECK(found("template <typename... T>\nstruct A : T... {\n  A(T... t) : T(t)... {}\n};") == "f A::A 3, t A 1-4");
}

TEST_CASE("a class goes from its first word to its closing brace, and names what is in it") {
  CHECK(found("class A final : public B<int> {\n public:\n  int f() { return 1; }\n  int g();\n private:\n  int x = "
              "1;\n};") == "f A::f 3, t A 1-7");
  CHECK(found("struct A {\n  struct B {\n    void f() {}\n  };\n};") == "f A::B::f 3, t A::B 2-4, t A 1-5");
  CHECK(found("template <class T, typename U = std::pair<T, int>>\nstruct alignas(8) [[nodiscard]] A<T*> {\n};") ==
        "t A<T*> 1-3");
  CHECK(found("struct {\n  int x;\n} point = {1};\nunion U { int a; };") == "t  1-3, t U 4");
  CHECK(found("struct Reader::Field {\n};") == "t Reader::Field 1-2");
}

TEST_CASE("namespaces and linkage name nothing") {
  CHECK(found("namespace a::b {\nnamespace {\nvoid f() {}\n}\ninline namespace v1 { void g() {} }\n}") ==
        "f f 3, f g 5");
  CHECK(found("extern \"C\" {\nvoid f() {}\n}\nextern \"C\" void g() {}") == "f f 2, f g 4");
}

TEST_CASE("values in braces are no functions") {
  CHECK(found("int x{3};\nstd::array<int, size(3)> a{{1, 2}};\nconst Row rows[] = {{1, {2}}, {3, {4}}};").empty());
  CHECK(found("struct A {\n  std::function<void(int)> f{};\n  int x{3}, y = {4};\n};") == "t A 1-4");
  CHECK(found("alignas(4) int x{3};\ndecltype(x) y{4};").empty());
  CHECK(found("template <int N = int{3}>\nvoid f() {}") == "f f 1-2");
}

TEST_CASE("lambdas belong to the function they stand in, and are functions elsewhere") {
  CHECK(found("void f() {\n  const auto g = [] {\n  };\n}") == "f f 1-4");
  CHECK(found("const auto kTable = [] {\n  return 1;\n}();") == "f kTable 1-3");
  CHECK(found("const Row kRows[] = {\n    {\"a\", [](int x) -> int {\n       return x;\n     }},\n    {\"b\", "
              "nullptr}};") == "f kRows 2-4");
  CHECK(found("const auto x = std::invoke([&]<typename T>(T a) mutable { return a; }, 1);") == "f x 1");
  CHECK(found("const int a[2] = {b[0], c()[1]};").empty());
}

TEST_CASE("comments, strings and directives hide what they hold") {
  CHECK(found("// void f() {\n/* { \n */ void g() {} // }") == "f g 3");
  CHECK(found("const char* a = \"{\\\"\";\nconst char b = '{', c = '\\'';\nvoid f() {}") == "f f 3");
  CHECK(found("const auto a = R\"({ \" )\";\nconst auto b = u8R\"x({ )\" \n)x\";\nvoid f() {}") == "f f 4");
  CHECK(found("#define BEGIN(x) \\\n  void x() {\n#include \"a.hpp\"  // {\nvoid f() {}") == "f f 4");
  CHECK(found("#define A 1 /* begins here {\n and ends here */\n#define B \"/*\"\n#error it's gone\nvoid f() {}") ==
        "f f 5");
  CHECK(found("// a comment that goes on \\\n void f() {\nvoid g() {}") == "f g 3");
  CHECK(found("const int a = 1'000'000, b = 0x1p+3;\nvoid f() { g('x'); }") == "f f 2");
}

TEST_CASE("brackets that do not match are an error at the one left open") {
  CHECK_THROWS_WITH(definitions_in("void f() {\n  if (x) {\n}\n"), "line 1: '{' has no match");
  CHECK_THROWS_WITH(definitions_in("namespace a {\n"), "line 1: '{' has no match");
  CHECK_THROWS_WITH(definitions_in("int x;\n}\n"), "line 2: '}' has no match");
  CHECK_THROWS_WITH(definitions_in("const int x[] = {1, (2};"), "line 1: '(' has no match");
  CHECK_THROWS_WITH(definitions_in("#if A\nvoid f(int a) {\n#else\nvoid f() {\n#endif\n}\n"),
                    "line 2: '{' has no match");
}
