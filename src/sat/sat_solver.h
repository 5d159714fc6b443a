#pragma once

#include <memory>
#include <span>

namespace grafwire {

/// Decides whether Boolean variables can be given values so that every clause has a literal that is
/// true. Variables are numbered from 1; a literal is the number of a variable, negative for its
/// negation. Clauses can be added between two questions. The same calls give the same answers.
class SatSolver {
  public:
    SatSolver();
    ~SatSolver();
    SatSolver(SatSolver&&) noexcept;
    SatSolver& operator=(SatSolver&&) noexcept;

    /// The number of a further variable.
    int new_variable();
    /// At least one of these literals is to be true; of none: nothing can hold any more.
    void add_clause(std::span<const int> literals);

    /// Whether the clauses can be satisfied while all these literals are true.
    bool can_hold(std::span<const int> literals);
    /// After can_hold was true: the value of a variable in the solution found.
    bool value(int variable) const;
    /// After can_hold was false: whether one of the literals asked for was needed to say so.
    bool is_to_blame(int literal) const;

  private:
    struct Solver;
    std::unique_ptr<Solver> solver_;
};

}  // namespace grafwire
