// All blocks have the same pattern: one table is shifted to every face, and its border is replaced.
#include "operators/plan/corners.h"

#include "operators/plan/block.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }
std::uint32_t number(int k) { return static_cast<std::uint32_t>(k); }

}  // namespace

template <int N>
ResultNumbers<N>::ResultNumbers(const Mesh& mesh, const std::vector<std::uint8_t>& turn, int segments)
    : mesh_(mesh),
      turn_(turn),
      n_(number(segments)),
      inside_(number(Block<N>{segments}.interior())),
      first_edge_(number(mesh.vertices())),
      first_face_(first_edge_ + number(mesh.edges()) * (n_ - 1)) {
  const Block<N> block{segments};
  const auto add = [&](Place place) {
    const auto border = block.border(place);
    if (border.edge >= 0)
      patches_.push_back({number(static_cast<int>(interior_[0].size())), number(border.edge) * n_ + number(border.step)});
    for (int t = 0; t < N; ++t)
      interior_[at(t)].push_back(border.edge < 0 ? number(block.interior_row(block.turned(place, (N - t) % N))) : 0);
  };
  block.for_each_face([&](auto... places) { (add(places), ...); });
}

template <int N>
void ResultNumbers<N>::write_border(int f, std::uint32_t* border) const {
  for (int h = N * f; h < N * f + N; ++h) {
    *border++ = number(mesh_.vertex[at(h)]);
    const std::uint32_t first = in_edge(h), direction = along(h) ? 1U : ~0U;
    for (std::uint32_t s = 0; s + 1 < n_; ++s) *border++ = first + s * direction;
  }
}

template <int N>
void ResultNumbers<N>::write(int first, int last, std::uint32_t* corners) const {
  std::vector<std::uint32_t> border(N * n_);
  const std::size_t size = interior_[0].size();
  for (int f = first; f < last; ++f) {
    std::uint32_t* out = corners + at(f) * size;
    const std::uint32_t shift = in_face(f);
    const std::uint32_t* interior = interior_[turn_[at(f)]].data();
    for (std::size_t k = 0; k < size; ++k) out[k] = interior[k] + shift;
    write_border(f, border.data());
    for (const Patch& patch : patches_) out[patch.at] = border[patch.border];
  }
}

template class ResultNumbers<3>;
template class ResultNumbers<4>;

}  // namespace udcp
