// Matrix Market text: banner, comments, sizes, entries.
#include "files/matrix_market.h"

#include "files/writer.h"

namespace udcp {
namespace {

/// What a rounded entry stands for; doubles stand for themselves.
template <class S>
std::string note(const S& value) {
  return to_text(value);
}
template <>
std::string note(const double&) {
  return {};
}

void write_comment(Writer& out, const std::string& comment) {
  for (std::size_t from = 0; from < comment.size();) {
    const std::size_t to = std::min(comment.find('\n', from), comment.size());
    out << "% " << std::string_view(comment).substr(from, to - from) << '\n';
    from = to + 1;
  }
}

template <class S>
void write_notes(Writer& out, const Points<S>& matrix) {
  bool first = true;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (is_zero(matrix(i, j))) continue;
      const std::string text = note(matrix(i, j));
      if (text.empty()) continue;
      if (first) out << "% The entries below are rounded to double; what they stand for:\n";
      first = false;
      out << "% (" << i + 1 << ", " << j + 1 << ") = " << text << '\n';
    }
  }
}

template <class S>
double rounded(const Points<S>& matrix, Eigen::Index i, Eigen::Index j) {
  const double value = approximate(matrix(i, j));
  if (std::isfinite(value)) return value;
  throw Error(ErrorKind::input, "E_NOT_FINITE",
              "entry (" + std::to_string(i + 1) + ", " + std::to_string(j + 1) + ") of the matrix is not finite");
}

}  // namespace

template <class S>
std::string matrix_market(const Points<S>& matrix, MatrixLayout layout, const std::string& comment) {
  Writer out(static_cast<std::size_t>(matrix.size()) * 24 + 100);
  out << "%%MatrixMarket matrix " << (layout == MatrixLayout::coordinate ? "coordinate" : "array") << " real general\n";
  write_comment(out, comment);
  write_notes(out, matrix);
  if (layout == MatrixLayout::array) {
    out << matrix.rows() << ' ' << matrix.cols() << '\n';
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      for (Eigen::Index i = 0; i < matrix.rows(); ++i) out << rounded(matrix, i, j) << '\n';
    }
    return out.take();
  }
  Eigen::Index entries = 0;
  for (Eigen::Index k = 0; k < matrix.size(); ++k) entries += is_zero(matrix.data()[k]) ? 0 : 1;
  out << matrix.rows() << ' ' << matrix.cols() << ' ' << entries << '\n';
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (!is_zero(matrix(i, j))) out << i + 1 << ' ' << j + 1 << ' ' << rounded(matrix, i, j) << '\n';
    }
  }
  return out.take();
}

#define UDCP_MATRIX_MARKET(S) template std::string matrix_market(const Points<S>&, MatrixLayout, const std::string&);
UDCP_FOR_EACH_COORDINATE(UDCP_MATRIX_MARKET)
#undef UDCP_MATRIX_MARKET

}  // namespace udcp
