#include "support/st_body.h"

namespace grafwire::testing {

namespace {

IecValue from_bool(bool value) {
    return {IecType::boolean, value ? 1 : 0};
}

}  // namespace

IecTokenCursor StBody::run(Time now, StAccess* access) {
    now_ = now;
    access_ = access;
    cursor_ = text_;
    statements(true);
    return cursor_;
}

bool StBody::condition(Time now) {
    now_ = now;
    access_ = nullptr;
    executes_ = true;
    cursor_ = text_;
    const bool value = boolean(expression());
    if (cursor_.peek().kind != IecToken::Kind::end) cursor_.fail("text after an expression");
    return value;
}

void StBody::statements(bool execute) {
    const bool executed_around = executes_;
    executes_ = execute;
    while (cursor_.peek().kind != IecToken::Kind::end && !cursor_.is("end_function_block") &&
           !cursor_.is("end_if") && !cursor_.is("else") && !cursor_.is("elsif") &&
           !cursor_.is("end_for")) {
        statement();
        cursor_.expect(";");
    }
    executes_ = executed_around;
}

void StBody::store(const std::string& name, const IecValue* index, IecValue value, std::size_t at) {
    if (!executes_) return;
    if (access_ != nullptr) access_->writes.insert(name);
    block_.store(name, index, value, at);
}

IecValue StBody::load(const std::string& name, const IecValue* index, std::size_t at) {
    if (executes_ && access_ != nullptr) access_->reads.insert(name);
    return block_.load(name, index, at);
}

void StBody::statement() {
    if (cursor_.is("if")) return if_statement();
    if (cursor_.is("for")) return for_statement();
    const std::size_t at = line();
    const std::string& name = cursor_.identifier();
    if (cursor_.accept("(")) return timer_call(name);
    IecValue index;
    const bool has_index = cursor_.accept("[");
    if (has_index) {
        index = expression();
        cursor_.expect("]");
    }
    cursor_.expect(":=");
    const IecValue value = expression();
    store(name, has_index ? &index : nullptr, value, at);
}

void StBody::if_statement() {
    cursor_.expect("if");
    const bool holds = boolean(expression());
    cursor_.expect("then");
    statements(executes_ && holds);
    if (cursor_.accept("else")) statements(executes_ && !holds);
    cursor_.expect("end_if");
}

void StBody::for_statement() {
    cursor_.expect("for");
    const std::size_t at = line();
    const std::string& name = cursor_.identifier();
    cursor_.expect(":=");
    const IecValue from = expression();
    cursor_.expect("to");
    const IecValue to = expression();
    cursor_.expect("do");
    const IecTokenCursor inner = cursor_;
    for (std::int64_t i = from.value; executes_ && i <= to.value; ++i) {
        cursor_ = inner;
        store(name, nullptr, {from.type, i}, at);
        statements(true);
    }
    cursor_ = inner;
    statements(false);
    cursor_.expect("end_for");
}

void StBody::timer_call(const std::string& name) {
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
    if (executes_) block_.call_timer(name, in, pt.value, now_, at);
}

bool StBody::boolean(IecValue value) const {
    if (value.type != IecType::boolean) cursor_.fail("expected a BOOL before");
    return value.value != 0;
}

IecValue StBody::expression() {
    IecValue left = exclusive_or();
    while (cursor_.accept("or")) {
        const bool right = boolean(exclusive_or());
        left = from_bool(boolean(left) || right);
    }
    return left;
}

IecValue StBody::exclusive_or() {
    IecValue left = conjunction();
    while (cursor_.accept("xor")) {
        const bool right = boolean(conjunction());
        left = from_bool(boolean(left) != right);
    }
    return left;
}

IecValue StBody::conjunction() {
    IecValue left = equality();
    while (cursor_.accept("and") || cursor_.accept("&")) {
        const bool right = boolean(equality());
        left = from_bool(boolean(left) && right);
    }
    return left;
}

IecValue StBody::equality() {
    IecValue left = relation();
    while (cursor_.is("=") || cursor_.is("<>")) {
        const std::size_t at = line();
        const bool wanted = cursor_.take().text == "=";
        left = from_bool((compare_values(left, relation(), at) == 0) == wanted);
    }
    return left;
}

IecValue StBody::relation() {
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

IecValue StBody::sum() {
    IecValue left = unary();
    while (cursor_.is("+") || cursor_.is("-")) {
        const std::size_t at = line();
        const bool subtract = cursor_.take().text == "-";
        const IecValue right = unary();
        left = add_integers(left, right, subtract, at);
    }
    return left;
}

IecValue StBody::unary() {
    const std::size_t at = line();
    if (cursor_.accept("not")) return from_bool(!boolean(primary()));
    if (cursor_.accept("-")) return add_integers({IecType::literal, 0}, primary(), true, at);
    return primary();
}

IecValue StBody::primary() {
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
        return block_.field(token.text, cursor_.identifier(), at);
    }
    if (!cursor_.accept("[")) return load(token.text, nullptr, at);
    const IecValue index = expression();
    cursor_.expect("]");
    return load(token.text, &index, at);
}

/// LIMIT(MN, IN, MX).
IecValue StBody::limit() {
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

}  // namespace grafwire::testing
