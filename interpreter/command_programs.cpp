// Programs as text: reading them, putting them into canonical form, and building the two that stand for actions.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "files/geometry_file.h"
#include "grammar/parse.h"
#include "grammar/print.h"
#include "interpreter/command_parts.h"

namespace udcp {
namespace {

namespace fs = std::filesystem;

ProgramError file_error(const std::string& code, const std::string& message, const std::string& help = {}) {
  return make_error(ErrorKind::file, code, message, help);
}

bool is_geometry_file(const fs::path& file) {
  for (const char* extension : {".obj", ".off", ".ply", ".stl", ".glb", ".gltf"}) {
    if (file.extension() == extension) return true;
  }
  return false;
}

/// What is being handled, a syntax error, with the text it belongs to.
ProgramError syntax_error(const std::string& text, const std::string& name) {
  ProgramError error = current_error();
  error.file = name;
  error.source = text;
  return error;
}

grammar::Program parse_named(const std::string& text, const std::string& name) {
  try {
    return grammar::parse(text);
  } catch (const grammar::SyntaxError&) {
    throw syntax_error(text, name);
  }
}

/// Renames over the file that a link points to, not over the link, and keeps the permissions.
void replace_file(const std::string& name, const std::string& text) {
  const fs::path target = fs::canonical(name);
  const fs::perms permissions = fs::status(target).permissions();
  write_file(target, text);
  std::error_code ignored;  // the new text is in place; a file system without permissions is no reason to fail
  fs::permissions(target, permissions, ignored);
}

bool format_one(const std::string& name, bool check, Console& console, std::istream& in) {
  const bool is_stream = name == "-";
  const std::string shown = is_stream ? "<stdin>" : name;
  const std::string text = is_stream ? read_program(in, shown) : read_program(name);
  const std::string canonical = grammar::to_string(parse_named(text, shown));
  if (check) {
    if (text != canonical) console.text(shown + " is not in canonical form");
    return text == canonical;
  }
  if (is_stream) {
    console.out() << canonical;
    console.flush();
  } else if (text != canonical) {
    replace_file(name, canonical);
  }
  return true;
}

}  // namespace

std::string read_program(std::istream& in, const std::string& name) {
  std::string text;
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_program_bytes) {
      throw file_error("E_PROGRAM_SIZE", name + " is longer than 16 MiB, more than any program",
                       "split it into files and join them with: use \"part.udcp\"");
    }
    if (std::memchr(block, '\0', static_cast<std::size_t>(in.gcount())) != nullptr) {
      throw file_error("E_NOT_PROGRAM", name + " is a binary file, not a program",
                       "meshes are read by a program: load(\"cube.glb\")");
    }
  }
  if (in.bad()) throw file_error("E_FILE_OPEN", name + " cannot be read to its end: " + std::strerror(errno));
  return text;
}

std::string read_program(const std::string& file) {
  std::error_code unknown;
  if (fs::is_directory(file, unknown)) {
    throw file_error("E_FILE_OPEN", "'" + file + "' is a folder, not a program", "name a file inside it");
  }
  if (is_geometry_file(file)) {
    throw file_error("E_NOT_PROGRAM", "'" + file + "' is a mesh file, not a program",
                     "refine it with: udcp apply 'catmull_clark' " + file + " -n 3 -o fine.obj");
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw file_error("E_FILE_OPEN", "'" + file + "' cannot be opened: " + std::strerror(errno == 0 ? ENOENT : errno));
  return read_program(in, "'" + file + "'");
}

void check_expression(const std::string& text, const std::string& name) {
  try {
    grammar::parse_expression(text);
  } catch (const grammar::SyntaxError&) {
    throw syntax_error(text, name);
  }
}

bool format_programs(const CommandLine& line, Console& console, std::istream& in) {
  bool canonical = true;
  for (const std::string& name : line.files) canonical = format_one(name, line.check, console, in) && canonical;
  return canonical;
}

std::string claim_program(const CommandLine& line) {
  grammar::Program program = parse_named("prove " + line.claim + "\n", "<command line>");
  auto* claim = program.statements.size() == 1 ? std::get_if<grammar::Claim>(&program.statements[0].node) : nullptr;
  if (claim == nullptr) throw UsageError("prove takes one claim, such as 'converges((UCP)*) for omega in (0, 1)'");
  if (!line.output.empty()) {
    if (claim->certificate) throw UsageError("the certificate is named twice, by -> and by -o");
    claim->certificate = line.output;
  }
  return grammar::to_string(program);
}

std::string verify_program(const std::string& certificate) {
  grammar::Program program;
  program.statements.emplace_back();
  program.statements[0].node = grammar::Verify{certificate};
  return grammar::to_string(program);
}

std::string explain(const std::string& code) {
  const CodeEntry* entry = find_code(code);
  if (entry == nullptr) throw UsageError("there is no error code '" + code + "'; codes look like W03 or E_P_DUAL");
  return std::string(entry->code) + " (" + entry->symbol + "): " + entry->title + "\n\n" + entry->story;
}

}  // namespace udcp
