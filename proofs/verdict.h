// What a proof answers: proved with a certificate that passed its checker, refuted with a witness, or undecided with the reason.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "proofs/certificate.h"

namespace udcp {

enum class Verdict { proved, refuted, undecided };
std::string to_string(Verdict verdict);

struct Result {
  Verdict verdict = Verdict::undecided;
  std::string claim;              // a sentence: "the scheme with mask [1, 3, 3, 1]/4 is C^1"
  std::string reason;             // one sentence: by what it was proved or refuted, or what would decide it
  Json details = Json::object();  // numbers for people: bounds, lengths, per valence values; enclosures as {"lo", "hi"} texts
  Json witness = nullptr;         // refuted: data that a reader can check; undecided: where the search stopped, if that helps
  bool evidence = false;          // floating-point numbers speak for (proved) or against (refuted) the claim; nothing is proved
  std::optional<Json> certificate{};  // proved and, where the refutation has one, refuted
};

/// Bounds of a search. Reaching one gives `undecided`, never a longer wait.
struct SearchLimits {
  double seconds = 60;
  int nodes = 200'000;                      // boxes, products, vectors, cells
  const std::atomic<bool>* stop = nullptr;  // set: Error{interrupted}
};

/// The outcome of a checker that did not search.
struct Verification {
  bool accepted = false;
  std::string statement;  // derived from the data; only if accepted
  std::string reason;     // why not; empty if accepted
};
/// Re-checks a certificate of any kind in exact or outward-rounded arithmetic. Never throws for bad certificates;
/// Error{interrupted} once `stop` is set.
[[nodiscard]] Verification verify(const Json& certificate, const std::atomic<bool>* stop = nullptr);

/// `proved` (or `refuted`, for kinds that refute), if verify accepts the certificate; `undecided` with its complaint otherwise.
/// Error{interrupted} once `stop` is set.
[[nodiscard]] Result concluded(Verdict verdict, std::string reason, Json certificate, const std::atomic<bool>* stop = nullptr);
[[nodiscard]] Result undecided(std::string claim, std::string reason);
/// The claim that all of them hold: proved if all are, with the certificate "all-of" of their parts; refuted by the first that
/// is; otherwise undecided by the first that is. One result is itself; none is E_DOMAIN.
[[nodiscard]] Result all_of(std::vector<Result> results);

}  // namespace udcp
