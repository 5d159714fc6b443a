#pragma once

#include <set>
#include <string>

#include "support/iec_block.h"

namespace grafwire::testing {

/// The names of what statements have read and written where they were executed.
struct StAccess {
    std::set<std::string> reads;
    std::set<std::string> writes;
};

/// Statements or an expression in Structured Text on the variables of a block, executed as they are
/// read: the text is parsed again in every run, with a flag that says whether what is parsed is
/// also executed, so that text which no run reaches is checked too.
class StBody {
  public:
    StBody(IecBlock& block, IecTokenCursor text) : block_(block), text_(text), cursor_(text) {}

    /// Executes statements up to the end of the text or of the block it stands in; gives what
    /// follows.
    IecTokenCursor run(Time now, StAccess* access = nullptr);
    /// The value of an expression, which is all of the text.
    bool condition(Time now);

  private:
    std::size_t line() const { return cursor_.peek().line; }
    void statements(bool execute);
    void statement();
    void store(const std::string& name, const IecValue* index, IecValue value, std::size_t at);
    IecValue load(const std::string& name, const IecValue* index, std::size_t at);
    void if_statement();
    void for_statement();
    void timer_call(const std::string& name);
    bool boolean(IecValue value) const;
    // From the weakest operator to the strongest (3.3.1, table 55).
    IecValue expression();
    IecValue exclusive_or();
    IecValue conjunction();
    IecValue equality();
    IecValue relation();
    IecValue sum();
    IecValue unary();
    IecValue primary();
    IecValue limit();

    IecBlock& block_;
    IecTokenCursor text_;
    IecTokenCursor cursor_;
    Time now_ = 0;
    bool executes_ = true;
    StAccess* access_ = nullptr;
};

}  // namespace grafwire::testing
