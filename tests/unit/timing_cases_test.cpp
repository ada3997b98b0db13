// Profiles paper and tight against the worked cases in tests/analysis-cases, field by field.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/profile.hpp"
#include "generator/timing/read_model.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

std::vector<std::filesystem::path> case_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(finemote::test::source_dir() + "/tests/analysis-cases")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Integers, strings, verdicts and nulls are equal; doubles within 1e-9. Returns the first difference.
std::string difference(const Json& found, const Json& expected, const std::string& where) {
  if (expected.is_object()) {
    if (!found.is_object() || found.size() != expected.size()) return where + ": other members";
    for (const auto& [key, value] : expected.items()) {
      if (!found.contains(key)) return where + "." + key + ": missing";
      if (auto d = difference(found[key], value, where + "." + key); !d.empty()) return d;
    }
    return {};
  }
  if (expected.is_array()) {
    if (!found.is_array() || found.size() != expected.size()) return where + ": other length";
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (auto d = difference(found[i], expected[i], where + "[" + std::to_string(i) + "]"); !d.empty()) return d;
    }
    return {};
  }
  if (expected.is_number_float()) {
    const double e = expected.get<double>(), f = found.get<double>();
    return std::abs(e - f) <= 1e-9 * std::abs(e) ? "" : where + ": " + found.dump() + " instead of " + expected.dump();
  }
  return found == expected ? "" : where + ": " + found.dump() + " instead of " + expected.dump();
}

}  // namespace

TEST_CASE("every case matches exactly in both profiles") {
  const auto files = case_files();
  REQUIRE(files.size() >= 40);
  for (const auto& path : files) {
    INFO(path.filename().string());
    Sources sources;
    Diagnostics diagnostics;
    const SourceFile* file = sources.add({path.filename().string(), "", finemote::test::read(path)});
    const auto model = read_model(*file, diagnostics);
    CHECK(render_text(diagnostics, false) == "");
    REQUIRE(model);
    CHECK_FALSE(model->has_target);
    const Json expected = Json::parse(file->text)["expected"];
    const Topology topology = make_topology(*model);
    Json found;
    add_utilization(*model, test_utilization(*model), found);
    found["paper"] = profile_json(*model, analyse_profile(*model, topology, Profile::paper).result);
    found["tight"] = profile_json(*model, analyse_profile(*model, topology, Profile::tight).result);
    CHECK(difference(found, expected, "expected") == "");
    CHECK(difference(model_json(*model), Json::parse(file->text)["model"], "model") == "");
  }
}
