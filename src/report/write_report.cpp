// The page from top to bottom. Each section has a place in the contents; one that has nothing to
// show is in neither.

#include <fmt/format.h>

#include "report/html.h"
#include "report/messages.h"
#include "report/page_style.h"
#include "report/report.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

namespace say = messages::report;

using Outcome = ReportedStyle::Outcome;

const Message<>& name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::equivalent:
            return say::equivalent;
        case Outcome::different:
            return say::different;
        case Outcome::undecided:
            return say::undecided;
        case Outcome::not_made:
            break;
    }
    return say::not_made;
}

/// As style sheets and scripts find it.
std::string_view class_of(Outcome outcome) {
    constexpr std::string_view classes[] = {"equivalent", "different", "undecided", "not-made"};
    return classes[static_cast<std::size_t>(outcome)];
}

class ReportWriter {
  public:
    ReportWriter(const Report& report, Language language) : report_(report), language_(language) {}

    std::string write() {
        html_.markup("<!DOCTYPE html>\n");
        const std::string_view code = language_ == Language::french ? "fr" : "en";
        html_.open("html",
                   {{"xmlns", "http://www.w3.org/1999/xhtml"}, {"lang", code}, {"xml:lang", code}});
        head();
        html_.open("body");
        beginning();
        chart();
        names();
        equations();
        schematic();
        runs();
        verdicts();
        warnings();
        source();
        html_.element("footer", say::made_by.in(language_, version()));
        html_.close();
        html_.close();
        return html_.take();
    }

  private:
    template <class... Arguments>
    std::string in_words(const Message<Arguments...>& message,
                         const std::type_identity_t<Arguments>&... arguments) const {
        return message.in(language_, arguments...);
    }
    void heading_cells(std::initializer_list<const Message<>*> columns) {
        html_.open("thead");
        html_.open("tr");
        for (const Message<>* column : columns) html_.element("th", in_words(*column));
        html_.close();
        html_.close();
    }
    void pictures(const std::vector<std::string>& sheets) {
        for (const std::string& sheet : sheets) {
            html_.open("figure");
            html_.markup(sheet);
            html_.close();
        }
    }
    void list(const std::vector<std::string>& items) {
        html_.open("ul");
        for (const std::string& item : items) html_.element("li", item);
        html_.close();
    }
    void begin_section(std::string_view id, std::string_view heading) {
        html_.open("section", {{"id", id}});
        html_.element("h2", heading);
    }
    void begin_section(std::string_view id, const Message<>& heading) {
        begin_section(id, in_words(heading));
    }

