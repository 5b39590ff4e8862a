// Difference vectors of Catmull-Clark surfaces, their cones, and the stretch of the parameters: data and pictures behind the
// claim regular(mesh).
#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "interpreter/jacobian.h"
#include "interpreter/regularity_pictures.h"
#include "interpreter/report.h"
#include "proofs/regularity/adaptive.h"
#include "proofs/regularity/covered_surface.h"

namespace udcp {
namespace {

RegularityMode mode_of(const Arguments& a, std::size_t position) {
  return choice_or(a, position, "mode", {"bspline", "interior"}) == "bspline" ? RegularityMode::bspline
                                                                              : RegularityMode::interior;
}

Surface<Rational> exact_mesh(const Arguments& a) { return with_one_face_corners(as_rational(need_mesh(a, 0))); }

Json json_of(const Vector3& w, std::size_t columns) {
  Json row = Json::array();
  for (std::size_t c = 0; c < columns; ++c) row.push_back(w[c].to_string());
  return row;
}

std::string text_of(const Vector3& w, std::size_t columns) {
  std::string text;
  for (std::size_t c = 0; c < columns; ++c) text += (c == 0 ? "(" : ", ") + w[c].to_string();
  return text + ")";
}

Value value_of(const Vector3& w, std::size_t columns) {
  ListValue list;
  for (std::size_t c = 0; c < columns; ++c) list.items.push_back(number_of(Algebraic(w[c])));
  return Value{std::move(list)};
}

// ---- differences(mesh, face)

/// Vectors of a patch in the coordinates of the mesh, as a report.
class PatchReport {
 public:
  PatchReport(const QuadMesh& mesh, int face, RegularityMode mode) : mesh_(mesh), columns_(mesh.is_planar() ? 2 : 3) {
    shrink_ = Rational(1) / mesh.scale();
    net_ = mesh.net(face);
    report_.json = Json{{"kind", "differences"}, {"face", face}, {"mode", to_string(mode)}, {"planar", mesh.is_planar()}};
    report_.text = "face " + std::to_string(face) + " of " + std::to_string(mesh.mesh().faces()) + ", " +
                   (mesh.is_planar() ? "planar" : "in space");
    add_flags();
    add_net();
    const Differences d = differences(net_);
    add_vectors("u", d.u);
    add_vectors("v", d.v);
    add_corners();
    add_tests();
  }
  ReportValue take() { return std::move(report_); }

 private:
  void add_flags() {
    static constexpr std::array names = {"bottom", "right", "top", "left"};
    std::string sides;
    report_.json["boundary_sides"] = Json::array();
    for (std::size_t k = 0; k < 4; ++k) {
      if (!net_.flagged[k]) continue;
      sides += (sides.empty() ? "" : ", ") + std::string(names[k]);
      report_.json["boundary_sides"].push_back(names[k]);
    }
    if (!sides.empty()) report_.text += "; on the boundary: " + sides + " (points outside are reflected)";
  }
  void add_net() {
    ListValue rows;
    report_.json["net"] = Json::array();
    report_.text += "\nnet, rows from v = 0 up:";
    for (int i = 0; i < 4; ++i) {
      ListValue row;
      Json json = Json::array();
      report_.text += "\n ";
      for (int j = 0; j < 4; ++j) {
        const Vector3 p = shrink_ * net_.at(i, j);
        row.items.push_back(value_of(p, columns_));
        json.push_back(json_of(p, columns_));
        report_.text += " " + text_of(p, columns_);
      }
      rows.items.push_back(Value{std::move(row)});
      report_.json["net"].push_back(std::move(json));
    }
    report_.parts.push_back(Value{std::move(rows)});
  }
  void add_vectors(const std::string& name, const std::vector<Vector3>& vectors) {
    ListValue list;
    Json json = Json::array();
    report_.text += "\n" + name + "-differences:";
    for (const Vector3& w : vectors) {
      const Vector3 d = shrink_ * w;
      list.items.push_back(value_of(d, columns_));
      json.push_back(json_of(d, columns_));
      report_.text += " " + text_of(d, columns_);
    }
    report_.parts.push_back(Value{std::move(list)});
    report_.json[name] = std::move(json);
  }
  void add_corners() {
    report_.json["corners"] = Json::array();
    for (int number = 0; number < 4; ++number) {
      const int r = number / 2, c = number % 2;
      const CornerValues values = corner(net_, r, c);
      const Vector3 s = shrink_ / Rational(36) * values.point, du = shrink_ / Rational(12) * values.du,
                    dv = shrink_ / Rational(12) * values.dv, normal = cross(du, dv);
      report_.text += "\nu = " + std::to_string(c) + ", v = " + std::to_string(r) + ": S = " + text_of(s, columns_) +
                      ", S_u = " + text_of(du, columns_) + ", S_v = " + text_of(dv, columns_) +
                      ", S_u x S_v = " + (mesh_.is_planar() ? normal[2].to_string() : text_of(normal, 3));
      report_.json["corners"].push_back({{"u", c},
                                         {"v", r},
                                         {"S", json_of(s, columns_)},
                                         {"Su", json_of(du, columns_)},
                                         {"Sv", json_of(dv, columns_)},
                                         {"cross", mesh_.is_planar() ? Json(normal[2].to_string()) : json_of(normal, 3)}});
    }
  }
  void add_tests() {
    report_.json["tests"] = Json::object();
    for (const RegularityTest test : {RegularityTest::t2, RegularityTest::t3, RegularityTest::t4}) {
      const std::optional<RegularityWitness> witness = find_witness(net_, test, mesh_.is_planar());
      const std::string name = to_string(test);
      Json json{{"holds", witness.has_value()}};
      report_.text += "\n" + name + (witness ? " holds" : " fails");
      if (witness && mesh_.is_planar()) {
        report_.text += witness->sign > 0 ? ": all determinants are positive" : ": all determinants are negative";
        json["sign"] = witness->sign;
      }
      if (witness && witness->n) {
        report_.text += ": n = " + text_of(*witness->n, 3);
        json["n"] = json_of(*witness->n, 3);
      }
      if (witness && witness->m) {
        report_.text += ", m = " + text_of(*witness->m, 3);
        json["m"] = json_of(*witness->m, 3);
      }
      report_.json["tests"][name] = std::move(json);
    }
  }

