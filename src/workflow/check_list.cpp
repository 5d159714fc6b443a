// A check that was not made is a case like any other in every report: a server that shows nothing
// else must not take what is missing for what is right.

#include "workflow/check_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <tuple>

#include "check/messages.h"
#include "text/joined.h"
#include "text/utf8.h"
#include "workflow/json_line.h"
#include "workflow/messages.h"
#include "workflow/netlists.h"
#include "workflow/sarif.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

/// What is said of a case, with that of its file before it.
std::vector<Diagnostic> messages_of(const CheckList& list, const CheckedCase& item) {
    std::vector<Diagnostic> all;
    for (const auto* messages : {&list.files[item.file].messages, &item.messages}) {
        for (const FileMessages& about : *messages) {
            all.insert(all.end(), about.messages.begin(), about.messages.end());
        }
    }
    return all;
}

/// Why a check was not made: the first error there is.
Localized reason_of(const CheckList& list, const CheckedCase& item) {
    for (const Diagnostic& message : messages_of(list, item)) {
        if (message.severity == Severity::error) return message.message;
    }
    return {};
}

/// What the chart was to be compared with.
Localized compared_with(const CheckSubject& subject) {
    if (subject.against.empty()) {
        return messages::check::made_in(subject.style, subject.cdx);
    }
    return Localized::same_in_both(visible(subject.against));
}

}  // namespace

std::vector<std::string> styles_in(std::string_view words) {
    const auto is_named = [&](std::string_view style) {
        for (std::string_view rest = words; !rest.empty();) {
            const std::size_t end = std::min(rest.find(','), rest.size());
            if (rest.substr(0, end) == style) return true;
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return false;
    };
    std::vector<std::string> styles;
    std::size_t length = 0;
    for (const StyleRow& row : style_table) {
        if (words != "all" && !is_named(row.name)) continue;
        styles.emplace_back(row.name);
        length += row.name.size() + 1;
    }
    // Words that are none, that stand there twice, or empty ones leave something over.
    if (words != "all" && length != words.size() + 1) return {};
    return styles;
}

std::vector<PlannedCheck> plan_checks(std::size_t files, const std::vector<std::string>& styles) {
    std::vector<PlannedCheck> plan;
    for (std::size_t file = 0; file < files; ++file) {
        for (const std::string& style : styles) plan.push_back({file, style});
    }
    return plan;
}

std::optional<Shard> parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto read = [](std::string_view digits, std::size_t& number) {
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), number);
        return error == std::errc() && end == digits.data() + digits.size();
    };
    Shard shard;
    if (!read(text.substr(0, slash), shard.number) || !read(text.substr(slash + 1), shard.count)) {
        return std::nullopt;
    }
    if (shard.number < 1 || shard.number > shard.count) return std::nullopt;
    return shard;
}

std::vector<PlannedCheck> part_of(std::vector<PlannedCheck> plan,
                                  const std::vector<std::string>& names, Shard shard) {
    std::stable_sort(plan.begin(), plan.end(), [&](const PlannedCheck& a, const PlannedCheck& b) {
        return std::tie(names[a.file], a.style) < std::tie(names[b.file], b.style);
    });
    // Whole parts first: no product is larger than the plan.
    const std::size_t size = plan.size() / shard.count;
    const std::size_t larger = plan.size() % shard.count;
    const auto begin_of = [&](std::size_t part) {
        return static_cast<std::ptrdiff_t>(part * size + std::min(part, larger));
    };
    return {plan.begin() + begin_of(shard.number - 1), plan.begin() + begin_of(shard.number)};
}

CheckOutcome CheckedCase::outcome() const {
    if (!judgement) return is_skipped ? CheckOutcome::skipped : CheckOutcome::error;
    switch (judgement->result.verdict) {
        case Verdict::equivalent:
            return CheckOutcome::equivalent;
        case Verdict::different:
            return CheckOutcome::different;
        case Verdict::undecided:
            break;
    }
    return CheckOutcome::undecided;
}

std::vector<std::size_t> refuse_skipped_files(CheckList& list) {
    std::vector<bool> is_judged(list.files.size(), false);
    for (const CheckedCase& item : list.cases) {
        if (item.outcome() != CheckOutcome::skipped) is_judged[item.file] = true;
    }
    std::vector<std::size_t> files;
    for (CheckedCase& item : list.cases) {
        if (is_judged[item.file]) continue;
        item.is_skipped = false;
        if (files.empty() || files.back() != item.file) files.push_back(item.file);
    }
    return files;
}

std::string write_texts(const CheckList& list, Language language) {
    std::string text;
    for (const CheckedCase& item : list.cases) {
        if (!text.empty()) text += '\n';
        if (item.judgement) {
            text += write_check_text(item.judgement->subject, list.files[item.file].chart->grafcet,
                                     item.judgement->result, item.judgement->explained, language);
        } else {
            const auto& message = item.is_skipped ? say::skipped : say::not_checked;
            text += message.in(language, visible(item.subject.file), compared_with(item.subject),
                               reason_of(list, item));
        }
    }
    return text;
}

std::string write_json_lines(const CheckList& list, Language) {
    std::string lines;
    for (const CheckedCase& item : list.cases) {
        lines += json_line(
            item.judgement
                ? write_check_json(item.judgement->subject, list.files[item.file].chart->grafcet,
                                   item.judgement->result, item.judgement->explained)
                : write_unchecked_json(item.subject, item.is_skipped, messages_of(list, item)));
    }
    return lines;
}

