// The numbers that the runtime puts into records of an image are those that the generator reads there.
#include "catch.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/mark.hpp"
#include "finemote/raised_by.hpp"
#include "generator/wcet/causes.hpp"
#include "generator/wcet/marks.hpp"

namespace runtime = finemote;
namespace wcet = finemote::gen::wcet;

namespace {

template <class Enum>
constexpr std::uint32_t number(Enum value) {
  return static_cast<std::uint32_t>(value);
}

// finemote/mark.hpp
static_assert(wcet::kFirstWorkMark == runtime::kFirstWorkMark);
static_assert(wcet::kMaskedMark == runtime::kFirstWorkMark + 2 * number(runtime::Work::masked));

// finemote/raised_by.hpp
static_assert(wcet::kRequest == number(runtime::Raised::request));
static_assert(wcet::kStep == number(runtime::Raised::step));
static_assert(wcet::kEnd == number(runtime::Raised::end));
static_assert(wcet::kReceived == number(runtime::Raised::received));
static_assert(wcet::kEvent == number(runtime::Raised::event));
static_assert(wcet::kAllCauses == (wcet::kRequest | wcet::kStep | wcet::kEnd | wcet::kReceived | wcet::kEvent));
static_assert(wcet::records::kOnceForEach == runtime::detail::kOnceForEach);
static_assert((wcet::records::kOnceForEach & wcet::kAllCauses) == 0);

// finemote/loop_bound.hpp
static_assert(number(wcet::RetriedBy::release) == number(runtime::RetriedBy::release));
static_assert(number(wcet::RetriedBy::received) == number(runtime::RetriedBy::received));
static_assert(number(wcet::RetriedBy::event) == number(runtime::RetriedBy::event));
static_assert(number(wcet::RetriedBy::fault) == number(runtime::RetriedBy::fault));
static_assert(wcet::kKindsOfRetry == number(runtime::RetriedBy::fault) + 1);
static_assert(wcet::records::kUnlessInterrupted == runtime::detail::kUnlessInterrupted);
static_assert(wcet::records::kRetriedByShift == runtime::detail::kRetriedByShift);
static_assert(wcet::records::kBegins == runtime::detail::kBegins);
static_assert(wcet::kKindsOfRetry << wcet::records::kRetriedByShift < wcet::records::kUnlessInterrupted);

}  // namespace

TEST_CASE("runtime and generator agree on the records of marks") { SUCCEED("what compiles holds"); }
