// PLY: ascii and both binary byte orders, every scalar type, lists. Elements and properties that are not understood are read
// over; further scalar properties of the vertices become attributes.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "files/raw_mesh.h"

namespace udcp {
namespace {

constexpr std::size_t most_entries = 1000;  // elements of a file, properties of an element

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Format { ascii, little, big };

std::optional<Type> type_of(std::string_view name) {
  struct Row {
    std::string_view name;
    Type type;
  };
  constexpr Row rows[] = {
      {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
      {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
      {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
      {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
  for (const Row& row : rows) {
    if (row.name == name) return row.type;
  }
  return std::nullopt;
}

std::size_t size_of(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
bool is_float(Type type) { return type == Type::float32 || type == Type::float64; }

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // of a list
};
struct Element {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties;
};
struct Header {
  Format format = Format::ascii;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  HeaderReader(const Input& input, Scanner& scan) : input_(input), scan_(scan) {}
  Header read() {
    if (scan_.token() != "ply") {
      if (input_.bytes.empty()) input_.fail(0, "E_FILE_EMPTY", "the file is empty");
      scan_.fail("E_FILE_FORMAT", "the file does not start with 'ply'");
    }
    for (;;) {
      if (!scan_.next_line()) scan_.fail("E_FILE_SYNTAX", "the header has no end_header line");
      const std::string_view word = scan_.token();
      if (word == "end_header") break;
      if (!word.empty()) statement(word);
    }
    if (!seen_format_) scan_.fail("E_FILE_SYNTAX", "the header has no format line");
    return std::move(header_);
  }

 private:
  void statement(std::string_view word) {
    if (word == "comment" || word == "obj_info") return;
    if (word == "format") return read_format();
    if (word == "element") return read_element();
    if (word == "property") return read_property();
    scan_.fail("E_FILE_SYNTAX", "unknown header line " + in_quotes(word), "every header ends with a line end_header");
  }
  void read_format() {
    const std::string_view name = scan_.token(), version = scan_.token();
    seen_format_ = true;
    if (name == "binary_little_endian") {
      header_.format = Format::little;
    } else if (name == "binary_big_endian") {
      header_.format = Format::big;
    } else if (name != "ascii") {
      scan_.fail("E_FILE_FORMAT", "unknown format " + in_quotes(name),
                 "ascii, binary_little_endian and binary_big_endian are read");
    }
    if (version != "1.0") scan_.fail("E_FILE_FORMAT", "unknown version " + in_quotes(version) + "; 1.0 is expected");
  }
  void read_element() {
    const std::string_view name = scan_.token(), count = scan_.token();
    if (count.empty()) scan_.fail("E_FILE_SYNTAX", "an element line needs a name and a count");
    const std::int64_t value = scan_.integer_of(count, "the count");
    if (value < 0)
      scan_.fail("E_FILE_COUNT",
                 "the count of element " + in_quotes(name) + " is " + std::to_string(value) + "; counts are not negative");
    for (const Element& element : header_.elements) {
      if (element.name == name) scan_.fail("E_FILE_SYNTAX", "element " + in_quotes(name) + " stands twice in the header");
    }
    if (header_.elements.size() == most_entries) scan_.fail("E_FILE_TOO_LARGE", "the header has more than 1000 elements");
    header_.elements.push_back({std::string(name), value, {}});
  }
  Type read_type() {
    const std::string_view name = scan_.token();
    const auto type = type_of(name);
    if (!type) scan_.fail("E_FILE_SYNTAX", "unknown type " + in_quotes(name));
    return *type;
  }
  void read_property() {
    if (header_.elements.empty()) scan_.fail("E_FILE_SYNTAX", "a property before the first element");
    Property property{};
    Scanner ahead = scan_;
    if (ahead.token() == "list") {
      scan_ = ahead;
      property.count = read_type();
      if (is_float(*property.count)) scan_.fail("E_FILE_SYNTAX", "the length of a list needs an integer type");
    }
    property.type = read_type();
    property.name = scan_.token();
    if (property.name.empty()) scan_.fail("E_FILE_SYNTAX", "a property needs a name");
    auto& properties = header_.elements.back().properties;
    for (const Property& other : properties) {
      if (other.name == property.name)
        scan_.fail("E_FILE_SYNTAX", "property " + in_quotes(property.name) + " stands twice in its element");
    }
    if (properties.size() == most_entries) scan_.fail("E_FILE_TOO_LARGE", "an element has more than 1000 properties");
    properties.push_back(std::move(property));
  }

  const Input& input_;
  Scanner& scan_;
  Header header_;
  bool seen_format_ = false;
};

/// Numbers of the body, from text or from bytes.
class Body {
 public:
  Body(const Input& input, Scanner after_header, Format format) : input_(input), scan_(after_header), format_(format) {
    data_ = scan_.after_line();
    if (format != Format::ascii) return;
    if (data_.find('\0') != std::string_view::npos) scan_.fail("E_FILE_FORMAT", "NUL byte in an ascii file; it is damaged");
  }

  void begin(const Element& element, std::int64_t index) {
    element_ = &element;
    index_ = index;
  }
  [[nodiscard]] std::int64_t line() const { return is_text() ? scan_.line() : 0; }
  /// Every value takes at least this many bytes of those that remain.
  [[nodiscard]] std::uint64_t room_for(Type type) const {
    return is_text() ? scan_.remaining() / 2 + 1 : data_.size() / size_of(type);
  }

  template <class S>
  S number(const Property& property) {
    if (is_text()) return scan_.number_of<S>(word(), property.name.c_str());
    const double value = bytes_to_number(property.type);
    if (!std::isfinite(value)) fail("E_FILE_NUMBER", "property " + property.name + " is not a finite number");
    return exact_from<S>(value);
  }
  std::int64_t integer(Type type, const char* what) {
    if (is_text()) return scan_.integer_of(word(), what);
    const double value = bytes_to_number(type);
    if (!(std::abs(value) < 1e15) || std::floor(value) != value) fail("E_FILE_NUMBER", std::string(what) + " is not an integer");
    return static_cast<std::int64_t>(value);
  }
  std::int64_t list_size(const Property& property) {
    const std::int64_t size = integer(*property.count, "the length of a list");
    if (size < 0)
      fail("E_FILE_COUNT", "the length of list " + property.name + " is " + std::to_string(size) + "; lengths are not negative");
    if (static_cast<std::uint64_t>(size) > room_for(property.type)) {
      fail("E_FILE_COUNT", "list " + property.name + " of length " + std::to_string(size) + " does not fit the rest of the file");
    }
    return size;
  }
  void skip(const Property& property) {
    for (std::int64_t count = property.count ? list_size(property) : 1; count > 0; --count) {
      if (is_text()) {
        word();
      } else {
        bytes_to_number(property.type);
      }
    }
  }
  void expect_end() {
    if (is_text()) {
      if (const auto more = scan_.word(); !more.empty()) {
        scan_.fail("E_FILE_COUNT", "the file goes on with " + in_quotes(more) + " after the last element",
                   "correct the counts in the header");
      }
    } else if (!data_.empty()) {
      input_.warn(0, std::to_string(data_.size()) + " bytes follow the last element; ignored");
    }
  }
  /// Names the element that is being read.
  [[noreturn]] void fail(const char* code, const std::string& message, const std::string& help = {}) const {
    input_.fail(line(), code, element_->name + " " + std::to_string(index_) + ": " + message, help);
  }

 private:
  [[nodiscard]] bool is_text() const { return format_ == Format::ascii; }
  [[noreturn]] void end_of_file() const {
    fail("E_FILE_COUNT",
         "the file ends here; the header promises " + std::to_string(element_->count) + " of element " + element_->name,
         "correct the counts in the header, or the file is cut off");
  }
  std::string_view word() {
    const std::string_view found = scan_.word();
    if (found.empty()) end_of_file();
    return found;
  }
  double bytes_to_number(Type type) {
    const std::size_t size = size_of(type);
    if (data_.size() < size) end_of_file();
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < size; ++k) {
      bits = bits << 8 | static_cast<unsigned char>(data_[format_ == Format::big ? k : size - 1 - k]);
    }
    data_.remove_prefix(size);
    switch (type) {
      case Type::int8:
        return static_cast<std::int8_t>(bits);
      case Type::int16:
        return static_cast<std::int16_t>(bits);
      case Type::int32:
        return static_cast<std::int32_t>(bits);
      case Type::float32:
        return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
      case Type::float64:
        return std::bit_cast<double>(bits);
      default:
        return static_cast<double>(bits);
    }
  }

  const Input& input_;
  Scanner scan_;
  Format format_;
  std::string_view data_;
  const Element* element_ = nullptr;
  std::int64_t index_ = 0;
};

template <class S>
class PlyReader {
 public:
  explicit PlyReader(const Input& input) : input_(input) {}

  RawMesh<S> mesh() {
    Scanner scan(input_, input_.bytes, {.hash_comments = false});
    const Header header = HeaderReader(input_, scan).read();
    Body body(input_, scan, header.format);
    for (const Element& element : header.elements) {
      expect_room(body, element);
      if (element.name == "vertex") {
        read_vertices(body, element);
      } else if (element.name == "face") {
        read_faces(body, element);
      } else if (!element.properties.empty()) {
        skip(body, element);
      }
    }
    if (!seen_vertices_) input_.fail(0, "E_FILE_EMPTY", "the header has no element vertex");
    if (!seen_faces_)
      input_.fail(0, "E_FILE_EMPTY", "the header has no element face", "triangle strips and point clouds are not read");
    body.expect_end();
    check_indices();
    return std::move(raw_);
  }

 private:
  void expect_room(const Body& body, const Element& element) const;
  void read_vertices(Body& body, const Element& element);
  void read_faces(Body& body, const Element& element);
  void skip(Body& body, const Element& element) const;
  void check_indices() const;

  const Input& input_;
  RawMesh<S> raw_;
  bool seen_vertices_ = false, seen_faces_ = false;
};

/// Before any work: a count that the rest of the file cannot hold is wrong.
template <class S>
void PlyReader<S>::expect_room(const Body& body, const Element& element) const {
  for (const Property& property : element.properties) {
    const std::uint64_t room = body.room_for(property.count.value_or(property.type));
    if (static_cast<std::uint64_t>(element.count) <= room) continue;
    input_.fail(body.line(), "E_FILE_COUNT",
                "the header promises " + std::to_string(element.count) + " of element " + element.name +
                    ", but the rest of the file has room for at most " + std::to_string(room),
                "correct the counts in the header, or the file is cut off");
  }
}

template <class S>
void PlyReader<S>::read_vertices(Body& body, const Element& element) {
  seen_vertices_ = true;
  constexpr std::string_view axes[] = {"x", "y", "z"};
  std::vector<int> axis(element.properties.size(), -1);
  std::vector<std::vector<S>*> column(element.properties.size(), nullptr);
  int found = 0;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const Property& property = element.properties[k];
    if (property.count) continue;
    const auto at = std::ranges::find(axes, property.name) - std::begin(axes);
    if (at < 3) {
      axis[k] = static_cast<int>(at);
      ++found;
    } else {
      column[k] = &raw_.attributes[property.name];
    }
  }
  if (found < 3) input_.fail(0, "E_FILE_SYNTAX", "element vertex needs the scalar properties x, y and z");
  for (std::int64_t v = 0; v < element.count; ++v) {
    body.begin(element, v);
    S place[3];
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      if (axis[k] >= 0) {
        place[axis[k]] = body.template number<S>(element.properties[k]);
      } else if (column[k] != nullptr) {
        column[k]->push_back(body.template number<S>(element.properties[k]));
      } else {
        body.skip(element.properties[k]);
      }
    }
    for (S& coordinate : place) raw_.coordinates.push_back(std::move(coordinate));
  }
}

template <class S>
void PlyReader<S>::read_faces(Body& body, const Element& element) {
  seen_faces_ = true;
  const auto is_corners = [](const Property& p) { return p.count && (p.name == "vertex_indices" || p.name == "vertex_index"); };
  if (std::ranges::count_if(element.properties, is_corners) != 1) {
    input_.fail(0, "E_FILE_SYNTAX", "element face needs one list property vertex_indices (or vertex_index)");
  }
  for (std::int64_t f = 0; f < element.count; ++f) {
    body.begin(element, f);
    for (const Property& property : element.properties) {
      if (!is_corners(property)) {
        body.skip(property);
        continue;
      }
      const std::int64_t size = body.list_size(property);
      if (size < 3)
        body.fail("E_FILE_SYNTAX",
                  "it has " + std::to_string(size) + (size == 1 ? " corner" : " corners") + "; faces need at least three");
      for (std::int64_t k = 0; k < size; ++k) {
        const std::int64_t v = body.integer(property.type, "vertex");
        if (v < 0 || v > 2147483647) body.fail("E_FILE_INDEX", "vertex " + std::to_string(v) + " does not exist");
        raw_.corners.push_back(static_cast<int>(v));
      }
    }
    expect_int_count(input_, raw_.corners.size(), "corners");
    raw_.close_face(body.line());
  }
}

template <class S>
void PlyReader<S>::skip(Body& body, const Element& element) const {
  for (std::int64_t k = 0; k < element.count; ++k) {
    body.begin(element, k);
    for (const Property& property : element.properties) body.skip(property);
  }
}

/// The element face may stand before the element vertex.
template <class S>
void PlyReader<S>::check_indices() const {
  expect_int_count(input_, raw_.coordinates.size() / 3, "vertices");
  for (std::size_t k = 0; k < raw_.corners.size(); ++k) {
    if (raw_.corners[k] < raw_.vertices()) continue;
    const auto f = static_cast<std::size_t>(std::ranges::upper_bound(raw_.begin, static_cast<int>(k)) - raw_.begin.begin() - 1);
    input_.fail(f < raw_.face_lines.size() ? raw_.face_lines[f] : 0, "E_FILE_INDEX",
                "face " + std::to_string(f) + " names vertex " + std::to_string(raw_.corners[k]) + ", but there are " +
                    std::to_string(raw_.vertices()) + " vertices (0 to " + std::to_string(raw_.vertices() - 1) + ")",
                "correct the index; PLY counts from 0");
  }
}

}  // namespace

template <class S>
RawMesh<S> read_ply(const Input& input) {
  return PlyReader<S>(input).mesh();
}

#define UDCP_READ_PLY(S) template RawMesh<S> read_ply<S>(const Input&);
UDCP_FOR_EACH_COORDINATE(UDCP_READ_PLY)
#undef UDCP_READ_PLY

}  // namespace udcp
