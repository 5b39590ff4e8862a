// Panels of a fixed size in pixels: meshes, pencils of unit vectors, maps of the sphere.
#include "interpreter/regularity_pictures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>

#include "interpreter/picture_scene.h"
#include "interpreter/sphere_map.h"

namespace udcp {
namespace {

constexpr const char* colour_u = "#1f4e79";
constexpr const char* colour_v = "#b5482a";
constexpr const char* dark = "#303030";
constexpr const char* pale = "#c4c4c4";
constexpr const char* good = "#2e6b33";
constexpr const char* bad = "#a02020";
constexpr const char* minus_v = "\u2212v";

/// With the minus sign of typographers, for pictures.
std::string typeset(std::string text) {
  for (auto at = text.find("-v"); at != std::string::npos; at = text.find("-v", at)) text.replace(at, 2, minus_v);
  return text;
}

// ---- the mesh

/// Right, up and towards the eye.
using Axes = std::array<Direction, 3>;

/// From above if the mesh is planar; else from the front, or from where the marked faces are seen from outside.
Axes axes_of(const ConeLevel& level) {
  if (level.mesh.is_planar()) return {Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{0, 0, 1}};
  Direction outside{};
  const Mesh& mesh = level.mesh.mesh();
  for (int f = 0; f < mesh.faces(); ++f) {
    if (level.marked[Mesh::i(f)] == 0) continue;
    const auto corners = mesh.corners(f);
    const Vector3 normal = cross(level.mesh.point(corners[2]) - level.mesh.point(corners[0]),
                                 level.mesh.point(corners[3]) - level.mesh.point(corners[1]));
    if (is_zero(normal)) continue;
    for (std::size_t c = 0; c < 3; ++c) outside[c] += direction_of(normal)[c];
  }
  Axes best{};
  for (int k = 0; k < 8; ++k) {
    const double turn = (k / 2) * std::numbers::pi / 2 - 1.012, height = k % 2 == 0 ? 0.43 : -0.43, flat = 0.903;
    const Direction towards{flat * std::cos(turn), flat * std::sin(turn), height}, right{-std::sin(turn), std::cos(turn), 0};
    if (k == 0 || dot(towards, outside) > dot(best[2], outside) + 0.2) best = {right, cross(towards, right), towards};
  }
  return best;
}

/// Vertices in a box, and how far they are towards the eye.
struct View {
  std::vector<Pixel> place;
  std::vector<double> depth;
};
View view_of(const ConeLevel& level, const Box& box) {
  const Points<Rational>& points = level.mesh.surface().points;
  const auto [right, up, towards] = axes_of(level);
  View view;
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    Direction p{};
    for (Eigen::Index c = 0; c < points.cols(); ++c) p[static_cast<std::size_t>(c)] = points(v, c).to_double();
    const Pixel here{dot(p, right), -dot(p, up)};
    view.place.push_back(here);
    view.depth.push_back(dot(p, towards));
    low_x = std::min(low_x, here.x), high_x = std::max(high_x, here.x);
    low_y = std::min(low_y, here.y), high_y = std::max(high_y, here.y);
  }
  const double scale = std::min(box.width / std::max(high_x - low_x, 1e-300), box.height / std::max(high_y - low_y, 1e-300));
  for (Pixel& p : view.place) {
    p.x = box.centre().x + (p.x - (low_x + high_x) / 2) * scale;
    p.y = box.centre().y + (p.y - (low_y + high_y) / 2) * scale;
  }
  return view;
}

std::vector<Pixel> face_places(const Mesh& mesh, const View& view, int face) {
  std::vector<Pixel> places;
  for (const int v : mesh.corners(face)) places.push_back(view.place[Mesh::i(v)]);
  return places;
}

constexpr std::array<const char*, 3> family_colour = {pale, colour_u, colour_v};

void draw_plane(Scene& scene, const ConeLevel& level, const View& view, RegularityMode mode, double width) {
  const Mesh& mesh = level.mesh.mesh();
  for (int f = 0; f < mesh.faces(); ++f) {
    const bool marked = level.marked[Mesh::i(f)] != 0;
    if (marked || level.mesh.kind_of(f, mode) != FaceKind::patch)
      scene.polygon(face_places(mesh, view, f), marked ? "#ffe9a8" : "#ececec");
  }
  for (std::size_t family = 0; family < 3; ++family) {
    std::vector<Pixel> places;
    for (int e = 0; e < mesh.edges(); ++e) {
      if (static_cast<std::size_t>(level.family[Mesh::i(e)]) != family) continue;
      const int h = mesh.edge_half[Mesh::i(e)];
      places.push_back(view.place[Mesh::i(mesh.vertex[Mesh::i(h)])]);
      places.push_back(view.place[Mesh::i(mesh.tip(h))]);
    }
    const bool stressed = family > 0 && std::count(level.family.begin(), level.family.end(), 0) > 0;
    if (!places.empty()) scene.segments(places, family_colour[family], stressed ? 1.6 * width : width);
  }
}

/// Far faces first, each with its edges, so that near ones hide them; all edges alike where there are too many to tell apart.
void draw_space(Scene& scene, const ConeLevel& level, const View& view, double width) {
  constexpr int legible = 700;
  const Mesh& mesh = level.mesh.mesh();
  std::vector<std::pair<double, int>> order;
  for (int f = 0; f < mesh.faces(); ++f) {
    double depth = 0;
    for (const int v : mesh.corners(f)) depth += view.depth[Mesh::i(v)];
    order.emplace_back(depth, f);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, f] : order) {
    const std::vector<Pixel> places = face_places(mesh, view, f);
    SvgLayer& face = scene.polygon(places, level.marked[Mesh::i(f)] != 0 ? "#ffe9a8" : "#f4f6f8");
    if (mesh.faces() > legible) {
      face.stroke = colour_u;
      face.width = width;
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const auto e = Mesh::i(mesh.edge[Mesh::i(mesh.face_begin[Mesh::i(f)]) + k]);
      scene.line({places[k], places[(k + 1) % 4]}, family_colour[static_cast<std::size_t>(level.family[e])], width);
    }
  }
}

