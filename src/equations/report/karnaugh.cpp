// The truth table of a step and its Karnaugh map, as the course "Mise en œuvre du GRAFCET" (section
// 1.2) shows them to justify X = CAX + /CDX.X: activation wins over deactivation. The map has its
// columns in Gray order, so that the two products are rectangles: the columns 11 and 10, and in the
// row X = 1 the columns 00 and 10.

#include <array>

#include "equations/report/reports.h"

namespace grafwire {

namespace {

/// The columns CAX CDX of the map, in Gray order.
struct Column {
    std::string_view label;
    bool cax;
    bool cdx;
};
constexpr std::array<Column, 4> columns{
    {{"00", false, false}, {"01", false, true}, {"11", true, true}, {"10", true, false}}};

bool next_x(bool x, bool cax, bool cdx) {
    return cax || (!cdx && x);
}

Page::Cell bit(bool value) {
    return Page::words(value ? "1" : "0");
}

void write_truth_table(const Words& words, StepId step, Page& page) {
    page.begin_table(
        {Page::formula(page.of_step("X", step) + "(t)"), Page::formula(page.of_step("CAX", step)),
         Page::formula(page.of_step("CDX", step)),
         Page::formula(page.of_step("X", step) + "(t+dt)"), Page::words(words.remark)});
    for (std::size_t i = 0; i < words.remarks.size(); ++i) {
        const bool x = (i & 4U) != 0;
        const bool cax = (i & 2U) != 0;
        const bool cdx = (i & 1U) != 0;
        page.row(
            {bit(x), bit(cax), bit(cdx), bit(next_x(x, cax, cdx)), Page::words(words.remarks[i])});
    }
    page.end_table();
}

/// Ones are marked with the groups that cover them: a for CAX, b for /CDX.X.
void write_map(StepId step, Page& page) {
    std::vector<Page::Cell> head{Page::words("")};
    for (const Column& column : columns) head.push_back(Page::words(column.label));
    head.front() = Page::formula(page.of_step("X", step));
    page.begin_table(head);
    for (const bool x : {false, true}) {
        std::vector<Page::Cell> cells{bit(x)};
        for (const Column& column : columns) {
            std::string text = next_x(x, column.cax, column.cdx) ? "1" : "0";
            if (column.cax) text += " a";
            if (x && !column.cdx) text += column.cax ? "b" : " b";
            cells.push_back(Page::words(text));
        }
        page.row(cells);
    }
    page.end_table();
}

void write_groups(const Words& words, StepId step, Page& page) {
    page.begin_table(
        {Page::words(words.group), Page::words(words.covers), Page::words(words.cells)});
    page.row({Page::words("a"), Page::formula(page.of_step("CAX", step)),
              Page::words("0, 11; 0, 10; 1, 11; 1, 10")});
    page.row({Page::words("b"), Page::formula(page.held(step)), Page::words("1, 00; 1, 10")});
    page.end_table();
    page.begin_equations();
    page.equation(page.of_step("X", step), page.of_step("CAX", step) + " + " + page.held(step));
    page.end_equations();
}

}  // namespace

void write_karnaugh(Reported& reported, StepId step, const Words& words, Page& page) {
    page.heading(std::string(words.karnaugh) + " X" + reported.grafcet.steps[step].name);
    write_truth_table(words, step, page);
    write_map(step, page);
    write_groups(words, step, page);

    const SmallerForms smaller = smaller_forms(reported, step);
    if (!smaller.any()) return;
    page.paragraph(words.smaller);
    page.begin_equations();
    const auto show = [&](std::string_view quantity, ExprId id) {
        if (id != no_expr) page.equation(page.of_step(quantity, step), page.expression(id));
    };
    show("CAX", smaller.cax);
    show("CDX", smaller.cdx);
    show("X", smaller.x);
    page.end_equations();
}

}  // namespace grafwire
