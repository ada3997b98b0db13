#include "tree.hpp"

int total_in_second() { return order::body.total() + order::arm.total(); }
