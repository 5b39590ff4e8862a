// STL, binary and ascii. The format repeats every point; bit-identical ones become one vertex. Normals in the file are not used:
// the order of the corners says the same.
#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "files/raw_mesh.h"

namespace udcp {
namespace {

constexpr std::size_t header_size = 80, facet_size = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return value;
}

/// "solid" also opens some binary files; only text goes on with "facet" or "endsolid".
bool is_text(std::string_view bytes) {
  const auto word = bytes.find_first_not_of(" \t\r\n");
  if (word == std::string_view::npos || !bytes.substr(word).starts_with("solid")) return false;
  const std::string_view start = bytes.substr(0, 4096);
  return start.find("facet") != std::string_view::npos || start.find("endsolid") != std::string_view::npos;
}

std::vector<double> read_binary(const Input& input) {
  const std::string_view bytes = input.bytes;
  if (bytes.empty()) input.fail(0, "E_FILE_EMPTY", "the file is empty");
  if (bytes.size() < header_size + 4) {
    input.fail(0, "E_FILE_FORMAT",
               "the file has " + std::to_string(bytes.size()) +
                   " bytes; a binary STL has at least 84, and an ascii one starts with 'solid'");
  }
  const std::uint64_t count = word_at(bytes, header_size), room = (bytes.size() - header_size - 4) / facet_size;
  if (count > room) {
    input.fail(0, "E_FILE_COUNT",
               "the file promises " + std::to_string(count) + " triangles, but holds only " + std::to_string(room),
               "the file is cut off or damaged");
  }
  if (bytes.size() > header_size + 4 + count * facet_size) {
    input.warn(0,
               std::to_string(bytes.size() - header_size - 4 - count * facet_size) + " bytes follow the last triangle; ignored");
  }
  expect_int_count(input, static_cast<std::size_t>(9 * count), "coordinates");
  std::vector<double> coordinates;
  coordinates.reserve(static_cast<std::size_t>(9 * count));
  for (std::size_t f = 0; f < count; ++f) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = header_size + 4 + f * facet_size + 12 + 4 * k;
      const double value{std::bit_cast<float>(word_at(bytes, at))};
      if (!std::isfinite(value)) {
        input.fail(
            0, "E_FILE_NUMBER",
            "triangle " + std::to_string(f) + " (byte " + std::to_string(at) + ") has a coordinate that is not a finite number");
      }
      coordinates.push_back(value);
    }
  }
  return coordinates;
}

template <class S>
class TextReader {
 public:
  explicit TextReader(const Input& input) : input_(input), scan_(input, text_of(input), {.hash_comments = false}) {}

  /// Decimals, in the number type; `rounded` gets the same as doubles, for welding.
  std::vector<S> read(std::vector<double>& rounded, std::vector<std::uint32_t>& lines) {
    expect("solid");
    scan_.next_line();
    for (auto word = scan_.word(); word != "endsolid"; word = scan_.word()) {
      if (word != "facet") unexpected(word, "facet or endsolid");
      lines.push_back(static_cast<std::uint32_t>(scan_.line()));
      scan_.next_line();  // the normal
      expect("outer");
      expect("loop");
      for (int k = 0; k < 3; ++k) {
        expect("vertex");
        for (int c = 0; c < 3; ++c) {
          const std::string_view token = scan_.word();
          values_.push_back(scan_.number_of<S>(token, "a coordinate"));
          rounded.push_back(scan_.number_of<double>(token, "a coordinate"));
        }
      }
      expect("endloop");
      expect("endfacet");
      expect_int_count(input_, rounded.size(), "coordinates");
    }
    scan_.next_line();
    if (const auto more = scan_.word(); !more.empty()) input_.warn(scan_.line(), "the file goes on after endsolid; ignored");
    return std::move(values_);
  }

 private:
  [[noreturn]] void unexpected(std::string_view word, const char* wanted) const {
    scan_.fail("E_FILE_SYNTAX", word.empty() ? std::string("the file ends where ") + wanted + " is expected"
                                             : in_quotes(word) + " stands where " + wanted + " is expected");
  }
  void expect(const char* wanted) {
    if (const auto word = scan_.word(); word != wanted) unexpected(word, wanted);
  }

  const Input& input_;
  Scanner scan_;
  std::vector<S> values_;
};

}  // namespace

template <class S>
RawMesh<S> read_stl(const Input& input) {
  RawMesh<S> raw;
  std::vector<double> coordinates;
  std::vector<S> values;
  std::vector<std::uint32_t> lines;
  if (is_text(input.bytes)) {
    values = TextReader<S>(input).read(coordinates, lines);
  } else {
    coordinates = read_binary(input);
    for (const double value : coordinates) values.push_back(exact_from<S>(value));
  }
  if (values.empty()) input.fail(0, "E_FILE_EMPTY", "the file holds no triangle");
  std::vector<int> kept;
  raw.corners = weld(coordinates, kept);
  for (const int k : kept) {
    for (std::size_t c = 0; c < 3; ++c) raw.coordinates.push_back(values[3 * static_cast<std::size_t>(k) + c]);
  }
  for (std::size_t f = 1; 3 * f <= raw.corners.size(); ++f) raw.begin.push_back(static_cast<int>(3 * f));
  raw.face_lines = std::move(lines);
  return raw;
}

namespace {

/// One facet: the unit normal of its triangle (0 0 0 where it has none), three points, two bytes that mean nothing.
template <class R>
char* put_facet(char* to, const MeshView<R>& mesh, const std::array<std::uint32_t, 3>& face) {
  Eigen::Vector3d p[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto point = mesh.point(face[k]);
    p[k] = {point[0], point[1], point[2]};
  }
  const Eigen::Vector3d area = (p[1] - p[0]).cross(p[2] - p[0]);
  const double length = area.norm();
  const Eigen::Vector3d normal = length > 0 && std::isfinite(length) ? Eigen::Vector3d(area / length) : Eigen::Vector3d::Zero();
  for (Eigen::Index c = 0; c < 3; ++c) to = put_bytes(to, static_cast<float>(normal(c)));
  for (const std::uint32_t v : face) {
    for (std::size_t c = 0; c < 3; ++c) to = put_bytes(to, static_cast<float>(mesh.points[std::size_t{3} * v + c]));
  }
  return put_bytes(to, std::uint16_t{0});
}

}  // namespace

template <class R>
void write_stl(Writer& out, const MeshView<R>& mesh, const SaveOptions& options) {
  if (mesh.triangles() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "an STL file cannot hold more than 2^32 - 1 triangles",
                "refine less, or save as PLY");
  }
  check_for_floats(mesh);
  std::string head = comment_line(options.word).substr(0, header_size);  // must not start with "solid"
  head.resize(header_size, ' ');
  out << head;
  out.filled(put_bytes(out.room(4), static_cast<std::uint32_t>(mesh.triangles())));
  for_each_triangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out.filled(put_facet(out.room(facet_size), mesh, {a, b, c}));
  });
}

template void write_stl(Writer&, const MeshView<float>&, const SaveOptions&);
template void write_stl(Writer&, const MeshView<double>&, const SaveOptions&);

#define UDCP_READ_STL(S) template RawMesh<S> read_stl<S>(const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_READ_STL)
#undef UDCP_READ_STL

}  // namespace udcp
