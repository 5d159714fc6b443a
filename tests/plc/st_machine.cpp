// Structured Text, executed as it is read: the body is parsed again in every scan, with a flag that
// says whether what is parsed is also executed, so that text which no scan reaches is checked too.

#include "plc/st_machine.h"

#include "plc/iec_block.h"

namespace grafwire::testing {

namespace {

class StMachine : public IecMachine {
  public:
    StMachine(const std::string& text, const Grafcet& grafcet)
        : IecMachine(grafcet), cursor_(iec_tokens(text)) {
        block_.read_declarations(cursor_);
        body_ = cursor_;
    }

    void scan(Time now) override {
        now_ = now;
        cursor_ = body_;
        statements(true);
        cursor_.expect("end_function_block");
        if (cursor_.peek().kind != IecToken::Kind::end) cursor_.fail("text after the block");
    }

  private:
    std::size_t line() const { return cursor_.peek().line; }

    void statements(bool execute) {
        while (!cursor_.is("end_function_block") && !cursor_.is("end_if") && !cursor_.is("else") &&
               !cursor_.is("elsif") && !cursor_.is("end_for")) {
            statement(execute);
            cursor_.expect(";");
        }
    }

    void statement(bool execute) {
        if (cursor_.is("if")) return if_statement(execute);
        if (cursor_.is("for")) return for_statement(execute);
        const std::size_t at = line();
        const std::string& name = cursor_.identifier();
        if (cursor_.accept("(")) return timer_call(name, execute);
        IecValue index;
        const bool has_index = cursor_.accept("[");
        if (has_index) {
            index = expression();
            cursor_.expect("]");
        }
        cursor_.expect(":=");
        const IecValue value = expression();
        if (execute) block_.store(name, has_index ? &index : nullptr, value, at);
    }

    void if_statement(bool execute) {
        cursor_.expect("if");
        const bool holds = boolean(expression());
        cursor_.expect("then");
        statements(execute && holds);
        if (cursor_.accept("else")) statements(execute && !holds);
        cursor_.expect("end_if");
    }

    void for_statement(bool execute) {
        cursor_.expect("for");
        const std::size_t at = line();
        const std::string& name = cursor_.identifier();
        cursor_.expect(":=");
        const IecValue from = expression();
        cursor_.expect("to");
        const IecValue to = expression();
        cursor_.expect("do");
        const IecTokenCursor inner = cursor_;
        for (std::int64_t i = from.value; execute && i <= to.value; ++i) {
            cursor_ = inner;
            block_.store(name, nullptr, {from.type, i}, at);
            statements(true);
        }
        cursor_ = inner;
        statements(false);
        cursor_.expect("end_for");
    }

    void timer_call(const std::string& name, bool execute) {
        const std::size_t at = line();
        cursor_.expect("in");
        cursor_.expect(":=");
        const bool in = boolean(expression());
        cursor_.expect(",");
        cursor_.expect("pt");
        cursor_.expect(":=");
        const IecValue pt = expression();
        if (pt.type != IecType::time) cursor_.fail("PT is no time");
        cursor_.expect(")");
        block_.timer_output(name, at);
        if (execute) block_.call_timer(name, in, pt.value, now_, at);
    }

    bool boolean(IecValue value) const {
        if (value.type != IecType::boolean) cursor_.fail("expected a BOOL before");
        return value.value != 0;
    }
    static IecValue from_bool(bool value) { return {IecType::boolean, value ? 1 : 0}; }

    // From the weakest operator to the strongest (3.3.1, table 55).
    IecValue expression() {
        IecValue left = exclusive_or();
        while (cursor_.accept("or")) {
            const bool right = boolean(exclusive_or());
            left = from_bool(boolean(left) || right);
        }
        return left;
    }

    IecValue exclusive_or() {
        IecValue left = conjunction();
        while (cursor_.accept("xor")) {
            const bool right = boolean(conjunction());
            left = from_bool(boolean(left) != right);
        }
        return left;
    }

    IecValue conjunction() {
        IecValue left = equality();
        while (cursor_.accept("and") || cursor_.accept("&")) {
            const bool right = boolean(equality());
            left = from_bool(boolean(left) && right);
        }
        return left;
    }

    IecValue equality() {
        IecValue left = relation();
        while (cursor_.is("=") || cursor_.is("<>")) {
            const std::size_t at = line();
            const bool wanted = cursor_.take().text == "=";
            left = from_bool((compare_values(left, relation(), at) == 0) == wanted);
        }
        return left;
    }

    IecValue relation() {
        IecValue left = sum();
        while (cursor_.is("<") || cursor_.is("<=") || cursor_.is(">") || cursor_.is(">=")) {
            const std::size_t at = line();
            const std::string& sign = cursor_.take().text;
            const int order = compare_values(left, sum(), at);
            const bool holds = sign == "<"    ? order < 0
                               : sign == "<=" ? order <= 0
                               : sign == ">"  ? order > 0
                                              : order >= 0;
            left = from_bool(holds);
        }
        return left;
    }

    IecValue sum() {
        IecValue left = unary();
        while (cursor_.is("+") || cursor_.is("-")) {
            const std::size_t at = line();
            const bool subtract = cursor_.take().text == "-";
            const IecValue right = unary();
            left = add_integers(left, right, subtract, at);
        }
        return left;
    }

    IecValue unary() {
        const std::size_t at = line();
        if (cursor_.accept("not")) return from_bool(!boolean(primary()));
        if (cursor_.accept("-")) return add_integers({IecType::literal, 0}, primary(), true, at);
        return primary();
    }

    IecValue primary() {
        const std::size_t at = line();
        const IecToken& token = cursor_.take();
        if (token.kind == IecToken::Kind::integer) return {IecType::literal, token.value};
        if (token.kind == IecToken::Kind::time) return {IecType::time, token.value};
        if (token.text == "(") {
            const IecValue inner = expression();
            cursor_.expect(")");
            return inner;
        }
        if (token.text == "true" || token.text == "false") return from_bool(token.text == "true");
        if (token.kind != IecToken::Kind::identifier) throw PlcError(at, "expected a value");
        if (token.text == "limit") return limit();
        if (cursor_.accept(".")) {
            cursor_.expect("q");
            return from_bool(block_.timer_output(token.text, at));
        }
        if (!cursor_.accept("[")) return block_.load(token.text, nullptr, at);
        const IecValue index = expression();
        cursor_.expect("]");
        return block_.load(token.text, &index, at);
    }

    /// LIMIT(MN, IN, MX).
    IecValue limit() {
        const std::size_t at = line();
        cursor_.expect("(");
        const IecValue low = expression();
        cursor_.expect(",");
        const IecValue value = expression();
        cursor_.expect(",");
        const IecValue high = expression();
        cursor_.expect(")");
        if (compare_values(value, low, at) < 0) return {value.type, low.value};
        if (compare_values(value, high, at) > 0) return {value.type, high.value};
        return value;
    }

    IecTokenCursor cursor_;
    IecTokenCursor body_{{}};
    Time now_ = 0;
};

}  // namespace

std::unique_ptr<PlcMachine> st_machine(const std::string& text, const Grafcet& grafcet) {
    return std::make_unique<StMachine>(text, grafcet);
}

}  // namespace grafwire::testing
