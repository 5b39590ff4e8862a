// set name = value, checked; and the files that animate writes.
#include <limits>

#include "files/geometry_file.h"
#include "interpreter/formula.h"
#include "interpreter/report.h"
#include "interpreter/statements.h"

namespace udcp {

namespace {

std::int64_t whole(const Value& value, const std::string& name, std::int64_t least, std::int64_t most) {
  const auto* number = value.as<NumberValue>();
  const auto* q = number ? std::get_if<Quantity<Algebraic>>(&number->value) : nullptr;
  if (q && q->kind() == Quantity<Algebraic>::Kind::rational && q->exact().is_integer()) {
    const Rational& r = q->exact();
    if (r >= Rational(static_cast<long long>(least)) && r <= Rational(static_cast<long long>(most)))
      return std::stoll(r.to_string());
  }
  throw Error(ErrorKind::word, "E_SETTING",
              name + " must be a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", but it is " +
                  to_text(value));
}

bool yes_or_no(const Value& value, const std::string& name) {
  if (const auto* boolean = value.as<Boolean>()) return boolean->value;
  throw Error(ErrorKind::word, "E_SETTING", name + " must be yes or no, but it is " + to_text(value));
}

}  // namespace

void Runner::on(const grammar::Set& s, grammar::Span) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  Settings& settings = context_.settings;
  const auto value = [&] { return evaluate(*s.value, context_); };
  if (s.name == "precision") {
    settings.precision = static_cast<int>(whole(value(), "precision", 24, 100'000));
    Interval::set_precision(settings.precision);
  } else if (s.name == "seed") {
    settings.seed = static_cast<std::uint64_t>(whole(value(), "seed", 0, most));
  } else if (s.name == "max_faces") {
    settings.max_faces = whole(value(), "max_faces", 1, std::int64_t{1} << 40);
  } else if (s.name == "max_bytes") {
    settings.max_bytes = whole(value(), "max_bytes", 0, most);
  } else if (s.name == "threads") {
    settings.threads = static_cast<int>(whole(value(), "threads", 0, 1024));
  } else if (s.name == "quiet") {
    settings.quiet = yes_or_no(value(), "quiet");
  } else {
    const std::string guess = did_you_mean(s.name, {"precision", "seed", "max_faces", "max_bytes", "threads", "quiet"});
    throw Error(ErrorKind::word, "E_SETTING", "there is no setting '" + s.name + "'",
                guess.empty() ? "the settings are precision, seed, max_faces, max_bytes, threads and quiet" : guess);
  }
}

void Runner::save_frames(const AnimationFrames& frames) {
  if (frames.empty()) warn(context_, {}, "animate saved nothing; end a line inside it with |> save \"file.glb\"");
  for (const auto& [path, surfaces] : frames) save_animation(surfaces, path);
}

}  // namespace udcp
