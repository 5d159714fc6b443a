// CaDiCaL (A. Biere, K. Fazekas, M. Fleury, M. Heisinger, 2020), asked incrementally: what is to
// hold in one question alone is assumed, not added, so clauses and what the solver has learnt from
// them serve all later questions. With assumptions it also says which of them it had to use
// (`failed`).

#include "sat/sat_solver.h"

#include <cadical.hpp>

namespace grafwire {

struct SatSolver::Solver {
    mutable CaDiCaL::Solver cadical;
    int variables = 0;
};

SatSolver::SatSolver() : solver_(std::make_unique<Solver>()) {}
SatSolver::~SatSolver() = default;
SatSolver::SatSolver(SatSolver&&) noexcept = default;
SatSolver& SatSolver::operator=(SatSolver&&) noexcept = default;

int SatSolver::new_variable() {
    return ++solver_->variables;
}

void SatSolver::add_clause(std::span<const int> literals) {
    for (const int literal : literals) solver_->cadical.add(literal);
    solver_->cadical.add(0);
}

bool SatSolver::can_hold(std::span<const int> literals) {
    for (const int literal : literals) solver_->cadical.assume(literal);
    return solver_->cadical.solve() ==
           10;  // the number that SAT competitions use for "satisfiable"
}

bool SatSolver::value(int variable) const {
    return solver_->cadical.val(variable) > 0;
}

bool SatSolver::is_to_blame(int literal) const {
    return solver_->cadical.failed(literal);
}

}  // namespace grafwire
