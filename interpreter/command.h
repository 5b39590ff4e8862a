// The command line: `udcp FILE`, -e, apply, prove, verify, fmt. Returns the exit code; the only place that maps errors to it.
#pragma once

#include <iosfwd>

namespace udcp {

/// Streams are parameters so that tests can drive the command in process.
int command(int argc, const char* const* argv, std::istream& in, std::ostream& out, std::ostream& err);

}  // namespace udcp
