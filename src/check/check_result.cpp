#include "check/check_result.h"

#include "check/keys.h"

namespace grafwire {

namespace {

constexpr std::uint64_t cases_between_questions = 16;

}  // namespace

bool CaseCounter::count(bool is_stable, std::size_t waiting) {
    ++coverage_.cases;
    if (!is_stable) ++coverage_.unstable;
    coverage_.waiting = waiting;
    if (options_.max_cases != 0 && coverage_.cases >= options_.max_cases) return false;
    return coverage_.cases % cases_between_questions != 0 || goes_on();
}

void CaseCounter::note(const BitTable& situation) {
    std::string key;
    append_key(key, situation);
    if (situations_.insert(std::move(key)).second) ++coverage_.situations;
}

void conclude(CheckResult& result, bool is_complete, std::size_t waiting) {
    result.complete = is_complete;
    result.coverage.waiting = waiting;
    if (result.witness) {
        result.verdict = Verdict::different;
    } else if (is_complete && result.coverage.cases != 0) {
        result.verdict = Verdict::equivalent;
    }
}

}  // namespace grafwire