void draw_mesh(Scene& scene, const ConeLevel& level, RegularityMode mode, const Box& box) {
  const View view = view_of(level, box);
  const double width = std::clamp(12 / std::sqrt(static_cast<double>(level.mesh.mesh().faces())), 0.5, 1.2);
  if (level.mesh.is_planar())
    draw_plane(scene, level, view, mode, width);
  else
    draw_space(scene, level, view, width);
}

// ---- directions in the plane

Pixel on_circle(Pixel centre, double radius, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
}

std::vector<Pixel> wedge(Pixel centre, double radius, double from, double width) {
  std::vector<Pixel> places;
  if (width < 359.9) places.push_back(centre);
  const int steps = std::max(2, static_cast<int>(width / 3));
  for (int k = 0; k <= steps; ++k) places.push_back(on_circle(centre, radius, from + width * k / steps));
  return places;
}

/// Rays some degrees apart; the extreme ones are the sides of the wedge and always there.
std::vector<Pixel> rays(const Sector& sector, Pixel centre, double radius, double turn, double apart) {
  std::set<long> bins;
  std::vector<Pixel> places;
  for (const Vector3& w : sector.directions) {
    const Direction d = direction_of(w);
    const double angle = std::atan2(d[1], d[0]) * 180 / std::numbers::pi + turn;
    if (!bins.insert(std::lround(angle / apart)).second) continue;
    places.push_back(centre);
    places.push_back(on_circle(centre, radius, angle));
  }
  return places;
}

/// Directions without a gap of 180 degrees have the whole plane as their cone.
bool is_whole_plane(const Sector& sector) { return sector.width > 180 + 1e-9; }

void draw_sector(Scene& scene, const Sector& sector, Pixel centre, double radius, const FamilyStyle& style) {
  if (sector.directions.empty()) return;
  const double turn = style.dashed ? 180 : 0, width = is_whole_plane(sector) ? 360 : sector.width;
  const std::vector<Pixel> outline = wedge(centre, radius, sector.from + turn, width);
  const bool is_line = !sector.ends && sector.directions.size() == 2 && !is_whole_plane(sector);
  if (!is_line) scene.polygon(outline, style.colour, style.dashed ? 0.1 : 0.18);
  SvgLayer& fan = scene.segments(rays(sector, centre, radius, turn, style.dashed ? 3 : 1.5), style.colour, 0.6);
  fan.opacity = style.dashed ? 0.55 : 0.75;
  if (style.dashed) fan.dash = "4 4";
  if (is_line) return;
  SvgLayer& rim = scene.line(outline, style.colour, 1);
  rim.closed = true;
  if (style.dashed) rim.dash = "5 3";
  if (is_whole_plane(sector)) return;
  const Pixel place = on_circle(centre, radius + 12, sector.from + sector.width / 2 + turn);
  scene.text({place.x, place.y + 4}, style.name, style.colour, "middle", 13);
}

constexpr FamilyStyle style_u{"u", colour_u, false}, style_v{"v", colour_v, false}, style_minus_v{minus_v, colour_v, true};

