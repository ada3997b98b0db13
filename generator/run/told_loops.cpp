#include "generator/run/told_loops.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/image/image.hpp"
#include "generator/image/source_lines.hpp"
#include "generator/run/code_line.hpp"
#include "generator/run/measured.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t passes_of(std::size_t loop, const std::vector<std::uint64_t>& passes) {
  return loop < passes.size() ? passes[loop] : 0;
}

Judgement judge(const ToldLoop& told, std::uint64_t passes) {
  if (passes == 0) return Judgement::no_sample;
  return passes > told.loop.bound ? Judgement::broken : Judgement::held;
}

std::string where(const ToldLoop& told) {
  return told.file.empty() ? fmt::format("{:#010x}", told.loop.place) : fmt::format("{}:{}", told.file, told.line);
}

std::string broken_mark(const ToldLoop& told, std::uint64_t passes) {
  const std::string place = fmt::format("{}: in '{}': the loop passed its mark", where(told), told.function);
  if (told.loop.is_for_interrupts)
    return fmt::format("{} {} times besides one for each interrupt, and retried_if_interrupted() says once", place,
                       passes);
  return fmt::format("{} {} times, and LoopBound<{}> says at most {}", place, passes, told.loop.bound, told.loop.bound);
}

}  // namespace

std::vector<ToldLoop> told_loops(const std::string& image_path, const SourceNames& names, Diagnostics& diagnostics) {
  std::vector<ToldLoop> all;
  const auto image = read_image(image_path, diagnostics);
  if (!image) return all;
  std::vector<wcet::MarkedLoop> loops = wcet::marked_loops(*image);
  const SourceLines lines(image_path);
  for (wcet::MarkedLoop& loop : loops) {
    ToldLoop& told = all.emplace_back();
    told.function = readable_name(loop.function);
    if (const auto line = code_line(lines, loop.header)) {
      told.file = names.of(line->file);
      told.line = line->line;
    }
    told.loop = std::move(loop);
  }
  return all;
}

Json watched_loops(const std::vector<ToldLoop>& loops) {
  Json list = Json::array();
  for (const ToldLoop& told : loops) list.push_back({told.loop.place, told.loop.borders, told.loop.is_for_interrupts});
  return list;
}

bool check_loops(const std::vector<ToldLoop>& loops, const std::vector<std::uint64_t>& passes,
                 Diagnostics& diagnostics) {
  std::set<std::string> said;  // a loop of the source may be several in the image
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const ToldLoop& told = loops[i];
    const std::uint64_t most = passes_of(i, passes);
    if (judge(told, most) != Judgement::broken) continue;
    const std::string message = broken_mark(told, most);
    if (!said.insert(message).second) continue;
    diagnostics.error(code::told_loop, {}, message)
        .note("execution times that were computed from this mark are no bounds")
        .hint(told.loop.is_for_interrupts ? "mark a loop that turns for other reasons with LoopBound<n>"
                                          : "write a bound that holds for every input, or make the loop end there");
  }
  return said.empty();
}

Json loop_list(const std::vector<ToldLoop>& loops, const std::vector<std::uint64_t>& passes) {
  Json list = Json::array();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const ToldLoop& told = loops[i];
    const std::uint64_t most = passes_of(i, passes);
    list.push_back({{"function", told.function},
                    {"file", told.file.empty() ? Json() : Json(told.file)},
                    {"line", told.file.empty() ? Json() : Json(told.line)},
                    {"bound", told.loop.bound},
                    {"passes_max", most > 0 ? Json(most) : Json()},
                    {"judged", judgement_name(judge(told, most))}});
  }
  return list;
}

}  // namespace finemote::gen
