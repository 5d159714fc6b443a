// Rows of a trace in which nothing changes show nothing: only moments of change have a place.

#include "draw/timing_diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "draw/messages.h"
#include "draw/moments.h"
#include "text/joined.h"

namespace grafwire {

namespace {

using Kind = Trace::Column::Kind;

constexpr double pitch = 0.85;      ///< of the lines
constexpr double level = 0.5;       ///< between 0 and 1
constexpr double group_gap = 0.35;  ///< above inputs, steps, outputs, …
constexpr double times_room = 0.7;  ///< above the lines, for the times
constexpr double ends_room = 0.4;   ///< more of it, for the delays that end
constexpr double lines_gap = 0.25;  ///< within it, below all texts
constexpr double strip_gap = 0.9;
constexpr double least_step = 1.3;  ///< between two moments
constexpr double axis_room = 0.8;   ///< below the lines, for an axis
constexpr double arrow_room = 0.6;  ///< behind the lines, for the arrow of an axis
constexpr double unit_room = 0.9;   ///< behind that, for the unit

/// A line of the diagram: a column of the trace, or the situation.
struct SignalRow {
    std::optional<std::size_t> column;
    std::string name;
    bool is_boxed = false;  ///< numbers and situations
    bool begins_group = false;
    bool is_other = false;  ///< of the other run
    double low = 0;         ///< where its 0 is, below the top of a strip
};

/// A cause that has a place in the diagram.
struct ShownCause {
    std::size_t moment = 0;
    std::size_t number = 0;  ///< among the causes of its moment
    std::vector<std::size_t> rows;
    std::string ended;  ///< delays
    struct Effect {
        std::size_t row = 0;
        std::size_t moment = 0;
    };
    std::vector<Effect> effects;
};

/// A dotted line stands beside that of the cause before it, of one moment; those of many are
/// closer.
constexpr double cause_pitch = 0.12;
constexpr double causes_room = 0.9;

class TimingDiagram {
  public:
    TimingDiagram(const Trace& trace, const TimingDrawing& how) : trace_(trace), how_(how) {
        choose_rows();
        moments_ = moments_of(trace, how.other);
        for (const std::size_t row : moments_) times_.push_back(trace.times[row]);
        for (const SignalRow& row : rows_) {
            names_width_ = std::max(names_width_, width_of(plain_text(row.name)));
        }
        find_causes();
        head_room_ = has_axis() ? lines_gap : times_room;
        if (has_ends()) head_room_ += ends_room;
        height_ = head_room_ + 0.2;
        for (SignalRow& row : rows_) {
            height_ += pitch + (row.begins_group ? group_gap : 0);
            row.low = height_ - 0.2 - (pitch - level) / 2;
        }
        lines_height_ = height_;
        if (has_axis()) height_ += axis_room;
    }

    std::vector<Sheet> make() {
        // Lying, unless the lines are too many for it.
        const double unit = 8;
        const bool lies = height_ + title_room + 2 * sheet_margin <= how_.paper.width / unit;
        const double width = (lies ? how_.paper.height : how_.paper.width) / unit;
        const double height = (lies ? how_.paper.width : how_.paper.height) / unit;
        space_moments(width - 2 * sheet_margin - names_width_ - 0.3);
        std::vector<Sheet> sheets;
        double y = 0;
        if (places_.strips.empty()) sheets.emplace_back();  // a run without an instant
        for (const Strip& strip : places_.strips) {
            if (sheets.empty() || y + height_ + sheet_margin > height) {
                sheets.emplace_back();
                sheets.back().lies = lies;
                sheets.back().unit = unit;
                y = sheet_margin + title_room;
            }
            scene_ = &sheets.back().scene;
            draw(strip, y);
            y += height_ + strip_gap;
        }
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            finish(sheets[i], i, sheets.size(), width, height);
        }
        return sheets;
    }