void draw_pencil(Scene& scene, const ConeLevel& level, const Box& box) {
  const double radius = std::min(box.width, box.height) / 2 - 24;
  scene.circle(box.centre(), radius, pale);
  draw_sector(scene, level.v, box.centre(), radius, style_minus_v);
  draw_sector(scene, level.v, box.centre(), radius, style_v);
  draw_sector(scene, level.u, box.centre(), radius, style_u);
}

// ---- directions in space

std::vector<Direction> unit_directions(const Sector& sector, double sign) {
  std::vector<Direction> result;
  for (const Vector3& w : sector.directions) {
    result.push_back(direction_of(w));
    for (double& x : result.back()) x *= sign;
  }
  return result;
}

/// u with v, or with -v, from the middle of both if they have one.
void draw_map(Scene& scene, const ConeLevel& level, const Box& box, const FamilyStyle& style) {
  const std::vector<Direction> u = unit_directions(level.u, 1), v = unit_directions(level.v, style.dashed ? -1 : 1);
  std::vector<Direction> both = u;
  both.insert(both.end(), v.begin(), v.end());
  Direction centre{0, 0, 1};
  if (const auto cone = smallest_round_cone(both)) {
    centre = cone->centre;
  } else if (const auto of_u = smallest_round_cone(u)) {
    centre = of_u->centre;
  }
  const double radius = std::min(box.width, box.height) / 2 - 12;
  scene.circle(box.centre(), radius, pale);
  const SphereMap map(centre, box.centre(), radius);
  draw_family(scene, map, v, style);
  draw_family(scene, map, u, style_u);
  const bool exact = style.dashed ? level.test.n.has_value() : level.test.m.has_value();
  scene.text({box.centre().x, box.y + box.height + 6},
             std::string("u and ") + style.name + (exact ? ": in one half space" : ": in no half space"), exact ? good : bad,
             "middle");
}

// ---- rows and legend

/// Lines of up to so many bytes, broken after commas and semicolons.
std::vector<std::string> broken(const std::string& text, std::size_t most) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t mark = text.find_first_of(",;", begin), end = mark == std::string::npos ? text.size() : mark + 1;
    if (!lines.back().empty() && lines.back().size() + end - begin > most) {
      lines.emplace_back();
      begin += text[begin] == ' ' ? 1 : 0;
    }
    lines.back() += text.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

void draw_lines(Scene& scene, const std::vector<std::string>& lines, Pixel place, const std::string& colour,
                const std::string& anchor, double size) {
  for (const std::string& line : lines) {
    scene.text(place, typeset(line), colour, anchor, size);
    place.y += 16;
  }
}

std::string relation_of(const ConeTest& t) {
  if (t.separated()) return "both cones are pointed, v and -v apart from u";
  std::string why;
  const auto add = [&](const std::string& reason) { why += (why.empty() ? "" : ", ") + reason; };
  if (t.has_zero) add("a difference is zero");
  if (!t.pointed_u) add("the cone of u is not pointed");
  if (!t.pointed_v) add("the cone of v is not pointed");
  if (t.apart == false) add("the cones of u and v meet");
  if (t.apart_from_opposite == false) add("the cones of u and -v meet");
  return why;
}

std::string subject_text(const ConeStudy& study, const ConeLevel& level) {
  if (study.subject == ConeStudy::Subject::face)
    return "face " + std::to_string(study.face) +
           (level.parts == 1 ? std::string() : ", " + std::to_string(level.parts) + " parts together");
  if (study.subject == ConeStudy::Subject::worst_patch)
    return "no global frame" + (level.parts == 0 ? std::string() : ": the worst patch, face " + std::to_string(level.shown));
  return level.parts == 1 ? "all edges" : "all edges of component " + std::to_string(level.shown);
}

std::array<std::string, 2> measures(const ConeLevel& level) {
  std::array<std::string, 2> lines;
  const auto add = [](std::string& line, const std::string& what) { line += (line.empty() ? "" : ", ") + what; };
  if (level.test.pointed_u) add(lines[0], "u spans " + degrees_text(level.u.width));
  if (level.test.pointed_v) add(lines[0], "v spans " + degrees_text(level.v.width));
  if (level.gap) add(lines[1], gap_text("v", *level.gap));
  if (level.gap_to_opposite) add(lines[1], gap_text("-v", *level.gap_to_opposite));
  return lines;
}