    void head() {
        html_.open("head");
        html_.empty("meta", {{"charset", "utf-8"}});
        html_.empty("meta",
                    {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
        html_.element("title", report_.title);
        html_.open("style");
        html_.markup(page_style);
        html_.markup(report_.picture_style);
        html_.close();
        html_.close();
    }

    bool has_names() const { return !report_.inputs.empty() || !report_.outputs.empty(); }
    bool has_warnings() const { return !report_.warnings.empty() || !report_.hazards.empty(); }

    void beginning() {
        html_.element("h1", report_.title);
        html_.element("p", in_words(say::about, report_.name, report_.file));
        html_.open("nav");
        html_.element("h2", in_words(say::contents));
        html_.open("ul");
        const auto add = [&](bool is_there, std::string_view id, const std::string& heading) {
            if (!is_there) return;
            html_.open("li");
            html_.element("a", heading, {{"href", fmt::format("#{}", id)}});
            html_.close();
        };
        add(true, "chart", in_words(say::chart));
        add(has_names(), "names", in_words(say::names));
        add(true, "equations", in_words(say::equations));
        add(!report_.schematic.empty(), "schematic", in_words(say::schematic, report_.wired_style));
        add(!report_.runs.empty(), "run", in_words(say::run));
        add(true, "verdicts", in_words(say::verdicts));
        for (const ReportedStyle& style : report_.styles) {
            add(has_details(style), id_of(style), in_words(say::style, style.name));
        }
        add(has_warnings(), "warnings", in_words(say::warnings));
        add(true, "source", in_words(say::source));
        html_.close();
        html_.close();
    }

    void chart() {
        begin_section("chart", say::chart);
        pictures(report_.chart);
        html_.close();
    }

    void names() {
        if (!has_names()) return;
        begin_section("names", say::names);
        html_.open("table");
        heading_cells({&say::kind, &say::name, &say::comment});
        html_.open("tbody");
        const auto add = [&](const Message<>& kind, const std::vector<ReportedName>& names) {
            for (const ReportedName& name : names) {
                html_.open("tr");
                html_.element("td", in_words(kind));
                html_.open("td");
                html_.element("code", name.name);
                html_.close();
                html_.element("td", name.comment);
                html_.close();
            }
        };
        add(say::input, report_.inputs);
        add(say::output, report_.outputs);
        html_.close();
        html_.close();
        html_.element("p", in_words(say::modes));
        html_.close();
    }

    void equations() {
        begin_section("equations", say::equations);
        html_.markup(report_.equations);
        html_.close();
    }

    void schematic() {
        if (report_.schematic.empty()) return;
        begin_section("schematic", in_words(say::schematic, report_.wired_style));
        pictures(report_.schematic);
        html_.close();
    }

    void runs() {
        for (const ReportedRun& run : report_.runs) {
            begin_section("run", say::run);
            html_.element("p", in_words(say::stimuli, run.file));
            if (!run.remarks.empty()) list(run.remarks);
            pictures(run.pictures);
            html_.element("h3", in_words(say::story));
            html_.element("pre", run.story);
            html_.close();
        }
    }

    // -- Verdicts

    static std::string id_of(const ReportedStyle& style) { return "style-" + style.name; }
    static bool has_details(const ReportedStyle& style) {
        return !style.remarks.empty() || !style.witness.empty();
    }

    void verdicts() {
        begin_section("verdicts", say::verdicts);
        html_.element("p", in_words(say::verdicts_are));
        if (!report_.assumptions.empty()) {
            html_.element("p", in_words(say::assumptions, joined(report_.assumptions, ", ")));
        }
        html_.open("table");
        heading_cells({&say::style_column, &say::verdict, &say::compared, &say::rests_on});
        html_.open("tbody");
        for (const ReportedStyle& style : report_.styles) verdict(style);
        html_.close();
        html_.close();
        html_.close();
        for (const ReportedStyle& style : report_.styles) details(style);
    }

    void verdict(const ReportedStyle& style) {
        html_.open("tr");
        html_.open("td");
        html_.element("code", style.name);
        html_.element("p", style.description);
        html_.close();
        html_.open("td");
        html_.element("strong", in_words(name_of(style.outcome)),
                      {{"class", class_of(style.outcome)}});
        html_.close();
        html_.element("td", style.compared);
        html_.element("td", style.basis);
        html_.close();
    }

    void details(const ReportedStyle& style) {
        if (!has_details(style)) return;
        html_.open("section", {{"id", id_of(style)}});
        html_.element("h2", in_words(say::style, style.name));
        html_.open("p");
        html_.element("strong", in_words(name_of(style.outcome)),
                      {{"class", class_of(style.outcome)}});
        html_.close();
        if (!style.pictures.empty()) html_.element("p", in_words(say::witness_picture));
        pictures(style.pictures);
        if (!style.witness.empty()) html_.element("pre", style.witness);
        if (!style.remarks.empty()) html_.element("pre", style.remarks);
        html_.close();
    }

    void warnings() {
        if (!has_warnings()) return;
        begin_section("warnings", say::warnings);
        if (!report_.warnings.empty()) list(report_.warnings);
        if (!report_.hazards.empty()) {
            html_.element("p", in_words(say::in_wiring));
            list(report_.hazards);
        }
        html_.close();
    }

    void source() {
        begin_section("source", say::source);
        html_.element("pre", report_.source, {{"class", "listing"}});
        html_.close();
    }

    const Report& report_;
    Language language_;
    Html html_;
};

}  // namespace

std::string write_report(const Report& report, Language language) {
    return ReportWriter(report, language).write();
}

}  // namespace grafwire
