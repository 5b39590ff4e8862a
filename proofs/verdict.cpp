// Results of proofs, and verify(), which sends a certificate to the checker of its kind.
#include "proofs/verdict.h"

#include <array>
#include <exception>

#include "proofs/checkers.h"

namespace udcp {

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::proved:
      return "proved";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Verification verify(const Json& certificate, const std::atomic<bool>* stop) {
  try {
    check_envelope(certificate);
    const auto kind = certificate["kind"].get<std::string>();
    for (const Checker& checker : checkers()) {
      if (checker.kind != kind) continue;
      const std::string statement = checker.check(certificate["data"], stop);
      require(statement == certificate["statement"], "the data prove another statement: " + statement);
      return {true, statement, ""};
    }
    return {false, "", "this program knows no certificates of the kind \"" + kind.substr(0, 60) + "\""};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const Error& error) {
    if (error.kind == ErrorKind::interrupted) throw;
    return {false, "", error.what()};
  } catch (const std::exception& error) {
    return {false, "", error.what()};
  }
}

Result concluded(Verdict verdict, std::string reason, Json certificate, const std::atomic<bool>* stop) {
  Result result;
  result.claim = certificate["statement"].get<std::string>();
  const Verification check = verify(certificate, stop);
  if (!check.accepted) {
    result.reason = "the certificate did not pass its checker: " + check.reason;
    return result;
  }
  result.verdict = verdict;
  result.reason = std::move(reason);
  result.certificate = std::move(certificate);
  return result;
}

Result undecided(std::string claim, std::string reason) {
  Result result;
  result.claim = std::move(claim);
  result.reason = std::move(reason);
  return result;
}

namespace {

/// "A; B; C", the middle left away when there are many.
std::string joined(const std::vector<Result>& results, std::string Result::*text) {
  std::string all;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const bool left_away = results.size() > 4 && k > 0 && k + 1 < results.size();
    if (left_away && k > 1) continue;
    all += (k == 0 ? "" : "; ") + (left_away ? "..." : results[k].*text);
  }
  return all;
}

}  // namespace

Result all_of(std::vector<Result> results) {
  if (results.empty()) throw Error(ErrorKind::word, "E_DOMAIN", "the domain of the claim is empty");
  if (results.size() == 1) return std::move(results.front());
  for (const Verdict verdict : {Verdict::refuted, Verdict::undecided}) {
    for (Result& result : results) {
      if (result.verdict == verdict) return std::move(result);
    }
  }
  Json parts = Json::array();
  std::string statement;
  bool certified = true;
  for (const Result& result : results) {
    certified = certified && result.certificate;
    if (!certified) break;
    parts.push_back({{"kind", (*result.certificate)["kind"]}, {"data", (*result.certificate)["data"]}});
    statement += (statement.empty() ? "" : "; ") + result.claim;
  }
  Result all;
  all.details["parts"] = Json::array();
  for (const Result& result : results) all.details["parts"].push_back({{"claim", result.claim}, {"details", result.details}});
  if (certified) {
    Json details = std::move(all.details);
    all = concluded(Verdict::proved, "each of the " + std::to_string(results.size()) + " parts is proved",
                    seal("all-of", statement, {{"parts", std::move(parts)}}));
    all.details = std::move(details);
  } else {
    all.verdict = Verdict::proved;
    for (const Result& result : results) all.evidence = all.evidence || result.evidence;
    if (!all.evidence) all.verdict = Verdict::undecided;
  }
  all.claim = joined(results, &Result::claim);
  return all;
}

}  // namespace udcp