  private:
    std::int64_t value(std::size_t moment, std::size_t column, bool of_other = false) const {
        return value_in(of_other ? *how_.other : trace_, moments_[moment], column);
    }
    bool differs(std::size_t column) const {
        if (how_.other == nullptr) return false;
        for (std::size_t row = 0; row < trace_.row_count(); ++row) {
            if (value_in(trace_, row, column) != value_in(*how_.other, row, column)) return true;
        }
        return false;
    }

    // -- What is shown

    void choose_rows() {
        std::optional<Kind> kind;
        for (std::size_t i = 0; i < trace_.columns.size(); ++i) {
            const Trace::Column& column = trace_.columns[i];
            if (is_control(column.name) && stays_0(i)) continue;
            if (kind == Kind::step && column.kind != Kind::step) add_situation();
            rows_.push_back({i, column.name, column.width > 1, kind && *kind != column.kind});
            if (differs(i)) {
                const std::string name = messages::draw::found(column.name).in(how_.language);
                rows_.push_back({i, name, column.width > 1, false, true});
            }
            kind = column.kind;
        }
        if (kind == Kind::step) add_situation();
    }
    void add_situation() {
        if (has_axis()) return;
        rows_.push_back({std::nullopt, messages::draw::situation.in(how_.language), true, false});
    }
    static bool is_control(const std::string& name) {
        return name == "Init" || name == "AUdur" || name == "AUdoux";
    }
    bool stays_0(std::size_t column) const {
        for (std::size_t row = 0; row < trace_.row_count(); ++row) {
            if (value_in(trace_, row, column) != 0) return false;
        }
        return true;
    }

    std::string situation(std::size_t moment) const {
        std::string steps;
        for (std::size_t i = 0; i < trace_.columns.size(); ++i) {
            if (trace_.columns[i].kind != Kind::step || value(moment, i) == 0) continue;
            if (!steps.empty()) steps += ',';
            // Without the X of its variable.
            steps += trace_.columns[i].name.substr(1);
            if (value(moment, i) == Trace::unknown) steps += '?';
        }
        return '{' + steps + '}';
    }
    std::string text_at(const SignalRow& row, std::size_t moment) const {
        if (!row.column) return situation(moment);
        const std::int64_t shown = value(moment, *row.column, row.is_other);
        return shown == Trace::unknown ? "x" : fmt::format("{}", shown);
    }

