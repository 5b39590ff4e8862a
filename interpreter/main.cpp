// The process around command(): a reader that goes away is an error of a write, not the end of the process.
#include <csignal>
#include <iostream>

#include "interpreter/command.h"

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  return udcp::command(argc, argv, std::cin, std::cout, std::cerr);
}