  const QuadMesh& mesh_;
  std::size_t columns_;
  Rational shrink_;
  BicubicNet net_;
  ReportValue report_;
};

Value show_differences(CallContext& context, const Arguments& a) {
  const RegularityMode mode = mode_of(a, 2);
  const Surface<Rational> surface = exact_mesh(a);
  const QuadMesh mesh(surface);
  const int face = need_whole(a, 1, "face", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  require_face(mesh.mesh(), face);
  if (mesh.kind_of(face, mode) != FaceKind::patch)
    throw Error(ErrorKind::input, "E_NO_PATCH", why_no_patch(mesh, face, mode), "differences are those of a regular patch");
  ReportValue report = PatchReport(mesh, face, mode).take();
  const ConeOptions options{mode, 0, face, run_control(context, "cones")};
  report.picture = [surface, options] { return picture_of_cones(study_cones(surface, options)); };
  return Value{std::move(report)};
}

// ---- cones(mesh)

Json sector_json(const Sector& sector, bool pointed, bool planar) {
  Json json{{"directions", sector.directions.size()}, {"pointed", pointed}};
  if (sector.directions.empty()) return json;
  if (planar) {
    json["from_degrees"] = sector.from;
    json[pointed ? "width_degrees" : "covered_degrees"] = sector.width;
  } else if (pointed) {
    json["width_degrees"] = sector.width;
  }
  if (sector.ends) json["ends"] = Json::array({json_of((*sector.ends)[0], 2), json_of((*sector.ends)[1], 2)});
  return json;
}

/// `of_parts`: of a face. Then "holds" is about each part, and the cones are those of all parts together.
Json level_json(const ConeLevel& level, int number, bool of_parts) {
  const bool planar = level.mesh.is_planar();
  const auto optional = [](const auto& x) { return x ? Json(*x) : Json(nullptr); };
  Json json{{"level", number},
            {"faces", level.mesh.mesh().faces()},
            {"patches", level.patches},
            {"excluded", level.excluded},
            {"tested", level.parts},
            {"passed", level.passed},
            {"holds", level.holds()},
            {"shown", level.shown},
            {"together", of_parts && level.parts > 1},
            {"separated", level.test.separated()},
            {"zero_difference", level.test.has_zero},
            {"u_apart_from_v", optional(level.test.apart)},
            {"u_apart_from_minus_v", optional(level.test.apart_from_opposite)},
            {"u", sector_json(level.u, level.test.pointed_u, planar)},
            {"v", sector_json(level.v, level.test.pointed_v, planar)},
            {"gap_degrees", optional(level.gap)},
            {"gap_to_minus_v_degrees", optional(level.gap_to_opposite)}};
  if (level.test.n) json["n"] = json_of(*level.test.n, 3);
  if (level.test.m) json["m"] = json_of(*level.test.m, 3);
  return json;
}

std::string sector_text(const char* name, const Sector& sector, bool pointed, bool planar) {
  if (sector.directions.empty()) return std::string("no ") + name;
  if (!pointed && !planar) return std::string(name) + " not pointed";
  if (!pointed)
    return std::string(name) + " not pointed (no gap above " + degrees_text(360 - sector.width) + " between its directions)";
  std::string text = std::string(name) + " spans " + degrees_text(sector.width);
  if (planar) text += " from " + degrees_text(sector.from);
  return text;
}

std::string level_text(const ConeLevel& level, const ConeStudy& study, int number) {
  const bool planar = level.mesh.is_planar();
  std::string text = "level " + std::to_string(number) + ", " + std::to_string(level.mesh.mesh().faces()) + " faces";
  if (level.parts == 0) return text + ": " + verdict_of(level, study.subject);
  if (study.subject == ConeStudy::Subject::mesh) {
    if (level.parts > 1)
      text += ", T1 on " + std::to_string(level.passed) + " of " + std::to_string(level.parts) + " components; component " +
              std::to_string(level.shown);
  } else {
    const bool of_face = study.subject == ConeStudy::Subject::face;
    text += ", T2 on " + std::to_string(level.passed) + " of " + std::to_string(level.parts) +
            (of_face ? " parts of face " : " patches; worst: face ") + std::to_string(level.shown);
    if (of_face && level.parts > 1) text += "; together";
  }
  text += ": " + sector_text("u", level.u, level.test.pointed_u, planar) + ", " +
          sector_text("v", level.v, level.test.pointed_v, planar);
  if (level.gap) text += ", " + gap_text("v", *level.gap);
  if (level.gap_to_opposite) text += ", " + gap_text("-v", *level.gap_to_opposite);
  return text + "\n  " + verdict_of(level, study.subject);
}

Value show_cones(CallContext& context, const Arguments& a) {
  ConeOptions options{mode_of(a, 1), whole_or(a, 2, "steps", 2, 0, 8), std::nullopt, run_control(context, "cones")};
  if (a.get(3, "face")) options.face = need_whole(a, 3, "face", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  const auto study = std::make_shared<const ConeStudy>(study_cones(exact_mesh(a), options));
  static constexpr std::array subjects = {"mesh", "worst patch", "face"};
  ReportValue report;
  report.json = Json{{"kind", "cones"},
                     {"mode", to_string(study->mode)},
                     {"planar", study->levels[0].mesh.is_planar()},
                     {"refined", study->is_refined},
                     {"of", subjects[static_cast<std::size_t>(study->subject)]},
                     {"levels", Json::array()}};
  if (study->subject == ConeStudy::Subject::worst_patch)
    report.text =
        "no global frame: around extraordinary vertices u and v cannot be told apart, so this is about single patches\n";
  if (!study->is_refined) report.text += "mode interior has no boundary rule, so the open mesh is not refined: level 0 only\n";
  for (std::size_t k = 0; k < study->levels.size(); ++k) {
    const ConeLevel& level = study->levels[k];
    report.text += level_text(level, *study, static_cast<int>(k)) + "\n";
    report.json["levels"].push_back(level_json(level, static_cast<int>(k), study->subject == ConeStudy::Subject::face));
    report.parts.push_back(Value{Boolean{level.holds()}});
  }
  report.text += "(what holds or fails is exact; degrees are rounded. It speaks of regular patches: " +
                 std::to_string(study->levels[0].patches) + " of " + std::to_string(study->levels[0].mesh.mesh().faces()) +
                 " faces of the control mesh)";
  report.picture = [study] { return picture_of_cones(*study); };
  return Value{std::move(report)};
}

Value show_jacobian(CallContext& context, const Arguments& a) {
  const int steps = whole_or(a, 1, "steps", 3, 0, 12);
  JacobianSurface made = jacobian_surface(as_double(need_mesh(a, 0)), steps, run_control(context, "jacobian"));
  MeshValue result{std::move(made.surface), "limit of catmull_clark",
                   std::make_shared<const Points<double>>(std::move(made.normals))};
  result.colour = "jacobian";
  result.zero_matters = true;
  return Value{std::move(result)};
}

}  // namespace

std::vector<Builtin> builtins_regularity() {
  return {
      {"differences",
       "differences(mesh, face, mode = bspline)",
       "Net, difference vectors and corner derivatives of a regular patch, and which of T2 to T4 hold; exact.",
       2,
       3,
       {"face", "mode"},
       show_differences},
      {"cones",
       "cones(mesh, mode = bspline, steps = 2, face = ...)",
       "The sectors of the u- and v-differences before and after Catmull-Clark steps, which mode interior has for closed meshes "
       "only; plot draws them.",
       1,
       4,
       {"mode", "steps", "face"},
       show_cones},
      {"jacobian",
       "jacobian(mesh, steps = 3)",
       "The Catmull-Clark limit mesh coloured by |S_u x S_v|, signed in the plane; extraordinary vertices have the average of "
       "their neighbours; floating point.",
       1,
       2,
       {"steps"},
       show_jacobian},
  };
}

}  // namespace udcp
