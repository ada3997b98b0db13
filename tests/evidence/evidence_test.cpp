// Gives frames recorded or published by others to our decoders and part models, and says for each whether they agree.
//
// evidence_test            one line per vector, remarks on stderr, a sum; the vectors are those of the folder in
//                          FINEMOTE_EVIDENCE, or of tests/evidence
// Exit status: 0 all agree, are explained or have no decoder; 1 some do not; 2 the vectors cannot be read.
#include <cstdlib>
#include <iostream>
#include <map>

#include "source_dir.hpp"
#include "tests/evidence/judge.hpp"

using namespace finemote::evidence;

namespace {

int run(const std::string& folder) {
  std::map<Verdict, unsigned> counts;
  unsigned vectors = 0;
  for (const Vector& vector : read_vectors(folder)) {
    const Judgement judgement = judge(vector);
    std::cout << vector.protocol << '/' << vector.name << ' ' << judgement.text() << '\n';
    for (const std::string& remark : judgement.remarks)
      std::cerr << vector.protocol << '/' << vector.name << ": " << remark << '\n';
    ++counts[judgement.verdict];
    ++vectors;
  }
  std::cout << vectors << " vectors, " << counts[Verdict::agree] << " agree, " << counts[Verdict::differs]
            << " differ, " << counts[Verdict::explained] << " explained, " << counts[Verdict::no_decoder]
            << " without decoder\n";
  return counts[Verdict::differs] + counts[Verdict::unknown_field] > 0 ? 1 : 0;
}

}  // namespace

int main() {
  const char* folder = std::getenv("FINEMOTE_EVIDENCE");
  try {
    return run(folder != nullptr ? folder : finemote::test::source_dir() + "/tests/evidence");
  } catch (const std::exception& error) {
    std::cerr << "evidence_test: " << error.what() << '\n';
    return 2;
  }
}
