// The standard schemes as text: prelude.udcp, made into a source file when the project is built.
#pragma once

#include <string>

namespace udcp {

std::string prelude_text();

}  // namespace udcp
