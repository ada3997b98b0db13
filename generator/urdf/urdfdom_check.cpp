#include "generator/urdf/urdfdom_check.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <array>
#include <exception>

#include "generator/xml/escape.hpp"

namespace finemote::gen {
namespace {

/// Keeps what urdfdom prints while it lives; afterwards the console is as before.
class CapturedConsole final : public console_bridge::OutputHandler {
 public:
  CapturedConsole() : level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
  }
  ~CapturedConsole() override {
    console_bridge::restorePreviousOutputHandler();
    console_bridge::setLogLevel(level_);
  }
  CapturedConsole(const CapturedConsole&) = delete;
  CapturedConsole& operator=(const CapturedConsole&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) errors.push_back(text);
  }
  std::vector<std::string> errors;

 private:
  console_bridge::LogLevel level_;
};

void append_element(std::string& out, const xml::Node& node) {
  out += '<' + node.name;
  for (const xml::Attribute& attribute : node.attributes) {
    out += ' ' + attribute.name + "=\"";
    xml::append_escaped(out, attribute.value);
    out += '"';
  }
  out += '>';
  for (const xml::Node& child : node.children) {
    if (child.is_element()) append_element(out, child);
  }
  out += "</" + node.name + ">\n";
}

/// The part of the robot urdfdom looks at; nothing else of the document can confuse it.
std::string urdf_text(const xml::Node& robot) {
  std::string text = "<robot name=\"";
  const xml::Attribute* name = robot.attribute("name");
  xml::append_escaped(text, name != nullptr ? name->value : "");
  text += "\">\n";
  constexpr std::array<std::string_view, 3> kParts{"link", "joint", "material"};
  for (const xml::Node& child : robot.children) {
    if (child.is_element() && std::find(kParts.begin(), kParts.end(), child.name) != kParts.end())
      append_element(text, child);
  }
  return text + "</robot>\n";
}

/// The element a message of urdfdom speaks of: it puts names in brackets.
Position find_place(std::string_view message, const Kinematics& kinematics, Position otherwise) {
  std::size_t from = 0;
  while ((from = message.find('[', from)) != std::string_view::npos) {
    const std::size_t end = message.find(']', from);
    if (end == std::string_view::npos) break;
    const std::string_view name = message.substr(from + 1, end - from - 1);
    const bool of_link = message.substr(0, from).find_last_of("lL") != std::string_view::npos &&
                         message.find("oint") == std::string_view::npos;
    const Joint* joint = kinematics.joint(name);
    const Link* link = kinematics.link(name);
    if (link != nullptr && (of_link || joint == nullptr)) return link->at;
    if (joint != nullptr) return joint->at;
    from = end;
  }
  return otherwise;
}

std::string first_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

}  // namespace

void check_with_urdfdom(const xml::Node& robot, const Kinematics& kinematics, Diagnostics& diagnostics) {
  CapturedConsole console;
  bool accepted = false;
  try {
    accepted = urdf::parseURDF(urdf_text(robot)) != nullptr;
  } catch (const std::exception& problem) {
    console.errors.push_back(problem.what());
  }
  if (accepted) return;
  if (console.errors.empty()) console.errors.emplace_back("no reason given");
  const std::string& reason = console.errors.front();
  Diagnostic& finding = diagnostics.error(code::urdf_rejected, find_place(reason, kinematics, robot.at),
                                          "ROS tools would refuse the links and joints of this robot");
  finding.underline(5);
  finding.note("urdfdom says: " + first_line(reason));
}

}  // namespace finemote::gen
