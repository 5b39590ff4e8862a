// Checkers of certificates on regular and irregular Catmull-Clark surfaces. They refine the mesh by the running word again, walk
// the paths and check signs; they search for nothing.
#include "operators/interrupt.h"
#include "proofs/checkers.h"
#include "proofs/regularity/certificate_json.h"
#include "proofs/regularity/covered_surface.h"
#include "proofs/regularity/global_test.h"
#include "proofs/regularity/half_space.h"
#include "proofs/regularity/ring_certificate.h"
#include "proofs/regularity/singular_points.h"

namespace udcp {
namespace {

/// The paths are prefix-free and cover the patch: in rising order each begins where the one before ends.
void check_cover(const std::vector<std::string>& paths) {
  Rational end(0);
  std::string last;
  for (const std::string& path : paths) {
    Rational begin(0), size(1);
    for (const char digit : path) {
      size /= Rational(4);
      begin += Rational(digit - '0') * size;
    }
    require(begin == end, "the paths of a patch do not cover it, each point once");
    end += size;
  }
  require(end == Rational(1), "the paths of a patch do not cover it");
}

void check_patch(const BicubicNet& net, const Json& leaves, bool planar, StopFlag stop) {
  throw_if_stopped(stop);
  require(leaves.is_array() && !leaves.empty() && leaves.size() <= 1'000'000, "a patch must have a list of parts");
  std::vector<std::string> paths;
  for (const Json& json : leaves) {
    const LeafData leaf = leaf_from(json, planar);
    require(is_witness(leaf.witness, descendant(net, leaf.path), leaf.test, planar),
            "a witness does not prove its part of a patch regular");
    paths.push_back(leaf.path);
  }
  std::sort(paths.begin(), paths.end());  // texts of digits: the order of their intervals, prefixes first
  check_cover(paths);
}

void check_rings(const CoveredSurface& surface, const Json& list, StopFlag stop) {
  require(list.is_array() && list.size() == surface.rings.size(),
          "rings must have " + std::to_string(surface.rings.size()) + " entries");
  for (std::size_t k = 0; k < list.size(); ++k) {
    require_entries(list[k], {"vertex", "level", "rings"}, "rings");
    require(integer_from(list[k]["vertex"], 0, surface.rings[k], "rings.vertex") == surface.rings[k],
            "rings.vertex must be " + std::to_string(surface.rings[k]));
    const int level = integer_from(list[k]["level"], 0, largest_ring_level, "rings.level");
    const Json& records = list[k]["rings"];
    require(records.is_array() && static_cast<int>(records.size()) == level, "rings.rings must have a list per level");
    VertexRings rings = VertexRings::around(surface.mesh.surface(), surface.rings[k]);
    require(rings.has_normal(), "the tangent plane at a vertex may be degenerate");
    require(rings.closes_at(level), "the rings do not close at this level");
    for (int ring = 1; ring <= level; ++ring) {
      const std::vector<BicubicNet> nets = rings.nets(ring);
      const Json& patches = records[static_cast<std::size_t>(ring - 1)];
      require(patches.is_array() && patches.size() == nets.size(),
              "a ring must have " + std::to_string(nets.size()) + " patches");
      for (std::size_t p = 0; p < nets.size(); ++p) check_patch(nets[p], patches[p], surface.mesh.is_planar(), stop);
    }
  }
}

/// T1 on a rectangle of quads: the whole surface is embedded.
void check_embedded(const CoveredSurface& surface, const Json& json) {
  require(surface.steps == 0 && surface.mode == RegularityMode::bspline && is_rectangle(surface.mesh),
          "global is only for full rectangles of quads");
  const RegularityWitness witness = separation_from(json);
  const std::optional<std::vector<Differences>> edges = edge_differences(surface.mesh);
  require(edges && edges->size() == 1, "the mesh has no global frame");
  const Differences& d = edges->front();
  require(is_positive_on(*witness.n, d.u) && is_positive_on(-*witness.n, d.v) && is_positive_on(*witness.m, d.u) &&
              is_positive_on(*witness.m, d.v),
          "global does not separate the edges of the mesh");
}

/// Before the mesh is refined: the certificate is long enough to speak of that many faces. At most the faces at boundary vertices
/// are left out.
void require_records(const Surface<Rational>& mesh, int steps, const Json& data) {
  require(data["patches"].is_array() && data["rings"].is_array(), "patches and rings must be lists");
  const std::int64_t sides = mesh.mesh->half_edges();
  const std::int64_t faces = steps == 0 ? mesh.mesh->faces() : sides * (std::int64_t{1} << (2 * (steps - 1)));
  const auto records = static_cast<std::int64_t>(data["patches"].size() + data["rings"].size() * largest_ring_valence);
  require(faces <= records + (steps == 0 ? faces : sides), "patches and rings are too few for the faces of the mesh");
}

}  // namespace

std::string check_regular_surface(const Json& data, StopFlag stop) {
  require_entries(data, {"mesh", "mode", "steps", "except_uncovered", "patches", "rings", "global"}, "data");
  const Surface<Rational> mesh = surface_from(data["mesh"]);
  const int steps = integer_from(data["steps"], 0, most_regularity_steps, "steps");
  require_records(mesh, steps, data);
  RunControl control;
  control.stop = stop;
  const CoveredSurface surface = cover(mesh, mode_from(data["mode"]), steps, control);
  require(data["except_uncovered"].is_boolean() && data["except_uncovered"].get<bool>() == !surface.uncovered.empty(),
          "except_uncovered must say whether faces are left out");
  require(leaves_out_boundary_only(surface), "faces around a vertex inside are left out");
  require(!surface.patches.empty() || !surface.rings.empty(), "the mesh has no patch");
  const Json& patches = data["patches"];
  require(patches.is_array() && patches.size() == surface.patches.size(),
          "patches must have " + std::to_string(surface.patches.size()) + " entries");
  for (std::size_t k = 0; k < patches.size(); ++k)
    check_patch(surface.mesh.net(surface.patches[k]), patches[k], surface.mesh.is_planar(), stop);
  check_rings(surface, data["rings"], stop);
  const bool embedded = !data["global"].is_null();
  if (embedded) check_embedded(surface, data["global"]);
  return regular_statement(data["mesh"], surface, embedded);
}

std::string check_irregular_surface(const Json& data, StopFlag stop) {
  (void)describe_singularity(data, stop);
  return irregular_statement(data["mesh"], mode_from(data["mode"]));
}

}  // namespace udcp