    /// Causes without an effect that is shown have no place.
    void find_causes() {
        const auto moment_at = [&](Time at) {
            const auto found = std::find(times_.begin(), times_.end(), at);
            return static_cast<std::size_t>(found - times_.begin());
        };
        const auto row_of = [&](std::size_t column) {
            const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const SignalRow& row) {
                return row.column == column;
            });
            return static_cast<std::size_t>(found - rows_.begin());
        };
        for (const TimingCause& cause : how_.causes) {
            ShownCause shown;
            shown.moment = moment_at(cause.at);
            shown.ended = grafwire::joined(cause.ended, ", ");
            for (const std::size_t column : cause.columns) {
                const std::size_t row = row_of(column);
                if (row < rows_.size()) shown.rows.push_back(row);
            }
            for (const TimingCause::Effect& effect : cause.effects) {
                const ShownCause::Effect at{row_of(effect.column), moment_at(effect.at)};
                if (at.row == rows_.size() || at.moment == moments_.size()) continue;
                shown.effects.push_back(at);
            }
            const bool has_beginning = !shown.rows.empty() || !shown.ended.empty();
            if (shown.moment == moments_.size() || !has_beginning || shown.effects.empty()) {
                continue;
            }
            shown.number = static_cast<std::size_t>(std::count_if(
                causes_.begin(), causes_.end(),
                [&](const ShownCause& other) { return other.moment == shown.moment; }));
            causes_.push_back(std::move(shown));
        }
    }

    // -- Where moments stand

    bool has_axis() const { return how_.scale == TimeScale::nanoseconds; }
    std::string time_text(std::size_t moment) const {
        return moment_text(times_[moment], how_.scale, how_.language);
    }

    bool has_ends() const {
        return std::any_of(causes_.begin(), causes_.end(),
                           [](const ShownCause& cause) { return !cause.ended.empty(); });
    }
    /// The delays that end then and have an effect.
    std::string ended_at(std::size_t moment) const {
        for (const ShownCause& cause : causes_) {
            if (cause.moment == moment && !cause.ended.empty()) return cause.ended;
        }
        return {};
    }

    /// `room`: how wide the lines may be.
    void space_moments(double room) {
        if (has_axis()) {
            places_ = place_on_axis(times_, room - arrow_room - unit_room);
            return;
        }
        double step = least_step;
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            step = std::max(step, width_of(plain_text(time_text(i))) + 0.3);
            step = std::max(step, width_of(plain_text(ended_at(i))) + 0.3);
            for (const SignalRow& row : rows_) {
                if (row.is_boxed && row.column) {
                    step = std::max(step, width_of(plain_text(text_at(row, i))) + 0.3);
                }
            }
        }
        places_ = place_moments(times_, step, room);
    }

    // -- Drawing

    void draw(const Strip& strip, double top) {
        const double left = sheet_margin + names_width_ + 0.3;
        const double end = left + strip.end;
        for (std::size_t i = strip.first; i < strip.last; ++i) {
            if (times_[i] >= 0) draw_moment(i, left + places_.x[i], top);
        }
        if (has_axis()) draw_axis(strip, left, top);
        for (const ShownCause& cause : causes_) {
            if (cause.moment >= strip.first && cause.moment < strip.last) {
                draw_cause(cause, strip, left, end, top);
            }
        }
        for (const SignalRow& row : rows_) {
            const double low = top + row.low;
            Pen pen(scene_->shapes,
                    scene_->owners.add(
                        {row.is_other ? "signal other" : "signal", {{"signal", row.name}}, {}}));
            pen.label(plain_text(row.name), {left - 0.3, low - level / 2}, Label::Anchor::end);
            if (row.is_boxed) {
                draw_boxes(pen, row, strip, left, end, low);
            } else {
                pen.line({{left, low}, {end, low}}, Line::Weight::thin);
                draw_levels(pen, row, strip, left, end, low);
            }
            if (row.is_other) draw_marks(pen, *row.column, strip, left, low);
        }
    }

    /// Nanoseconds since the instant, below all lines.
    void draw_axis(const Strip& strip, double left, double top) {
        Pen pen(scene_->shapes, scene_->owners.add({"axis", {}, {}}));
        const double y = top + lines_height_ + 0.1;
        const double tip = left + strip.end + arrow_room;
        pen.line({{left, y}, {tip, y}}, Line::Weight::thin);
        pen.patch({{tip, y}, {tip - 0.2, y - 0.085}, {tip - 0.2, y + 0.085}});
        for (const Time at : ticks_of(places_, strip, times_)) {
            const double x = left + static_cast<double>(at - times_[strip.first]) *
                                        places_.per_nanosecond / nanosecond;
            pen.line({{x, y - 0.1}, {x, y + 0.1}}, Line::Weight::thin);
            pen.label(plain_text(format_nanoseconds(at)), {x, y + 0.4}, Label::Anchor::middle,
                      Label::Role::remark);
        }
        pen.label(plain_text("ns"), {tip + 0.15, y}, Label::Anchor::start, Label::Role::remark);
    }

    /// Its time, and a line through all rows but where that of a cause is.
    void draw_moment(std::size_t moment, double x, double top) {
        Pen pen(scene_->shapes, scene_->owners.add({"moment", {{"time", time_text(moment)}}, {}}));
        const double begin = top + head_room_ - lines_gap;
        const double bottom = top + lines_height_;
        const auto cause = std::find_if(
            causes_.begin(), causes_.end(),
            [&](const ShownCause& item) { return item.moment == moment && item.number == 0; });
        if (cause == causes_.end()) {
            pen.line({{x, begin}, {x, bottom}}, Line::Weight::aid);
        } else {
            const auto [from, to] = reach_of(*cause, top);
            if (from > begin) pen.line({{x, begin}, {x, from}}, Line::Weight::aid);
            pen.line({{x, to}, {x, bottom}}, Line::Weight::aid);
        }
        if (!has_axis()) {
            pen.label(plain_text(time_text(moment)), {x, top + 0.2}, Label::Anchor::middle,
                      Label::Role::remark);
        }
        const std::string ended = ended_at(moment);
        if (ended.empty()) return;
        pen.label(plain_text(ended), {x, top + head_room_ - 0.5}, Label::Anchor::middle,
                  Label::Role::remark);
    }

    /// Where the upright line of a cause begins and ends: at the times where a delay has ended.
    std::pair<double, double> reach_of(const ShownCause& cause, double top) const {
        double from = top + lines_height_;
        double to = top;
        const auto include = [&](std::size_t row, double above, double below) {
            from = std::min(from, top + rows_[row].low - above);
            to = std::max(to, top + rows_[row].low - below);
        };
        for (const std::size_t row : cause.rows) include(row, level / 2, level / 2);
        for (const ShownCause::Effect& effect : cause.effects) {
            if (effect.moment == cause.moment) {
                include(effect.row, 0, level);
            } else {
                include(effect.row, level / 2, level / 2);
            }
        }
        if (!cause.ended.empty()) from = top + head_room_ - lines_gap;
        return {from, to};
    }

    double beside_moment(const ShownCause& cause) const {
        const auto count =
            std::count_if(causes_.begin(), causes_.end(),
                          [&](const ShownCause& other) { return other.moment == cause.moment; });
        const double shift = std::min(cause_pitch, causes_room / static_cast<double>(count));
        return static_cast<double>(cause.number) * shift;
    }

    /// A dot where it begins; the head of an arrow at each effect, beside its row where that
    /// follows at once, else at the later moment.
    void draw_cause(const ShownCause& cause, const Strip& strip, double left, double end,
                    double top) {
        Pen pen(scene_->shapes,
                scene_->owners.add({"cause", {{"time", time_text(cause.moment)}}, {}}));
        const double x = left + places_.x[cause.moment] + beside_moment(cause);
        const auto [from, to] = reach_of(cause, top);
        pen.line({{x, from}, {x, to}}, Line::Weight::dotted);
        for (const std::size_t row : cause.rows)
            pen.dot({x, top + rows_[row].low - level / 2}, 0.07);
        constexpr double length = 0.2;
        constexpr double half = 0.085;
        for (const ShownCause::Effect& effect : cause.effects) {
            const double low = top + rows_[effect.row].low;
            if (effect.moment == cause.moment) {
                const bool is_below = cause.rows.empty() || cause.rows.front() < effect.row;
                const double tip = is_below ? low - level : low;
                const double back = is_below ? tip - length : tip + length;
                pen.patch({{x, tip}, {x - half, back}, {x + half, back}});
                continue;
            }
            const double y = low - level / 2;
            if (effect.moment >= strip.last) {
                pen.line({{x, y}, {end, y}}, Line::Weight::dotted);
                continue;
            }
            const double tip = left + places_.x[effect.moment];
            pen.line({{x, y}, {tip - length, y}}, Line::Weight::dotted);
            pen.patch({{tip, y}, {tip - length, y - half}, {tip - length, y + half}});
        }
    }

    /// `!` where the runs differ.
    void draw_marks(Pen& pen, std::size_t column, const Strip& strip, double left, double low) {
        for (std::size_t i = strip.first; i < strip.last; ++i) {
            if (value(i, column) == value(i, column, true)) continue;
            pen.label(plain_text("!"), {left + places_.x[i] + 0.18, low - level / 2},
                      Label::Anchor::middle, Label::Role::name);
        }
    }

    double x_after(std::size_t moment, const Strip& strip, double left, double end) const {
        return moment + 1 < strip.last ? left + places_.x[moment + 1] : end;
    }

    void draw_levels(Pen& pen, const SignalRow& row, const Strip& strip, double left, double end,
                     double low) {
        std::vector<Point> points;
        const auto put = [&] {
            if (points.size() > 1) pen.line(points, Line::Weight::frame);
            points.clear();
        };
        for (std::size_t i = strip.first; i < strip.last; ++i) {
            const double from = left + places_.x[i];
            const double to = x_after(i, strip, left, end);
            const std::int64_t shown = value(i, *row.column, row.is_other);
            if (shown == Trace::unknown) {
                put();
                pen.grey_rectangle({from, low - level, to, low});
                pen.label(plain_text("x"), {(from + to) / 2, low - level / 2},
                          Label::Anchor::middle, Label::Role::remark);
                continue;
            }
            const double y = shown != 0 ? low - level : low;
            if (points.empty() || points.back().y != y) points.push_back({from, y});
            if (points.size() > 1 && points[points.size() - 2].y == y) points.pop_back();
            points.push_back({to, y});
        }
        put();
    }

    void draw_boxes(Pen& pen, const SignalRow& row, const Strip& strip, double left, double end,
                    double low) {
        for (std::size_t i = strip.first; i < strip.last;) {
            std::string text = text_at(row, i);
            const double from = left + places_.x[i];
            double to = from;
            for (; i < strip.last && text_at(row, i) == text; ++i)
                to = x_after(i, strip, left, end);
            pen.rectangle({from, low - level, to, low});
            // A situation of many steps is cut short; the lines of the steps have it.
            bool is_cut = false;
            while (width_of(plain_text(text + (is_cut ? "…" : ""))) > to - from - 0.1 &&
                   text.size() > 1) {
                do text.pop_back();
                while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U);
                is_cut = true;
            }
            pen.label(plain_text(text + (is_cut ? "…" : "")), {(from + to) / 2, low - level / 2},
                      Label::Anchor::middle);
        }
    }

    void finish(Sheet& sheet, std::size_t number, std::size_t count, double width, double height) {
        namespace say = messages::draw;
        std::string title = how_.title;
        if (count > 1) title += " – " + say::sheet(number + 1, count).in(how_.language);
        Pen pen(sheet.scene.shapes, sheet.scene.owners.add({"title", {}, {}}));
        pen.label(plain_text(std::move(title)), {sheet_margin, sheet_margin + 0.3},
                  Label::Anchor::start, Label::Role::title);
        Bounds bounds = bounds_of(sheet.scene.shapes);
        if (places_.per_nanosecond == 0 && moments_.size() > 1) {
            pen.label(plain_text(say::not_to_scale.in(how_.language)),
                      {sheet_margin, bounds.bottom + 0.5}, Label::Anchor::start,
                      Label::Role::remark);
            bounds = bounds_of(sheet.scene.shapes);
        }
        sheet.width = bounds.right + sheet_margin;
        sheet.height = bounds.bottom + sheet_margin;
        if (count > 1) {
            sheet.width = std::max(sheet.width, width);
            sheet.height = std::max(sheet.height, height);
        }
    }

    const Trace& trace_;
    const TimingDrawing& how_;
    std::vector<SignalRow> rows_;
    std::vector<std::size_t> moments_;  ///< rows of the trace
    std::vector<Time> times_;           ///< of the moments
    MomentPlaces places_;
    double names_width_ = 0;
    std::vector<ShownCause> causes_;
    double head_room_ = 0;     ///< above the lines
    double lines_height_ = 0;  ///< of the lines of a strip
    double height_ = 0;        ///< of a strip
    Scene* scene_ = nullptr;
};

}  // namespace

std::vector<Sheet> draw_timing(const Trace& trace, const TimingDrawing& how) {
    return TimingDiagram(trace, how).make();
}

}  // namespace grafwire
