// The text is read by ChartParser, which goes on after an error at the next part of it; names are
// looked up and rules are checked by GrafcetBuilder, so that all errors of a file come at once.

#include "grafcet/parse_grafcet.h"

#include <limits>

#include "grafcet/chart_parser.h"
#include "grafcet/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

bool is_readable(const SourceFile& source, Diagnostics& diagnostics) {
    if (source.text.size() >= std::numeric_limits<std::uint32_t>::max()) {
        diagnostics.error(code::unreadable_file, {}, messages::grafcet::file_too_large());
        return false;
    }
    return check_utf8(source.text, diagnostics);
}

/// `tokens`: where to keep the tokens of the text; nullptr where nobody asks.
std::optional<Grafcet> parse(const SourceFile& source, std::vector<ReadToken>* tokens,
                             Diagnostics& diagnostics) {
    if (!is_readable(source, diagnostics)) return std::nullopt;
    GrafcetBuilder builder(diagnostics);
    ChartParser parser(source.text, builder, diagnostics);
    if (tokens != nullptr) parser.keep_tokens_in(*tokens);
    parser.parse_file();
    return builder.finish();
}

}  // namespace

std::optional<Grafcet> parse_grafcet(const SourceFile& source, Diagnostics& diagnostics) {
    return parse(source, nullptr, diagnostics);
}

std::optional<Grafcet> parse_keeping_tokens(const SourceFile& source,
                                            std::vector<ReadToken>& tokens,
                                            Diagnostics& diagnostics) {
    return parse(source, &tokens, diagnostics);
}

void parse_assumption(const SourceFile& source, Grafcet& grafcet, Diagnostics& diagnostics) {
    if (!is_readable(source, diagnostics)) return;
    TokenReader tokens(source.text, diagnostics);
    const Location where = tokens.token().where;
    NamedExpression expression;
    if (parse_expression(tokens, expression)) {
        if (tokens.at(TokenKind::end)) {
            add_assumption(grafcet, expression, where, diagnostics);
        } else {
            tokens.fail_expecting(messages::grafcet::operator_or_end());
        }
    }
    diagnostics.sort_by_place();
}

}  // namespace grafwire
