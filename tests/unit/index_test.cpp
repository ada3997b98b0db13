#include "generator/index/index.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "catch.hpp"

namespace finemote::gen {
namespace {

struct LetterTag;
struct WordTag;
using Letter = Index<LetterTag>;
using Word = Index<WordTag>;

static_assert(!std::is_convertible_v<std::size_t, Letter>);
static_assert(!std::is_convertible_v<Letter, std::size_t>);
static_assert(!std::is_constructible_v<Letter, Word>);
static_assert(!std::is_assignable_v<Letter&, Word>);

template <class T, class I>
concept Indexable = requires(T table, I index) {
  table[index];
};
static_assert(Indexable<Table<Letter, int>, Letter>);
static_assert(!Indexable<Table<Letter, int>, Word>);
static_assert(!Indexable<Table<Letter, int>, std::size_t>);

TEST_CASE("an index orders as its position does") {
  CHECK(Letter{2}.value() == 2);
  CHECK(Letter{} == Letter{0});
  CHECK(Letter{1} < Letter{2});
  CHECK(std::max(Letter{3}, Letter{1}) == Letter{3});
}

TEST_CASE("a table gives the index of what is added and finds it again") {
  Table<Letter, std::string> table;
  CHECK(table.empty());
  CHECK(table.next_id() == Letter{0});
  CHECK(table.push_back("a") == Letter{0});
  const Letter b = table.push_back("b");
  CHECK(table[b] == "b");
  table[b] = std::string("B");
  CHECK(table.back() == "B");
  CHECK(table.size() == 2);
  CHECK(table.contains(b));
  CHECK_FALSE(table.contains(table.next_id()));
  CHECK(table == Table<Letter, std::string>{"a", "B"});
}

TEST_CASE("a table is walked by its elements and by their indices") {
  const Table<Letter, int> table{3, 1, 2};
  CHECK(std::vector<int>(table.begin(), table.end()) == std::vector<int>{3, 1, 2});
  int sum = 0;
  for (const Letter letter : table.ids()) sum += table[letter];
  CHECK(sum == 6);
  const auto ids = table.ids();
  CHECK(std::vector<Letter>(ids.begin(), ids.end()) == std::vector<Letter>{Letter{0}, Letter{1}, Letter{2}});
  CHECK(Table<Letter, int>{}.ids().begin() == Table<Letter, int>{}.ids().end());
}

TEST_CASE("a table of flags is one as any other") {
  Table<Letter, bool> seen(3, false);
  seen[Letter{1}] = true;
  CHECK_FALSE(seen[Letter{0}]);
  CHECK(seen[Letter{1}]);
}

}  // namespace
}  // namespace finemote::gen
