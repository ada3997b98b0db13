// Every shipped descriptor keeps to its schema's naming and has a reference page that tells all of it.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hpp"
#include "source_dir.hpp"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kRoot = finemote::test::source_dir();

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string as_written(const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

}  // namespace

TEST_CASE("every device type has a header and a reference page with each of its params, roles and uses") {
  unsigned count = 0;
  const std::string index = text_of(kRoot / "docs/reference/devices/README.md");
  for (const auto& entry : fs::directory_iterator(kRoot / "schemas/devices")) {
    if (entry.path().extension() != ".json") continue;
    const json device = json::parse(text_of(entry.path()));
    const std::string type = device["type"];
    INFO(type);
    ++count;
    CHECK(entry.path().stem() == type);
    CHECK(fs::exists(entry.path().parent_path() / device["header"].get<std::string>()));
    CHECK(index.find("[`" + type + "`](" + type + ".md)") != std::string::npos);
    const std::string page = text_of(kRoot / "docs/reference/devices" / (type + ".md"));
    for (const json& param : device.value("params", json::array())) {
      const std::string row = "| `" + param["name"].get<std::string>() + "` | ";
      const std::string fallback = param.contains("default") ? "`" + as_written(param["default"]) + "`" : "required";
      CHECK(page.find(row + fallback) != std::string::npos);
    }
    for (const json& role : device.value("roles", json::array())) {
      CHECK(page.find("| role `" + role["name"].get<std::string>() + "` |") != std::string::npos);
    }
    for (const json& use : device.value("uses", json::array())) {
      CHECK(page.find("| use `" + use["name"].get<std::string>() + "` |") != std::string::npos);
    }
  }
  CHECK(count >= 6);
}
