#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "equations/equations.h"
#include "text/message.h"

namespace grafwire {

/// A page that a report is written on, in one of the forms meant for people. Formulas are texts in
/// the form's own notation; they are made by the page and handed back to it.
class Page {
  public:
    /// A cell of a table: words, or a formula.
    struct Cell {
        std::string text;
        bool is_formula = false;
    };
    static Cell words(std::string_view text) { return {std::string(text), false}; }
    static Cell formula(std::string text) { return {std::move(text), true}; }

    virtual ~Page() = default;

    virtual std::string expression(ExprId id) = 0;
    /// An expression that is to stand in a table.
    virtual Cell cell(ExprId id) { return formula(expression(id)); }
    virtual std::string name(Variable variable) const = 0;
    virtual std::string name(VarId var) const = 0;
    /// `CAX`: a quantity of any step; `CAX0`: of one.
    virtual std::string quantity(std::string_view quantity) const = 0;
    virtual std::string of_step(std::string_view quantity, StepId step) const = 0;
    /// `/CDX.X`: the product that holds a step active.
    virtual std::string held() const = 0;
    /// `X0.X5 -> X1`: the steps before a transition and those after it.
    virtual std::string passage(std::span<const StepId> from, std::span<const StepId> to) const = 0;
    /// `n := n + 1`, `n := 0`
    virtual std::string write(Variable target, const StoredWrite& write) = 0;

    virtual void title(std::string_view text) = 0;
    virtual void heading(std::string_view text) = 0;
    virtual void paragraph(std::string_view text) = 0;
    virtual void begin_table(const std::vector<Cell>& head) = 0;
    /// A Karnaugh map: the variable of its rows, those of its columns, and the columns.
    virtual void begin_map(const std::string& rows, const std::vector<std::string>& columns,
                           const std::vector<std::string>& labels) = 0;
    virtual void row(const std::vector<Cell>& cells) = 0;
    virtual void end_table() = 0;
    virtual void begin_equations() = 0;
    virtual void equation(const std::string& left, const std::string& right) = 0;
    virtual void end_equations() = 0;

    /// The finished page. To be called once.
    virtual std::string finish() = 0;
};

/// What the pages refer to must outlive them; the pool of expressions may grow meanwhile.
std::unique_ptr<Page> text_page(const Grafcet& grafcet, const Expressions& pool);
std::unique_ptr<Page> markdown_page(const Grafcet& grafcet, const Expressions& pool);
/// A part of a page, which is XML as well.
std::unique_ptr<Page> html_page(const Grafcet& grafcet, const Expressions& pool);
/// A whole document, or what is to stand in one.
std::unique_ptr<Page> latex_page(const Grafcet& grafcet, const Expressions& pool, Language language,
                                 bool standalone);

}  // namespace grafwire
