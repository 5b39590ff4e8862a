// A session in a folder of its own, for programs that write and read files.
#pragma once

#include <filesystem>

#include "files/geometry_file.h"
#include "interpreter/report.h"
#include "interpreter/session.h"

namespace udcp::oracle {

/// A session with the prelude in a folder of its own.
class Room {
 public:
  Room()
      : folder_(std::filesystem::temp_directory_path() /
                ("udcp_claims_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)))),
        session_() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    session_.load_prelude();
  }
  ~Room() { std::filesystem::remove_all(folder_); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;

  Value run(const std::string& program) { return session_.run(program, "<test>", folder_); }
  std::string verdict(const std::string& program) { return to_json(run(program))["value"]["verdict"].get<std::string>(); }
  std::string error(const std::string& program) {
    try {
      (void)run(program);
    } catch (const ProgramError& e) {
      return e.code;
    }
    return "";
  }
  Outcome outcome() const { return session_.outcome(); }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  std::string text(const std::string& name) const { return read_file(file(name)); }

 private:
  std::filesystem::path folder_;
  Session session_;
};

}  // namespace udcp::oracle
