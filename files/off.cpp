// OFF, with colours (COFF: passed over) and normals (NOFF: attributes nx, ny, nz). One element a line; '#' opens comments.
#include "files/raw_mesh.h"

namespace udcp {
namespace {

/// What the header word says about the vertices.
struct OffHeader {
  bool colours = false, normals = false;
};

template <class S>
class OffReader {
 public:
  explicit OffReader(const Input& input) : input_(input), scan_(input, text_of(input), {}) {}

  RawMesh<S> mesh() {
    const OffHeader header = read_header();
    const std::int64_t vertices = read_count(first_, "vertices");
    const std::int64_t faces = read_count(scan_.word(), "faces");
    read_count(scan_.token(), "edges", true);
    if (const auto more = scan_.token(); !more.empty())
      scan_.fail("E_FILE_SYNTAX", "the line of counts goes on with " + in_quotes(more));
    expect_room(vertices, 6, "vertices");  // "0 0 0\n"
    for (std::int64_t v = 0; v < vertices; ++v) read_vertex(header, v, vertices);
    expect_room(faces, 8, "faces");  // "3 0 1 2\n"
    for (std::int64_t f = 0; f < faces; ++f) read_face(f, faces, vertices);
    next_line();
    if (const auto more = scan_.word(); !more.empty()) {
      scan_.fail("E_FILE_COUNT", "the file goes on with " + in_quotes(more) + " after " + std::to_string(faces) + " faces",
                 "correct the counts in the header");
    }
    return std::move(raw_);
  }

 private:
  OffHeader read_header();
  std::int64_t read_count(std::string_view token, const char* what, bool optional = false);
  void expect_room(std::int64_t count, std::size_t bytes, const char* what) const;
  void read_vertex(OffHeader header, std::int64_t v, std::int64_t count);
  void read_face(std::int64_t f, std::int64_t count, std::int64_t vertices);
  std::string_view element(const char* what, std::int64_t index, std::int64_t count);
  void next_line() {
    if (!scan_.next_line()) return;
  }

