// Wavefront OBJ: polygon meshes (v, vn, f), tags (groups corner, lat, lon) and curves (one l line). Materials, texture
// coordinates and free-form geometry are passed over.
#include <algorithm>
#include <array>

#include "files/obj_lines.h"
#include "files/raw_mesh.h"

namespace udcp {
namespace {

constexpr int most_unknown_warnings = 10;

enum class Group { plain, corner, latitude, longitude };

template <class S>
class ObjReader {
 public:
  explicit ObjReader(const Input& input) : input_(input), scan_(input, text_of(input), {.backslash_joins = true}) {}

  void run() {
    reserve();
    do {
      const std::string_view keyword = scan_.token();
      if (!keyword.empty()) statement(keyword);
    } while (scan_.next_line());
    if (unknown_ > most_unknown_warnings) {
      input_.warn(0, std::to_string(unknown_ - most_unknown_warnings) + " more lines with unknown keywords; ignored");
    }
    if (scan_.saw_bare_cr()) input_.warn(0, "some lines end with a bare CR; taken as line ends");
    expect_int_count(input_, raw_.coordinates.size() / 3, "vertices");
    expect_int_count(input_, raw_.corners.size(), "corners");
    check_forward_references();
    if (raw_.coordinates.empty() && raw_.corners.empty()) {
      input_.fail(0, "E_FILE_EMPTY", input_.bytes.empty() ? "the file is empty" : "the file holds no vertex and no face");
    }
  }

  RawMesh<S> mesh() {
    run();
    raw_.first_index = 1;
    take_normals();
    return std::move(raw_);
  }

  Polyline<S> curve();

 private:
  void reserve();
  void statement(std::string_view keyword);
  bool read_plain_vertex();
  bool read_plain_face();
  void add_corner(int v, int normal);
  void read_vertex();
  void read_normal();
  void read_face();
  void read_corner(std::string_view token);
  int read_index(std::string_view digits, std::size_t count, const char* what);
  void read_group();
  void read_line_element();
  void read_points();
  void note_unknown(std::string_view keyword);
  void check_forward_references() const;
  void take_normals();
  [[nodiscard]] std::size_t vertices() const { return raw_.coordinates.size() / 3; }

