// Files appear complete or not at all.
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "files/writer.h"
#include "folder.h"
#include "helpers.h"

using namespace udcp;
using namespace udcp::test;
namespace fs = std::filesystem;

TEST_SUITE("files") {
  TEST_CASE("what was written is read back byte by byte") {
    const Folder folder;
    std::string bytes(300000, 'x');
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * k);
    const auto file = folder.path / "a.bin";
    write_file(file, "old");
    write_file(file, bytes);
    CHECK(read_file(file) == bytes);
    CHECK(folder.entries() == 1);
    write_file(file, "");
    CHECK(read_file(file).empty());
    CHECK(refusal([&] { write_file(file, bytes); }) == "accepted");
    CHECK(refusal([&] { read_file(file, 1000); }) ==
          "E_FILE_TOO_LARGE: " + file.string() + " is larger than the limit of 1000 bytes");
  }

  TEST_CASE("pieces of any size make one file") {
    const Folder folder;
    const auto file = folder.path / "a.bin";
    std::vector<float> many(200000);
    for (std::size_t k = 0; k < many.size(); ++k) many[k] = static_cast<float>(k) / 7;
    const auto fill = [&](Writer& out) {
      for (int k = 0; k < 3; ++k) {
        out << "some text " << k << ' ' << 0.1 << ' ' << 0.1F << '\n' << std::string_view();
        out.write(std::span<const float>(many));
        char* to = out.room(700000);
        std::fill_n(to, 600000, static_cast<char>('a' + k));
        out.filled(to + 600000);
      }
    };
    std::string expected;
    for (int k = 0; k < 3; ++k) {
      expected += "some text " + std::to_string(k) + " 0.1 0.1\n";
      expected.append(reinterpret_cast<const char*>(many.data()), 4 * many.size());
      expected.append(600000, static_cast<char>('a' + k));
    }
    Writer memory(0), out(file);
    fill(memory);
    fill(out);
    CHECK_FALSE(fs::exists(file));
    out.commit();
    CHECK(memory.take() == expected);
    CHECK(read_file(file) == expected);
    CHECK(folder.entries() == 1);
  }

  TEST_CASE("what is not committed never was") {
    const Folder folder;
    const auto file = folder.path / "a.bin";
    write_file(file, "old");
    {
      FileSink out(file);
      out.write(std::string(20000000, 'x'));
      CHECK(folder.entries() == 2);
    }
    CHECK(folder.entries() == 1);
    CHECK(read_file(file) == "old");
    FileSink out("/dev/null");
    out.write("x");
    out.commit();
    CHECK(refusal([] {
            FileSink full("/dev/full");
            full.write("x");
          }).starts_with("E_FILE_WRITE: cannot write /dev/full: "));
  }

  TEST_CASE("an existing file keeps its mode and a link stays a link") {
    const Folder folder;
    const auto file = folder.path / "a.txt", link = folder.path / "link", chain = folder.path / "chain";
    write_file(file, "1");
    CHECK((fs::status(file).permissions() & fs::perms::owner_write) != fs::perms::none);
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("a.txt", link);
    fs::create_symlink(link, chain);
    write_file(chain, "2");
    CHECK(read_file(file) == "2");
    CHECK(fs::is_symlink(link));
    CHECK(fs::is_symlink(chain));
    CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    fs::create_symlink("new.txt", folder.path / "dangling");
    write_file(folder.path / "dangling", "3");
    CHECK(read_file(folder.path / "new.txt") == "3");
  }

  TEST_CASE("a file that cannot be written says why and leaves nothing behind") {
    const Folder folder;
    const auto answer = [&](const fs::path& file) { return refusal([&] { write_file(file, "x"); }); };
    const std::string name = folder.path.string();
    CHECK(answer(folder.path) == "E_FILE_WRITE: cannot write " + name + ": it is a folder");
    CHECK(answer(folder.path / "no" / "a") == "E_FILE_WRITE: cannot write " + name + "/no/a: the folder does not exist");
    CHECK(answer(name + "/no/") == "E_FILE_WRITE: cannot write " + name + "/no/: the folder does not exist");
    CHECK(answer("") == "E_FILE_WRITE: cannot write: the file name is empty");
    CHECK(answer("/dev/full").starts_with("E_FILE_WRITE: cannot write /dev/full: "));
    CHECK(answer("/dev/null") == "accepted");
    fs::create_symlink("loop", folder.path / "loop");
    CHECK(answer(folder.path / "loop").starts_with("E_FILE_WRITE"));
    CHECK(answer(folder.path / std::string(300, 'a')).starts_with("E_FILE_WRITE"));
    CHECK(folder.entries() == 1);
  }

  TEST_CASE("a disk that fills up leaves the old file as it was") {
    const Folder folder;
    const auto file = folder.path / "a.txt";
    write_file(file, "old");
    CHECK(child_says([&] {  // a limit on the size of files stands for a full disk
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{1000, 1000};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      return refusal([&] { write_file(file, std::string(5000, 'x')); }).starts_with("E_FILE_WRITE: cannot write ");
    }));
    CHECK(read_file(file) == "old");
    CHECK(folder.entries() == 1);
  }

  TEST_CASE("without permission nothing is written") {
    const Folder folder;
    const auto file = folder.path / "a.txt", locked = folder.path / "locked";
    write_file(file, "old");
    fs::permissions(file, fs::perms::owner_read);
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
    fs::permissions(folder.path, fs::perms::all);
    CHECK(child_says([&] {
      if (::getuid() == 0 && ::setuid(65534) != 0) return false;  // the superuser may write anywhere
      return refusal([&] { write_file(file, "new"); }).starts_with("E_FILE_WRITE: cannot write ") &&
             refusal([&] { write_file(locked / "b", "new"); }).starts_with("E_FILE_WRITE: cannot write ");
    }));
    CHECK(read_file(file) == "old");
    fs::permissions(locked, fs::perms::owner_all);
  }

  TEST_CASE("files that cannot be read say why") {
    CHECK(refusal([] { read_file("nowhere/a.obj"); }) == "E_FILE_OPEN: cannot read nowhere/a.obj: No such file or directory");
    CHECK(refusal([] { load<double>("nowhere/a.obj"); }) == "E_FILE_OPEN: cannot read nowhere/a.obj: No such file or directory");
    CHECK(refusal([] { read_file(data); }) == "E_FILE_OPEN: cannot read " + data.string() + ": it is a folder");
  }

  TEST_CASE("a surface that cannot be saved leaves the old file as it was") {
    const Folder folder;
    auto surface = roof();
    const auto file = folder.path / "roof.obj";
    save(surface, file);
    const std::string before = read_file(file);
    check_same(load<double>(file), surface);
    surface.points(0, 0) = INFINITY;
    CHECK(refusal([&] { save(surface, file); }).starts_with("E_NOT_FINITE"));
    CHECK(read_file(file) == before);
    CHECK(folder.entries() == 1);
  }
}