std::string write_junit_suite(const CheckList& list, Language) {
    std::vector<JunitCase> cases;
    for (const CheckedCase& item : list.cases) {
        const CheckedFile& file = list.files[item.file];
        if (item.judgement) {
            cases.push_back(junit_case(item.judgement->subject, file.chart->grafcet,
                                       item.judgement->result, item.judgement->explained,
                                       item.seconds));
        } else {
            cases.push_back(unchecked_junit_case(item.subject, item.is_skipped,
                                                 file.text.english + item.text.english,
                                                 item.seconds));
        }
    }
    return write_junit(cases);
}

// SARIF.

namespace {

/// What a verdict says, as a message about the chart; none where it is equivalent.
std::optional<Diagnostic> verdict_message(const CheckList& list, const CheckedCase& item) {
    const Localized compared = compared_with(item.subject);
    switch (item.outcome()) {
        case CheckOutcome::different:
            return Diagnostic{
                Severity::error,
                code::different,
                {},
                say::sarif_different(std::string(name_of(item.judgement->result.witness->kind)),
                                     compared),
                {}};
        case CheckOutcome::undecided:
            return Diagnostic{
                Severity::warning, code::undecided, {}, say::sarif_undecided(compared), {}};
        case CheckOutcome::skipped:
            return Diagnostic{Severity::warning,
                              code::skipped,
                              {},
                              say::sarif_skipped(compared, reason_of(list, item)),
                              {}};
        case CheckOutcome::equivalent:
        case CheckOutcome::error:
            break;
    }
    return std::nullopt;
}

}  // namespace

std::string write_check_sarif(const CheckList& list, Language) {
    std::vector<FileMessages> all;
    for (const CheckedCase& item : list.cases) {
        const CheckedFile& file = list.files[item.file];
        all.insert(all.end(), file.messages.begin(), file.messages.end());
        const auto of_file = [&](Diagnostic message) {
            all.push_back({{item.subject.file, file.chart ? file.chart->source.text : ""},
                           {std::move(message)}});
        };
        if (const auto message = verdict_message(list, item)) of_file(*message);
        if (item.is_skipped) continue;
        for (const FileMessages& about : item.messages) {
            if (!about.source.name.empty()) {
                all.push_back(about);
            } else {
                for (const Diagnostic& message : about.messages) of_file(message);
            }
        }
    }
    return write_sarif(all, list.folder);
}

// The table.

namespace {

using Row = std::vector<std::string>;

/// In the order of the enumerators.
struct OutcomeWords {
    const Message<>& word;
    const CountedMessage<>& count;
};
constexpr OutcomeWords outcome_words[] = {{say::outcome_equivalent, say::equivalent_checks},
                                          {say::outcome_different, say::different_checks},
                                          {say::outcome_undecided, say::undecided_checks},
                                          {say::outcome_skipped, say::skipped_checks},
                                          {say::outcome_error, say::wrong_checks}};

std::string word_for(CheckOutcome outcome, Language language) {
    return outcome_words[static_cast<std::size_t>(outcome)].word.in(language);
}

/// Columns as wide as what is in them, the last two to the right.
std::string aligned(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], count_code_points(row[c]));
        }
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string blanks(widths[c] - count_code_points(row[c]), ' ');
            if (c != 0) text += "  ";
            text += c + 2 < row.size() ? row[c] + blanks : blanks + row[c];
        }
        text += '\n';
    }
    return text;
}

/// The file; of an interlocked chart, which is another, that it is one.
std::string file_cell(const CheckedCase& item, Language language) {
    const std::string file = visible(item.subject.file);
    const bool is_interlocked = item.judgement && item.judgement->subject.orders &&
                                item.judgement->subject.orders->is_interlocked();
    return is_interlocked ? messages::check::interlocked_file.in(language, file) : file;
}

Row row_of(const CheckedCase& item, Language language) {
    const CheckSubject& subject = item.subject;
    return {file_cell(item, language),
            subject.against.empty() ? subject.style : visible(subject.against),
            word_for(item.outcome(), language),
            item.judgement ? fmt::format("{}", item.judgement->result.coverage.cases) : "-",
            fmt::format("{:.2f}", item.seconds)};
}

std::string table_in(const CheckList& list, Language language) {
    std::vector<Row> rows{{say::column_file.in(language), say::column_compared.in(language),
                           say::column_verdict.in(language), say::column_cases.in(language),
                           say::column_seconds.in(language)}};
    std::size_t counts[std::size(outcome_words)] = {};
    for (const CheckedCase& item : list.cases) {
        rows.push_back(row_of(item, language));
        ++counts[static_cast<std::size_t>(item.outcome())];
    }
    std::vector<std::string> counted;
    for (std::size_t i = 0; i < std::size(outcome_words); ++i) {
        if (counts[i] != 0) counted.push_back(outcome_words[i].count.in(language, counts[i]));
    }
    return aligned(rows) + say::checks.in(language, list.cases.size(), joined(counted, ", "));
}

}  // namespace

Localized outcome_table(const CheckList& list) {
    return {table_in(list, Language::english), table_in(list, Language::french)};
}

}  // namespace grafwire
