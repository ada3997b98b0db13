#include "generated/batch.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace finemote::test {
namespace {

/// Puts one robot's sources one after the other, every own header where it is included first.
class Flattener {
 public:
  explicit Flattener(const Generated& robot) {
    for (const gen::OutputFile& file : robot.files) files_[file.name] = &file.text;
  }

  std::string flatten() {
    for (const auto& [name, text] : files_) {
      if (name.substr(name.size() - 4) == ".cpp" || name.substr(0, 5) == "host/") add(name);
    }
    return text_;
  }
  [[nodiscard]] const std::set<std::string>& runtime_includes() const { return runtime_includes_; }

 private:
  void add(const std::string& name) {
    if (!added_.insert(name).second) return;
    text_ += "#line 1 \"" + name + "\"\n";
    std::istringstream lines(*files_.at(name));
    unsigned number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.rfind("#pragma once", 0) == 0) {
        text_ += "\n";
      } else if (line.rfind("#include <", 0) == 0) {
        runtime_includes_.insert(line);
        text_ += "\n";
      } else if (line.rfind("#include \"", 0) == 0) {
        const std::string own = line.substr(10, line.find('"', 10) - 10);
        add(own);
        text_ += "#line " + std::to_string(number + 1) + " \"" + name + "\"\n";
      } else {
        text_ += line + "\n";
      }
    }
  }

  std::map<std::string, const std::string*> files_;
  std::set<std::string> added_, runtime_includes_;
  std::string text_;
};

/// Every `finemote_line_<n>` of a text, and the other names with C linkage.
std::set<std::string> linked_names(const std::string& text) {
  std::set<std::string> names{"finemote_schedule", "finemote_monitor", "finemote_monitor_records"};
  const std::string prefix = "finemote_line_";
  for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at + 1)) {
    auto end = at + prefix.size();
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
    names.insert(text.substr(at, end - at));
  }
  return names;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool has_word(const std::string& line, const std::string& word) {
  for (auto at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const auto end = at + word.size();
    if ((at == 0 || !is_word(line[at - 1])) && (end == line.size() || !is_word(line[end]))) return true;
  }
  return false;
}

}  // namespace

std::string translation_unit(const std::vector<Generated>& robots) {
  std::set<std::string> includes{"#include <finemote/monitor.hpp>", "#include <finemote/schedule.hpp>",
                                 "#include <finemote/ports.hpp>"};
  std::string body;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    Flattener flattener(robots[i]);
    const std::string text = flattener.flatten();
    includes.insert(flattener.runtime_includes().begin(), flattener.runtime_includes().end());
    const std::set<std::string> names = linked_names(text);
    for (const std::string& name : names) body += "#define " + name + " " + name + "_of_" + std::to_string(i) + "\n";
    body += text;
    for (const std::string& name : names) body += "#undef " + name + "\n";
  }
  std::string unit;
  for (const std::string& include : includes) unit += include + "\n";
  return unit + body;
}

std::string not_finite(const Generated& robot) {
  for (const gen::OutputFile& file : robot.files) {
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      std::string lower = line;
      std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
      if (has_word(lower, "inf") || has_word(lower, "nan") || has_word(lower, "inff") || has_word(lower, "nanf"))
        return file.name + ": " + line;
    }
  }
  return {};
}

std::string nameless(const Generated& robot) {
  std::string all;
  for (const gen::OutputFile& file : robot.files) {
    std::string text = file.text;
    for (auto at = text.find(robot.space); at != std::string::npos; at = text.find(robot.space, at))
      text.erase(at, robot.space.size());
    all += file.name + "\n" + text;
  }
  return all;
}

}  // namespace finemote::test