/// Beside the mesh, from x on.
void draw_directions(Scene& scene, const ConeLevel& level, double x, double top, double panel) {
  const auto lines = measures(level);
  if (level.mesh.is_planar()) {
    draw_pencil(scene, level, {x, top + 16, panel, panel});
    scene.text({x + panel / 2, top + panel + 28}, lines[0], dark, "middle");
    draw_lines(scene, broken(lines[1], 45), {x + panel / 2, top + panel + 44}, dark, "middle", 12);
  } else {
    draw_map(scene, level, {x, top + 16, panel, panel}, style_v);
    draw_map(scene, level, {x + panel, top + 16, panel, panel}, style_minus_v);
    const std::string line = lines[0] + (lines[1].empty() ? "" : "; ") + lines[1];
    scene.text({x + 2 * panel - 10, top + panel + 44}, typeset(line), dark, "end");
  }
}

void draw_row(Scene& scene, const ConeStudy& study, std::size_t number, double top, double width) {
  const ConeLevel& level = study.levels[number];
  const double panel = 250, rest = width - 40 - (level.mesh.is_planar() ? panel : 2 * panel);
  const std::string when =
      number == 0 ? "control mesh, " : "after " + std::to_string(number) + (number == 1 ? " step, " : " steps, ");
  scene.text({20, top + 12}, when + std::to_string(level.mesh.mesh().faces()) + " faces; " + subject_text(study, level), dark,
             "start", 13);
  draw_mesh(scene, level, study.mode, {20, top + 28, rest - 20, panel - 16});
  if (level.parts > 0) draw_directions(scene, level, 20 + rest, top, panel);
  draw_lines(scene, broken(verdict_of(level, study.subject), level.mesh.is_planar() ? 70 : 56), {20, top + panel + 44},
             level.holds() ? good : bad, "start", 13);
}

void draw_legend(Scene& scene, bool planar, bool excluded, double y) {
  double x = 20;
  const auto entry = [&](const char* colour, const std::string& name, bool dashed) {
    SvgLayer& sample = scene.line({{x, y - 4}, {x + 26, y - 4}}, colour, 1.6);
    if (dashed) sample.dash = "5 3";
    scene.text({x + 32, y}, name, dark);
    x += 46 + 6.6 * static_cast<double>(name.size());
  };
  entry(colour_u, "differences in u", false);
  entry(colour_v, "differences in v", false);
  if (planar) {
    entry(colour_v, minus_v, true);
  } else {
    scene.dots({{x, y - 4}}, colour_v, 2.2).opacity = 0.25;
    scene.text({x + 8, y}, "pale: on the far side", dark);
  }
  if (!excluded) return;
  scene.polygon({{x, y - 10}, {x + 16, y - 10}, {x + 16, y}, {x, y}}, "#e4e4e4");
  scene.text({x + 22, y}, "no regular patch", dark);
}

}  // namespace

std::string gap_text(const std::string& name, double gap) {
  if (gap < 0) return "u and " + name + " overlap by " + degrees_text(-gap);
  return "gap u to " + name + " " + degrees_text(gap);
}

std::string degrees_text(double degrees) {
  char digits[64];
  const double rounded = std::round(degrees * 10) / 10;
  const auto end = std::to_chars(digits, digits + sizeof digits, rounded == 0 ? 0.0 : rounded, std::chars_format::fixed, 1).ptr;
  return std::string(digits, end) + "\u00b0";
}

std::string verdict_of(const ConeLevel& level, ConeStudy::Subject subject) {
  if (level.parts == 0) return "no regular patch at this level";
  const std::string about_cones = relation_of(level.test);
  if (subject == ConeStudy::Subject::face && level.parts > 1) {
    // Cones of parts in different places may meet when they are joined, which says nothing against any part.
    const std::string verdict = level.holds() ? "T2 holds on all " + std::to_string(level.parts) + " parts"
                                              : "T2 fails on " + std::to_string(level.parts - level.passed) + " of " +
                                                    std::to_string(level.parts) + " parts";
    return verdict + "; together: " + about_cones;
  }
  return std::string(subject == ConeStudy::Subject::mesh ? "T1" : "T2") + (level.holds() ? " holds: " : " fails: ") + about_cones;
}

std::string picture_of_cones(const ConeStudy& study) {
  const bool planar = study.levels[0].mesh.is_planar();
  const double width = planar ? 760 : 900, row = 320;
  std::vector<std::size_t> shown{0};
  if (study.levels.size() > 1) shown.push_back(study.levels.size() - 1);
  const bool excluded = planar && std::any_of(study.levels.begin(), study.levels.end(),
                                              [](const ConeLevel& level) { return level.patches < level.mesh.mesh().faces(); });
  Scene scene(width, 40 + row * static_cast<double>(shown.size()));
  draw_legend(scene, planar, excluded, 24);
  for (std::size_t k = 0; k < shown.size(); ++k) draw_row(scene, study, shown[k], 40 + row * static_cast<double>(k), width);
  return scene.draw("Directions of the differences in u and v");
}

}  // namespace udcp
