// Patch surfaces as values: reports that hold their patches. What the functions on them, saving and claims share.
#pragma once

#include "interpreter/arguments.h"
#include "operators/methods/filling/fill_g2.h"

namespace udcp {

/// A surface with its counts as text and JSON; its picture shows reflection lines.
Value surface_value(PatchSurface surface);
/// The patches behind a value of fill_g2; E_TYPE for anything else.
const PatchSurface& need_surface(const Arguments&, std::size_t position);

/// {"kind": "patches", "patches": [{"degree": [7, 7], "points": [[x, y, z], ..], "face": f, "around": v or null}, ..]}: point
/// number (degree_v + 1) j + k belongs to b_j(u) b_k(v); "face" is that of the refined mesh.
Json patches_json(const PatchSurface& surface);
/// A mesh of n x n quads per patch with limit normals and the attributes "gaussian" and "mean", `colour` being shown.
Value tessellated(const PatchSurface& surface, int n, const std::string& colour, CallContext& context);
/// save: .json holds the patches, every other format a mesh of 8 x 8 quads per patch.
void save_surface(const PatchSurface& surface, const std::filesystem::path& path, const std::string& extension,
                  CallContext& context);

/// So many significant digits.
std::string significant(double value, int digits);

/// Curvature ranges as a table, a line each; parts are [K least, K greatest, H least, H greatest].
struct NamedRange {
  std::string name;
  CurvatureExtrema range;
};
ReportValue range_report(const std::string& title, const std::vector<NamedRange>& ranges);

/// The fill and plain Catmull-Clark around one vertex: ranges by level, and reflection lines side by side.
ReportValue compare_fill(const Surface<double>& mesh, int vertex, int levels, const RunControl& control);
/// Reflection lines of a whole surface.
std::string picture_of_surface(const PatchSurface& surface, int lines, double size);

/// g2(n): the claim that the fill of valence n joins with G2.
Value claim_g2(CallContext&, const Arguments&);

}  // namespace udcp
