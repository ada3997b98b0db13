// What the compiler reads of a robot's own device types.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/render.hpp"
#include "generator/model/robot.hpp"
#include "generator/timing_file/included_files.hpp"

namespace finemote::gen {

/// The sources that are compiled with the robot's files, every `.cpp` that lies in one of `folders`, and what these and
/// the generated files include, or `shipped` ones from there: each once, in an order that does not depend on where the
/// folders lie. What cannot be read is left out.
std::vector<SourceText> user_code(const std::vector<OutputFile>& generated, const std::vector<SourceText>& shipped,
                                  const std::vector<std::string>& folders, const files::Access& access);

/// Paths of all that the compiler may read of the folders of a robot's own device types: every source and header that
/// lies in them, and what these include, whatever it is called.
std::vector<std::string> user_files(const Robot& robot, const files::Access& access);

/// Words that are in one of them, or may be made of two.
struct UserWords {
  bool has_mutable = false;     ///< wherever it stands: parts of constants may change
  bool makes_in_place = false;  ///< `new`, say, which makes an object in a given place: constants may be made anew
};

UserWords user_words(const Robot& robot, const files::Access& access);

}  // namespace finemote::gen
