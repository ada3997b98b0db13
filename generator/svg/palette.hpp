// The colours of pictures and reports, as variables of CSS: one set for light pages, one for dark ones.
#pragma once

namespace finemote::gen::svg {

/// How many colours there are for buses (`--bus-0` and on) and periods (`--period-0` and on); further ones begin anew.
inline constexpr unsigned kBusColours = 8, kPeriodColours = 6;

/// Declarations, without a selector. Every text colour has a contrast of at least 4.5 on every surface it is used on;
/// the saturated colours are those of Okabe and Ito, which people tell apart whatever colours they see.
inline constexpr const char* kLightColours =
    "--page: #ffffff; --surface: #f6f8fa; --raised: #ffffff; --ink: #1f2328; --muted: #57606a; --line: #d0d7de;\n"
    "--edge: #8c959f; --accent: #0a58a8; --good: #116329; --bad: #b42318; --mark: #fff0b3;\n"
    "--bus-0: #cfe8ff; --bus-1: #d3f5d9; --bus-2: #ffe3c2; --bus-3: #e8dcff;\n"
    "--bus-4: #f7eaa4; --bus-5: #ffd9ec; --bus-6: #c8f0ed; --bus-7: #e1e4e8;\n"
    "--period-0: #0072b2; --period-1: #c85200; --period-2: #007f5c; --period-3: #a8508a; --period-4: #7a6200;\n"
    "--period-5: #4a5bb8; --acquire: #56a0d3; --decide: #e69f00; --wire: #009e73;\n";
inline constexpr const char* kDarkColours =
    "--page: #0d1117; --surface: #161b22; --raised: #1c2230; --ink: #e6edf3; --muted: #9da7b3; --line: #30363d;\n"
    "--edge: #768390; --accent: #79b8ff; --good: #56d364; --bad: #ff8a80; --mark: #4a3d00;\n"
    "--bus-0: #0c3b6b; --bus-1: #11532a; --bus-2: #5c3a0e; --bus-3: #3f2f73;\n"
    "--bus-4: #4d430f; --bus-5: #5c2145; --bus-6: #0f4a4a; --bus-7: #3d444d;\n"
    "--period-0: #4ea8de; --period-1: #ff9d5c; --period-2: #3fcf9f; --period-3: #e39fc8; --period-4: #d9b93b;\n"
    "--period-5: #a5b1f7; --acquire: #3f87bb; --decide: #c98a00; --wire: #0a8f6b;\n";

}  // namespace finemote::gen::svg
