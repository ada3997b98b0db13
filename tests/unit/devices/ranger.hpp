// The header that ranger.json names. Nothing of it is compiled: tests of the analysis read the descriptor alone.
#pragma once
