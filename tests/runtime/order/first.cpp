#include "tree.hpp"

int total_in_first() { return order::body.total(); }
