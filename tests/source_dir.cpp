#include "source_dir.hpp"

std::string finemote::test::source_dir() { return FINEMOTE_SOURCE_DIR; }