  const Input& input_;
  Scanner scan_;
  RawMesh<S> raw_;
  std::string_view first_;  // the token after the header word
  bool warned_more_ = false;
};

template <class S>
OffHeader OffReader<S>::read_header() {
  OffHeader header;
  const std::string_view word = scan_.word();
  if (word.empty())
    input_.fail(0, "E_FILE_EMPTY", input_.bytes.empty() ? "the file is empty" : "the file holds no vertex and no face");
  if (!word.ends_with("OFF")) {
    const bool number = word.find_first_not_of("0123456789-+") == std::string_view::npos;
    if (!number) scan_.fail("E_FILE_FORMAT", "the file starts with " + in_quotes(word) + "; OFF is expected");
    input_.warn(scan_.line(), "the header word OFF is missing");
    first_ = word;
    return header;
  }
  for (const char c : word.substr(0, word.size() - 3)) {
    if (c == 'C') {
      header.colours = true;
    } else if (c == 'N') {
      header.normals = true;
    } else {
      scan_.fail("E_FILE_FORMAT", "the variant " + in_quotes(word) + " is not supported", "OFF, COFF, NOFF and CNOFF are read");
    }
  }
  first_ = scan_.word();
  if (first_ == "BINARY") scan_.fail("E_FILE_FORMAT", "binary OFF is not supported", "save as text, or as PLY");
  return header;
}

template <class S>
std::int64_t OffReader<S>::read_count(std::string_view token, const char* what, bool optional) {
  if (token.empty() && optional) return 0;
  if (token.empty()) scan_.fail("E_FILE_SYNTAX", std::string("the number of ") + what + " is missing");
  const std::int64_t count = scan_.integer_of(token, "the count");
  if (count < 0)
    scan_.fail("E_FILE_COUNT",
               "the number of " + std::string(what) + " is " + std::to_string(count) + "; counts are not negative");
  return count;
}

template <class S>
void OffReader<S>::expect_room(std::int64_t count, std::size_t bytes, const char* what) const {
  const std::size_t most = (scan_.remaining() + 1) / bytes + 1;
  if (static_cast<std::uint64_t>(count) <= most) return;
  scan_.fail("E_FILE_COUNT", "the header promises " + std::to_string(count) + " " + what +
                                 ", but the rest of the file has room for at most " + std::to_string(most));
}

/// The first token of the next element, on a new line.
template <class S>
std::string_view OffReader<S>::element(const char* what, std::int64_t index, std::int64_t count) {
  next_line();
  const std::string_view token = scan_.word();
  if (!token.empty()) return token;
  scan_.fail("E_FILE_COUNT", "the file ends after " + std::to_string(index) + " of " + std::to_string(count) + " " + what,
             "correct the counts in the header, or the file is cut off");
}

template <class S>
void OffReader<S>::read_vertex(OffHeader header, std::int64_t v, std::int64_t count) {
  raw_.coordinates.push_back(scan_.number_of<S>(element("vertices", v, count), "the x coordinate"));
  raw_.coordinates.push_back(scan_.number<S>("the y coordinate"));
  raw_.coordinates.push_back(scan_.number<S>("the z coordinate"));
  if (header.normals) {
    for (const char* name : {"nx", "ny", "nz"}) raw_.attributes[name].push_back(scan_.number<S>("a normal component"));
  }
  const std::string_view more = scan_.token();
  if (more.empty() || header.colours || warned_more_) return;
  input_.warn(scan_.line(), "numbers after the coordinates of a vertex; ignored");
  warned_more_ = true;
}

template <class S>
void OffReader<S>::read_face(std::int64_t f, std::int64_t count, std::int64_t vertices) {
  const std::int64_t size = scan_.integer_of(element("faces", f, count), "the number of corners");
  const auto fail = [&](const char* code, const std::string& message) {
    scan_.fail(code, "face " + std::to_string(f) + message);
  };
  if (size < 3) fail("E_FILE_SYNTAX", " has " + std::to_string(size) + " corners; faces need at least three");
  for (std::int64_t k = 0; k < size; ++k) {
    const std::string_view token = scan_.token();
    if (token.empty())
      fail("E_FILE_SYNTAX", " promises " + std::to_string(size) + " corners, but only " + std::to_string(k) + " follow");
    const std::int64_t v = scan_.integer_of(token, "vertex");
    if (v < 0 || v >= vertices) {
      const std::string known = std::to_string(vertices) + " vertices (0 to " + std::to_string(vertices - 1) + ")";
      fail("E_FILE_INDEX", " names vertex " + std::to_string(v) + ", but there are " + known);
    }
    raw_.corners.push_back(static_cast<int>(v));
  }
  expect_int_count(input_, raw_.corners.size(), "corners");
  raw_.close_face(scan_.line());
}

}  // namespace

template <class S>
RawMesh<S> read_off(const Input& input) {
  return OffReader<S>(input).mesh();
}

template <class R>
void write_off(Writer& out, const MeshView<R>& mesh, const SaveOptions& options) {
  check_for_writing(mesh);
  const int edges = mesh.surface ? mesh.surface->mesh->edges() : 0;  // readers ignore the number; 0 says that it is not known
  out << "OFF\n# " << comment_line(options.word) << '\n' << mesh.vertices() << ' ' << mesh.faces() << ' ' << edges << '\n';
  for (std::size_t k = 0; k < mesh.points.size(); ++k) out << mesh.points[k] << (k % 3 < 2 ? ' ' : '\n');
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    out << mesh.face(f).size();
    for (const std::uint32_t v : mesh.face(f)) out << ' ' << v;
    out << '\n';
  }
}

template void write_off(Writer&, const MeshView<float>&, const SaveOptions&);
template void write_off(Writer&, const MeshView<double>&, const SaveOptions&);

#define UDCP_READ_OFF(S) template RawMesh<S> read_off<S>(const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_READ_OFF)
#undef UDCP_READ_OFF

}  // namespace udcp