  const Input& input_;
  Scanner scan_;
  RawMesh<S> raw_;
  std::vector<S> normals_;
  std::vector<int> corner_normal_;       // per corner of the faces: its normal or -1; empty as long as no corner has one
  std::vector<std::vector<int>> lines_;  // l lines outside tag groups
  std::vector<std::int64_t> line_lines_;
  Group group_ = Group::plain;
  bool forward_ = false, warned_mixed_ = false, warned_weight_ = false, warned_free_form_ = false, warned_element_ = false;
  int unknown_ = 0;
};

/// Room for what the lines seem to hold, so that long lists do not move while they grow.
template <class S>
void ObjReader<S>::reserve() {
  const std::string_view text = scan_.ahead();
  std::size_t vertices = 0, faces = 0;
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    vertices += text[at] == 'v' && text[at + 1] == ' ' ? 1U : 0U;
    faces += text[at] == 'f' && text[at + 1] == ' ' ? 1U : 0U;
    at = std::min(text.find('\n', at), text.size() - 1);
  }
  if (vertices + faces > text.size() / 8) return;  // "v 0 0 0\n" and "f 1 2 3\n" are the shortest that are right
  raw_.coordinates.reserve(3 * vertices);
  raw_.begin.reserve(faces + 1);
  raw_.face_lines.reserve(faces);
  raw_.corners.reserve(4 * faces);
}

template <class S>
void ObjReader<S>::statement(std::string_view keyword) {
  if (keyword == "v") return read_plain_vertex() ? void() : read_vertex();
  if (keyword == "f" || keyword == "fo") return read_plain_face() ? void() : read_face();
  if (keyword == "vn") return read_normal();
  if (keyword == "g" || keyword == "o") return read_group();
  if (keyword == "l") return read_line_element();
  if (keyword == "p") return read_points();
  if (is_known(keyword)) return;
  if (!is_free_form(keyword)) return note_unknown(keyword);
  if (!warned_free_form_) input_.warn(scan_.line(), "free-form geometry (" + in_quotes(keyword) + ") is not read; ignored");
  warned_free_form_ = true;
}

/// Nearly every line of a large file is three plain numbers. Anything else is left, with nothing taken, to read_vertex, which
/// knows what may stand there and says what may not.
template <class S>
bool ObjReader<S>::read_plain_vertex() {
  const std::string_view text = scan_.ahead();
  const char *at = text.data(), *end = at + text.size();
  S place[3];
  for (S& value : place) {
    if (at_line_end(at, end)) return false;
    at = plain_number(at, end, value);
    if (at == nullptr || (at != end && *at > ' ')) return false;
  }
  if (!at_line_end(at, end)) return false;
  for (S& value : place) raw_.coordinates.push_back(std::move(value));
  scan_.jump(at);
  return true;
}

template <class S>
void ObjReader<S>::read_vertex() {
  raw_.coordinates.push_back(scan_.number<S>("the x coordinate"));
  raw_.coordinates.push_back(scan_.number<S>("the y coordinate"));
  raw_.coordinates.push_back(scan_.number<S>("the z coordinate"));
  // A weight, a colour, or both may follow: 4, 6 or 7 numbers in all.
  std::size_t count = 0;
  double weight = 1;
  for (auto more = scan_.token(); !more.empty(); more = scan_.token(), ++count) {
    const auto value = scan_.number_of<double>(more, "the weight or colour");
    if (count == 0) weight = value;
  }
  if (count == 0 || count == 3) return;
  if (count != 1 && count != 4) {
    scan_.fail("E_FILE_SYNTAX",
               "a vertex has " + std::to_string(3 + count) + " numbers; three coordinates, then at most a weight and a colour");
  }
  if (weight != 1 && !warned_weight_) input_.warn(scan_.line(), "a vertex has a weight other than 1; weights are ignored");
  warned_weight_ = warned_weight_ || weight != 1;
}

template <class S>
void ObjReader<S>::read_normal() {
  for (const char* what : {"the x component", "the y component", "the z component"}) normals_.push_back(scan_.number<S>(what));
  if (const auto more = scan_.token(); !more.empty())
    scan_.fail("E_FILE_SYNTAX", "a normal has three components; " + in_quotes(more) + " follows");
}

/// An index as OBJ counts, from 1, or backwards from the last element so far.
template <class S>
int ObjReader<S>::read_index(std::string_view digits, std::size_t count, const char* what) {
  const std::int64_t index = scan_.integer_of(digits, what);
  if (index > 0 && index <= std::int64_t{2147483647}) return static_cast<int>(index - 1);
  const auto known = static_cast<std::int64_t>(count);
  if (index < 0 && -index <= known) return static_cast<int>(known + index);
  if (index == 0)
    scan_.fail("E_FILE_INDEX", std::string(what) + " 0 does not exist", "indices count from 1, or backwards from -1");
  scan_.fail("E_FILE_INDEX", std::string(what) + " " + std::to_string(index) + " does not exist; " + std::to_string(known) +
                                 " were given so far");
}

template <class S>
void ObjReader<S>::add_corner(int v, int normal) {
  forward_ = forward_ || static_cast<std::size_t>(v) >= vertices();
  if (normal >= 0 && corner_normal_.size() < raw_.corners.size()) corner_normal_.resize(raw_.corners.size(), -1);
  if (normal >= 0 || !corner_normal_.empty()) corner_normal_.push_back(normal);
  raw_.corners.push_back(v);
}

/// Up to eight corners of one form, separated by spaces. Anything else is left, with nothing taken, to read_face.
template <class S>
bool ObjReader<S>::read_plain_face() {
  const std::string_view text = scan_.ahead();
  const char *at = text.data(), *end = at + text.size();
  std::array<PlainCorner, 8> corners;
  std::size_t size = 0;
  for (; !at_line_end(at, end); ++size) {
    if (size == corners.size() || !corners[size].read(at, end) || (at != end && *at > ' ')) return false;
    if (corners[size].form != corners[0].form) return false;
  }
  if (size < 3) return false;
  for (std::size_t k = 0; k < size; ++k) add_corner(corners[k].vertex - 1, corners[k].normal - 1);
  expect_int_count(input_, raw_.corners.size(), "corners");
  raw_.close_face(scan_.line());
  scan_.jump(at);
  return true;
}

/// v, v/vt, v//vn or v/vt/vn.
template <class S>
void ObjReader<S>::read_corner(std::string_view token) {
  const auto slash = token.find('/');
  const int v = read_index(token.substr(0, slash), vertices(), "vertex");
  int normal = -1;
  if (slash != std::string_view::npos) {
    std::string_view rest = token.substr(slash + 1);
    const auto second = rest.find('/');
    const std::string_view texture = rest.substr(0, second);
    const std::string_view normal_digits = second == std::string_view::npos ? std::string_view{} : rest.substr(second + 1);
    if ((texture.empty() && normal_digits.empty()) || (second != std::string_view::npos && normal_digits.empty()) ||
        normal_digits.find('/') != std::string_view::npos) {
      scan_.fail("E_FILE_SYNTAX", "malformed corner " + in_quotes(token), "write v, v/vt, v//vn or v/vt/vn");
    }
    if (!texture.empty() && scan_.integer_of(texture, "texture vertex") == 0)
      scan_.fail("E_FILE_INDEX", "texture vertex 0 does not exist", "indices count from 1");
    if (!normal_digits.empty()) normal = read_index(normal_digits, normals_.size() / 3, "normal");
  }
  add_corner(v, normal);
}

template <class S>
void ObjReader<S>::read_face() {
  const std::size_t before = raw_.corners.size();
  const std::int64_t line = scan_.line();
  int form = -1;
  bool mixed = false;
  for (auto token = scan_.token(); !token.empty(); token = scan_.token()) {
    read_corner(token);
    mixed = mixed || (form >= 0 && form != form_of(token));
    form = form_of(token);
  }
  const std::size_t size = raw_.corners.size() - before;
  if (size < 3) {
    input_.fail(line, "E_FILE_SYNTAX",
                "face " + std::to_string(raw_.faces() + 1) + " has " + std::to_string(size) +
                    (size == 1 ? " corner" : " corners") + "; faces need at least three");
  }
  expect_int_count(input_, raw_.corners.size(), "corners");
  raw_.close_face(line);
  if (mixed && !warned_mixed_)
    input_.warn(line, "the corners of a face mix the forms v, v/vt, v//vn and v/vt/vn; only positions count");
  warned_mixed_ = warned_mixed_ || mixed;
}

template <class S>
void ObjReader<S>::read_group() {
  group_ = Group::plain;
  for (auto name = scan_.token(); !name.empty(); name = scan_.token()) {
    if (name == "corner") group_ = Group::corner;
    if (name == "lat") group_ = Group::latitude;
    if (name == "lon") group_ = Group::longitude;
  }
}

template <class S>
void ObjReader<S>::read_line_element() {
  std::vector<int> line;
  for (auto token = scan_.token(); !token.empty(); token = scan_.token()) {
    line.push_back(read_index(token.substr(0, token.find('/')), vertices(), "vertex"));
    if (static_cast<std::size_t>(line.back()) >= vertices()) {
      scan_.fail("E_FILE_INDEX", "the line names vertex " + std::to_string(line.back() + 1) + ", but only " +
                                     std::to_string(vertices()) + " were given so far");
    }
  }
  if (line.size() < 2) scan_.fail("E_FILE_SYNTAX", "a line needs at least two vertices");
  if (group_ == Group::latitude || group_ == Group::longitude) {
    const EdgeTag tag = group_ == Group::latitude ? EdgeTag::latitude : EdgeTag::longitude;
    for (std::size_t k = 1; k < line.size(); ++k) raw_.edges.push_back({line[k - 1], line[k], tag, scan_.line()});
    return;
  }
  if (group_ == Group::corner && !warned_element_) {
    input_.warn(scan_.line(), "an 'l' line in group corner marks nothing; 'p' points mark corners");
    warned_element_ = true;
  }
  lines_.push_back(std::move(line));
  line_lines_.push_back(scan_.line());
}

template <class S>
void ObjReader<S>::read_points() {
  for (auto token = scan_.token(); !token.empty(); token = scan_.token()) {
    const int v = read_index(token, vertices(), "vertex");
    if (static_cast<std::size_t>(v) >= vertices()) {
      scan_.fail("E_FILE_INDEX", "the point names vertex " + std::to_string(v + 1) + ", but only " + std::to_string(vertices()) +
                                     " were given so far");
    }
    if (group_ == Group::corner) raw_.tagged_corners.push_back({v, scan_.line()});
  }
  if ((group_ == Group::latitude || group_ == Group::longitude) && !warned_element_) {
    input_.warn(scan_.line(), "a 'p' line in group lat or lon marks nothing; 'l' lines mark edges");
    warned_element_ = true;
  }
}

template <class S>
void ObjReader<S>::note_unknown(std::string_view keyword) {
  const bool printable = std::ranges::all_of(keyword, [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable)
    scan_.fail("E_FILE_SYNTAX", "the line starts with " + in_quotes(keyword) + "; this is no OBJ text, or it is damaged");
  if (++unknown_ <= most_unknown_warnings) input_.warn(scan_.line(), "unknown keyword " + in_quotes(keyword) + "; ignored");
}

/// Faces may stand before their vertices, so the upper end of the indices is checked last.
template <class S>
void ObjReader<S>::check_forward_references() const {
  const auto fail_at = [&](std::size_t corner, const std::string& what, int index, std::size_t count) {
    const auto face = std::upper_bound(raw_.begin.begin(), raw_.begin.end(), static_cast<int>(corner)) - raw_.begin.begin() - 1;
    input_.fail(raw_.face_lines[static_cast<std::size_t>(face)], "E_FILE_INDEX",
                "face " + std::to_string(face + 1) + " names " + what + " " + std::to_string(index + 1) + ", but there are " +
                    std::to_string(count) + (what == "vertex" ? " vertices" : " normals"),
                "correct the index or add what is missing");
  };
  if (forward_) {
    for (std::size_t k = 0; k < raw_.corners.size(); ++k) {
      if (static_cast<std::size_t>(raw_.corners[k]) >= vertices()) fail_at(k, "vertex", raw_.corners[k], vertices());
    }
    input_.warn(raw_.face_lines.front(), "faces stand before the vertices that they name");
  }
  for (std::size_t k = 0; k < corner_normal_.size(); ++k) {
    if (corner_normal_[k] >= static_cast<int>(normals_.size() / 3)) fail_at(k, "normal", corner_normal_[k], normals_.size() / 3);
  }
}

/// Normals become attributes if every corner has one and all corners at a vertex agree.
template <class S>
void ObjReader<S>::take_normals() {
  if (corner_normal_.empty() || corner_normal_.size() != raw_.corners.size()) return;
  std::vector<int> of_vertex(vertices(), -1);
  for (std::size_t k = 0; k < raw_.corners.size(); ++k) {
    const int n = corner_normal_[k];
    int& known = of_vertex[static_cast<std::size_t>(raw_.corners[k])];
    if (n < 0) return;
    if (known < 0) known = n;
    const S *a = normals_.data() + 3 * static_cast<std::size_t>(n), *b = normals_.data() + 3 * static_cast<std::size_t>(known);
    if (known != n && !std::equal(a, a + 3, b)) return;
  }
  const char* names[] = {"nx", "ny", "nz"};
  for (std::size_t c = 0; c < 3; ++c) {
    auto& column = raw_.attributes[names[c]];
    for (const int n : of_vertex) column.push_back(n < 0 ? S(0) : normals_[3 * static_cast<std::size_t>(n) + c]);
  }
}

template <class S>
Polyline<S> ObjReader<S>::curve() {
  run();
  if (lines_.size() != 1) {
    const auto line = lines_.size() > 1 ? line_lines_[1] : std::int64_t{0};
    input_.fail(line, lines_.empty() ? "E_FILE_EMPTY" : "E_FILE_SYNTAX",
                lines_.empty() ? "the file holds no 'l' line, so no curve" : "a second 'l' line; a curve is one line",
                "a curve is one 'l' line, closed if its last index is the first");
  }
  std::vector<int> path = lines_[0];
  Polyline<S> curve;
  curve.closed = path.front() == path.back();
  if (curve.closed) path.pop_back();
  if (path.size() < (curve.closed ? 3U : 2U))
    input_.fail(line_lines_[0], "E_FILE_SYNTAX", "a closed curve needs at least three points");
  curve.points.resize(static_cast<Eigen::Index>(path.size()), 3);
  for (std::size_t k = 0; k < path.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      curve.points.data()[3 * k + c] = raw_.coordinates[3 * static_cast<std::size_t>(path[k]) + c];
  }
  std::vector<char> is_corner(vertices(), 0), on_curve(vertices(), 0);
  for (const int v : path) on_curve[static_cast<std::size_t>(v)] = 1;
  for (const TaggedVertex& corner : raw_.tagged_corners) {
    const auto v = static_cast<std::size_t>(corner.vertex);
    if (!on_curve[v])
      input_.fail(corner.line, "E_FILE_TAG", "vertex " + std::to_string(v + 1) + " in group corner is not on the curve");
    is_corner[v] = 1;
  }
  if (raw_.tagged_corners.empty()) return curve;
  for (const int v : path) curve.corner.push_back(is_corner[static_cast<std::size_t>(v)]);
  return curve;
}

}  // namespace

template <class S>
RawMesh<S> read_obj(const Input& input) {
  return ObjReader<S>(input).mesh();
}

template <class S>
Polyline<S> read_obj_curve(const Input& input) {
  return ObjReader<S>(input).curve();
}

#define UDCP_READ_OBJ(S)                         \
  template RawMesh<S> read_obj<S>(const Input&); \
  template Polyline<S> read_obj_curve<S>(const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_READ_OBJ)
#undef UDCP_READ_OBJ

}  // namespace udcp
