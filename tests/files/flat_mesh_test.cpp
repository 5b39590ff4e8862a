// Flat meshes of floats and doubles: the same files as from the surface that they stand for, and what is refused.
#include "operators/plan/flat_mesh.h"

#include <sys/resource.h>

#include <atomic>
#include <csignal>

#include "files/writer.h"
#include "folder.h"
#include "gltf_opinion.h"
#include "operators/shapes.h"

using namespace udcp;
using namespace udcp::test;

namespace {

/// A torus of m by m quads with awkward coordinates and no tags.
Surface<double> wavy(int m) {
  auto surface = torus<double>(m, m, 2.0, 0.75);
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    surface.points(v, 2) += 0.05 * std::sin(7 * surface.points(v, 0)) * std::cos(5 * surface.points(v, 1));
  }
  surface.tags = {};
  return surface;
}

template <class To, class From>
Buffer<To> copied(const From* from, std::size_t size) {
  Buffer<To> result(size);
  std::transform(from, from + size, result.begin(), [](From value) { return static_cast<To>(value); });
  return result;
}

template <class R>
FlatMesh<R> flat(const Surface<double>& surface, const Points<double>* normals = nullptr) {
  FlatMesh<R> mesh;
  mesh.points = copied<R>(surface.points.data(), static_cast<std::size_t>(surface.points.size()));
  if (normals) mesh.normals = copied<R>(normals->data(), static_cast<std::size_t>(normals->size()));
  mesh.corners = copied<std::uint32_t>(surface.mesh->vertex.data(), surface.mesh->vertex.size());
  mesh.corners_per_face = surface.mesh->size(0);
  return mesh;
}

Surface<double> rounded(Surface<double> surface) {
  surface.points = surface.points.cast<float>().cast<double>();
  return surface;
}

Points<double> some_normals(const Surface<double>& surface) { return surface.points.rowwise().normalized(); }

/// OFF without its line of counts.
std::string without_counts(std::string text) {
  const auto start = text.find('\n', text.find('#')) + 1;
  return text.erase(start, text.find('\n', start) - start);
}

}  // namespace

TEST_SUITE("files") {
  TEST_CASE("a flat mesh of doubles gives the files of its surface") {
    for (const auto& surface : {wavy(9), tetrahedron()}) {
      const auto normals = some_normals(surface);
      SaveOptions options;
      options.word = "(UCP)*";
      options.parameters = {{"omega", "1"}};
      for (const char* format : {"obj", "ply", "ply-ascii", "stl", "glb", "gltf"}) {
        CAPTURE(format);
        options.normals = nullptr;
        CHECK(save_bytes(flat<double>(surface), format, options) == save_bytes(surface, format, options));
        const std::string own = save_bytes(flat<double>(surface, &normals), format, options);
        options.normals = &normals;
        CHECK(own == save_bytes(surface, format, options));
      }
      const std::string off = save_bytes(flat<double>(surface), "off");
      CHECK(without_counts(off) == without_counts(save_bytes(surface, "off")));
      check_same(parse(off, "off"), surface);
    }
  }

  TEST_CASE("a flat mesh of floats gives the binary files of the surface with rounded points") {
    const auto surface = wavy(9);
    for (const char* format : {"glb", "gltf", "stl"}) {
      CAPTURE(format);
      CHECK(save_bytes(flat<float>(surface), format) == save_bytes(rounded(surface), format));
    }
    CHECK(flat<float>(surface).points.size() == 243);
  }

  TEST_CASE("floats come back from every format") {
    const auto surface = wavy(7);
    const auto normals = some_normals(surface);
    const auto mesh = flat<float>(surface, &normals);
    for (const char* format : {"obj", "ply", "ply-ascii", "off"}) {
      CAPTURE(format);
      const auto back = parse(save_bytes(mesh, format), std::string(format).substr(0, 3));
      CHECK(back.points.cast<float>() == surface.points.cast<float>());
      CHECK(back.mesh->vertex == surface.mesh->vertex);
      if (std::string(format) == "off") continue;
      for (Eigen::Index v = 0; v < normals.rows(); ++v) {
        const auto k = static_cast<std::size_t>(v);
        CHECK(static_cast<float>(back.attributes.at("nx")[k]) == static_cast<float>(normals(v, 0)));
        CHECK(static_cast<float>(back.attributes.at("nz")[k]) == static_cast<float>(normals(v, 2)));
      }
    }
    const auto seen = second_opinion(save_bytes(mesh, "glb"), true);
    const Json& attributes = seen.json["meshes"][0]["primitives"][0]["attributes"];
    CHECK(floats(seen, attributes["POSITION"]) == std::vector<double>(mesh.points.begin(), mesh.points.end()));
    CHECK(floats(seen, attributes["NORMAL"]) == std::vector<double>(mesh.normals.begin(), mesh.normals.end()));
  }

  TEST_CASE("floats are written with as few digits as they need") {
    auto surface = tetrahedron();
    surface.points(0, 0) = 0.1;
    CHECK(save_bytes(flat<float>(surface), "obj").starts_with("# made by udcp\nv 0.1 1 1\n"));
  }

  TEST_CASE("normals without direction are replaced by those of the faces") {
    auto surface = grid<double>(3, 2);
    Points<double> normals = Points<double>::Zero(surface.points.rows(), 3);
    normals.row(0) << 0.6, 0, 0.8;
    normals.row(1) << 3, 0, 4;
    const auto seen = second_opinion(save_bytes(flat<float>(surface, &normals), "glb"), true);
    const auto found = floats(seen, seen.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]);
    const auto near = [&](std::size_t v, double x, double z) {
      return std::abs(found[3 * v] - x) < 1e-7 && found[3 * v + 1] == 0 && std::abs(found[3 * v + 2] - z) < 1e-7;
    };
    CHECK(near(0, 0.6, 0.8));
    CHECK(near(1, 0.6, 0.8));
    for (std::size_t v = 2; v < 12; ++v) CHECK(near(v, 0, 1));
  }

  TEST_CASE("quads are cut along the shorter diagonal") {
    Points<double> points(4, 3);
    points << 0, 0, 0, 2, 0, 0, 3, 3, 0, 0, 2, 0;
    const auto mesh = flat<float>(make_surface(points, {{0, 1, 2, 3}}));
    CHECK(parse(save_bytes(mesh, "glb"), "glb").mesh->vertex == std::vector<int>{1, 2, 3, 1, 3, 0});
  }

  TEST_CASE("arrays that are no mesh are refused") {
    const auto answer = [](auto change) {
      auto mesh = flat<double>(tetrahedron());
      change(mesh);
      std::string first;
      for (const char* format : {"obj", "ply", "ply-ascii", "off", "stl", "glb", "gltf"}) {
        const std::string text = refusal([&] { save_bytes(mesh, format); });
        if (first.empty()) first = text;
        CHECK(text == first);
      }
      return first;
    };
    using Flat = FlatMesh<double>;
    CHECK(answer([](Flat& m) { m.points[4] = NAN; }) ==
          "E_NOT_FINITE: vertex 1 has a coordinate that is not finite; nothing was written");
    CHECK(answer([](Flat& m) { m.points[11] = -INFINITY; }) ==
          "E_NOT_FINITE: vertex 3 has a coordinate that is not finite; nothing was written");
    CHECK(answer([](Flat& m) { m.corners[5] = 4; }) == "E_INDEX: face 1 names vertex 4, but there are 4 vertices");
    CHECK(answer([](Flat& m) { m.corners = {}; }) == "E_NO_FACES: the mesh has no face");
    CHECK(answer([](Flat& m) { m.corners_per_face = 2; }) == "E_FACE_SIZE: the faces have 2 corners; faces need at least three");
    CHECK(answer([](Flat& m) { m.corners_per_face = 5; }) == "E_POINTS: the arrays of the mesh end inside a vertex or a face");
    CHECK(answer([](Flat& m) { m.points = Buffer<double>(11); }) ==
          "E_POINTS: the arrays of the mesh end inside a vertex or a face");
    CHECK(answer([](Flat& m) { m.normals = Buffer<double>(9); }) ==
          "E_POINTS: the normals do not fit the mesh: three numbers per vertex are needed");
  }

  TEST_CASE("options that a flat mesh cannot follow are refused") {
    const auto surface = tetrahedron();
    const auto normals = some_normals(surface);
    auto mesh = flat<double>(surface, &normals);
    SaveOptions options;
    options.colour_attribute = "w";
    CHECK(refusal([&] { save_bytes(mesh, "glb", options); }) ==
          "E_ATTRIBUTE: the surface has no attribute 'w' to show as colour");
    options = {};
    options.normals = &normals;
    CHECK(refusal([&] { save_bytes(mesh, "obj", options); }) ==
          "E_POINTS: normals are given beside the mesh; a flat mesh holds its own");
    CHECK(refusal([&] { save_bytes(mesh, "svg"); }).starts_with("E_FORMAT: cannot save a surface: unknown format 'svg'"));
    CHECK(refusal([&] { save(mesh, "mesh"); }).starts_with("E_FORMAT: mesh: the file name has no extension"));
    mesh.points[3] = 1e39;
    for (const char* format : {"stl", "glb"}) {
      CHECK(refusal([&] { save_bytes(mesh, format); }) ==
            "E_FLOAT_RANGE: vertex 1 has a coordinate beyond 3.4e38, which STL and glTF cannot hold");
    }
    mesh.normals[7] = NAN;
    for (const char* format : {"obj", "ply"}) {
      CHECK(refusal([&] { save_bytes(mesh, format); }) ==
            "E_NOT_FINITE: vertex 2 has a normal that is not finite; nothing was written");
    }
  }

  TEST_CASE("a glTF file of more than 4 GiB is refused before anything is computed") {
    FlatMesh<float> mesh;  // memory that nobody touches
    mesh.points = Buffer<float>(std::size_t{3} * 180'000'000);
    mesh.corners = Buffer<std::uint32_t>(4);
    const Folder folder;
    CHECK(refusal([&] { save(mesh, folder.path / "a.glb"); }) == "E_TOO_LARGE: a glTF file cannot hold more than 4 GiB");
    CHECK(folder.entries() == 0);
  }

  TEST_CASE("flat meshes are saved completely or not at all") {
    const Folder folder;
    const auto mesh = flat<float>(wavy(120));
    const auto file = folder.path / "a.glb";
    for (const char* name : {"a.glb", "a.ply", "a.obj", "a.stl", "a.off", "a.gltf"}) {
      save(mesh, folder.path / name);
      CHECK(read_file(folder.path / name) == save_bytes(mesh, std::string(name).substr(2)));
    }
    CHECK(folder.entries() == 6);
    write_file(file, "old");
    CHECK(refusal([&] { save(mesh, folder.path / "no" / "a.glb"); }) ==
          "E_FILE_WRITE: cannot write " + (folder.path / "no" / "a.glb").string() + ": the folder does not exist");
    for (const char* format : {"glb", "ply", "obj"}) {
      SaveOptions options;
      options.format = format;
      CHECK(refusal([&] { save(mesh, "/dev/full", options); }).starts_with("E_FILE_WRITE: cannot write /dev/full: "));
      CHECK(refusal([&] { save(mesh, "", options); }) == "E_FILE_WRITE: cannot write: the file name is empty");
      CHECK(child_says([&] {  // a limit on the size of files stands for a full disk
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{300000, 300000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        return refusal([&] { save(mesh, file, options); }).starts_with("E_FILE_WRITE: cannot write ");
      }));
    }
    auto broken = flat<float>(wavy(120));
    broken.points[7] = NAN;
    CHECK(refusal([&] { save(broken, file); }).starts_with("E_NOT_FINITE"));
    CHECK(read_file(file) == "old");
    CHECK(folder.entries() == 6);
  }

  TEST_CASE("a stop ends the writing of a mesh and leaves the file as it was") {
    const Folder folder;
    const auto file = folder.path / "a.obj";
    write_file(file, "old");
    std::atomic<bool> stop = true;
    SaveOptions options;
    options.stop = &stop;
    const Surface<double> surface = wavy(40);
    for (const char* format : {"obj", "ply", "glb", "gltf", "stl", "off"}) {
      options.format = format;
      CHECK(refusal([&] { save(surface, file, options); }).starts_with("E_INTERRUPTED"));
      CHECK(refusal([&] { save(flat<float>(surface), file, options); }).starts_with("E_INTERRUPTED"));
    }
    CHECK(read_file(file) == "old");
    CHECK(folder.entries() == 1);
    stop = false;
    {
      Writer out(file, &stop);  // stopped in the middle
      const std::string megabyte(1 << 20, 'x');
      out << megabyte;
      CHECK(folder.entries() == 2);
      stop = true;
      CHECK(refusal([&] { out << megabyte; }).starts_with("E_INTERRUPTED"));
    }
    CHECK(read_file(file) == "old");
    CHECK(folder.entries() == 1);
  }
}
