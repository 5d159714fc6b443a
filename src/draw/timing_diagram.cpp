// Rows of a trace in which nothing changes show nothing: only moments of change have a place. A run
// often waits for seconds between changes that are milliseconds apart; to scale, the changes would
// fall together on paper. So the scale is linear only while the longest interval is at most twenty
// times the shortest, and all of it fits one strip.

#include "draw/timing_diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "draw/messages.h"
#include "draw/moments.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

using Kind = Trace::Column::Kind;

constexpr double pitch = 0.85;      ///< of the lines
constexpr double level = 0.5;       ///< between 0 and 1
constexpr double group_gap = 0.35;  ///< above inputs, steps, outputs, …
constexpr double times_room = 0.7;  ///< above the lines, for the times
constexpr double ends_room = 0.4;   ///< more of it, for the delays that end
constexpr double strip_gap = 0.9;
constexpr double least_step = 1.3;  ///< between two moments
constexpr double tail = 1.3;        ///< behind the last moment
constexpr double widest_ratio = 20;

/// A line of the diagram: a column of the trace, or the situation.
struct SignalRow {
    std::optional<std::size_t> column;
    std::string name;
    bool is_boxed = false;  ///< numbers and situations
    bool begins_group = false;
    bool is_other = false;  ///< of the other run
    double low = 0;         ///< where its 0 is, below the top of a strip
};

/// The moments from number `first` up to `last`, excluded, side by side.
struct Strip {
    std::size_t first = 0;
    std::size_t last = 0;
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

/// A dotted line stands beside that of the cause before it, of one moment.
constexpr double cause_pitch = 0.12;

class TimingDiagram {
  public:
    TimingDiagram(const Trace& trace, const TimingDrawing& how) : trace_(trace), how_(how) {
        choose_rows();
        moments_ = moments_of(trace, how.other);
        for (const SignalRow& row : rows_) {
            names_width_ = std::max(names_width_, width_of(plain_text(row.name)));
        }
        find_causes();
        height_ = head_room_ + 0.2;
        for (SignalRow& row : rows_) {
            height_ += pitch + (row.begins_group ? group_gap : 0);
            row.low = height_ - 0.2 - (pitch - level) / 2;
        }
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
        if (strips_.empty()) sheets.emplace_back();  // a run without an instant
        for (const Strip& strip : strips_) {
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
            const auto found = std::find_if(moments_.begin(), moments_.end(), [&](std::size_t row) {
                return trace_.times[row] == at;
            });
            return static_cast<std::size_t>(found - moments_.begin());
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
            shown.ended = fmt::format("{}", fmt::join(cause.ended, ", "));
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
            if (!shown.ended.empty()) head_room_ = times_room + ends_room;
            shown.number = static_cast<std::size_t>(std::count_if(
                causes_.begin(), causes_.end(),
                [&](const ShownCause& other) { return other.moment == shown.moment; }));
            causes_.push_back(std::move(shown));
        }
    }

    // -- Where moments stand

    Time time_of(std::size_t moment) const { return trace_.times[moments_[moment]]; }
    std::string time_text(std::size_t moment) const {
        return shown_duration(time_of(moment)).in(how_.language);
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
        if (is_linear(step, room)) {
            strips_.push_back({0, moments_.size()});
            return;
        }
        const auto per_strip = static_cast<std::size_t>(std::max(1.0, (room - tail) / step + 1));
        for (std::size_t first = 0; first < moments_.size(); first += per_strip) {
            const std::size_t last = std::min(first + per_strip, moments_.size());
            strips_.push_back({first, last});
            for (std::size_t i = first; i < last; ++i) {
                x_.push_back(static_cast<double>(i - first) * step);
            }
        }
    }

    /// Whether time is to scale; then the places are entered.
    bool is_linear(double step, double room) {
        if (moments_.size() < 2) return false;
        Time shortest = never;
        Time longest = 0;
        for (std::size_t i = 1; i < moments_.size(); ++i) {
            shortest = std::min(shortest, time_of(i) - time_of(i - 1));
            longest = std::max(longest, time_of(i) - time_of(i - 1));
        }
        if (shortest <= 0) return false;
        const double scale = step / static_cast<double>(shortest);
        const auto whole = static_cast<double>(time_of(moments_.size() - 1) - time_of(0)) * scale;
        if (static_cast<double>(longest) > widest_ratio * static_cast<double>(shortest))
            return false;
        if (whole + tail > room) return false;
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            x_.push_back(static_cast<double>(time_of(i) - time_of(0)) * scale);
        }
        is_to_scale_ = true;
        return true;
    }

    // -- Drawing

    void draw(const Strip& strip, double top) {
        const double left = sheet_margin + names_width_ + 0.3;
        const double end = left + x_[strip.last - 1] + tail;
        for (std::size_t i = strip.first; i < strip.last; ++i) draw_moment(i, left + x_[i], top);
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

    /// Its time, and a line through all rows but where that of a cause is.
    void draw_moment(std::size_t moment, double x, double top) {
        Pen pen(scene_->shapes, scene_->owners.add({"moment", {{"time", time_text(moment)}}, {}}));
        const double begin = top + head_room_ - times_room + 0.45;
        const double bottom = top + height_;
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
        pen.label(plain_text(time_text(moment)), {x, top + 0.2}, Label::Anchor::middle,
                  Label::Role::remark);
        const std::string ended = ended_at(moment);
        if (ended.empty()) return;
        pen.label(plain_text(ended), {x, top + 0.2 + ends_room}, Label::Anchor::middle,
                  Label::Role::remark);
    }

    /// Where the upright line of a cause begins and ends: at the times where a delay has ended.
    std::pair<double, double> reach_of(const ShownCause& cause, double top) const {
        double from = top + height_;
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
        if (!cause.ended.empty()) from = top + head_room_ - times_room + 0.45;
        return {from, to};
    }

    /// A dot where it begins; the head of an arrow at each effect, beside its row where that
    /// follows at once, else at the later moment.
    void draw_cause(const ShownCause& cause, const Strip& strip, double left, double end,
                    double top) {
        Pen pen(scene_->shapes,
                scene_->owners.add({"cause", {{"time", time_text(cause.moment)}}, {}}));
        const double x = left + x_[cause.moment] + static_cast<double>(cause.number) * cause_pitch;
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
            const double tip = left + x_[effect.moment];
            pen.line({{x, y}, {tip - length, y}}, Line::Weight::dotted);
            pen.patch({{tip, y}, {tip - length, y - half}, {tip - length, y + half}});
        }
    }

    /// `!` where the runs differ.
    void draw_marks(Pen& pen, std::size_t column, const Strip& strip, double left, double low) {
        for (std::size_t i = strip.first; i < strip.last; ++i) {
            if (value(i, column) == value(i, column, true)) continue;
            pen.label(plain_text("!"), {left + x_[i] + 0.18, low - level / 2},
                      Label::Anchor::middle, Label::Role::name);
        }
    }

    double x_after(std::size_t moment, const Strip& strip, double left, double end) const {
        return moment + 1 < strip.last ? left + x_[moment + 1] : end;
    }

    void draw_levels(Pen& pen, const SignalRow& row, const Strip& strip, double left, double end,
                     double low) {
        std::vector<Point> points;
        const auto put = [&] {
            if (points.size() > 1) pen.line(points, Line::Weight::frame);
            points.clear();
        };
        for (std::size_t i = strip.first; i < strip.last; ++i) {
            const double from = left + x_[i];
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
            const double from = left + x_[i];
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
        if (!is_to_scale_ && moments_.size() > 1) {
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
    std::vector<double> x_;             ///< by moment, from the beginning of its strip
    std::vector<Strip> strips_;
    bool is_to_scale_ = false;
    double names_width_ = 0;
    std::vector<ShownCause> causes_;
    double head_room_ = times_room;
    double height_ = 0;  ///< of a strip
    Scene* scene_ = nullptr;
};

}  // namespace

std::vector<Sheet> draw_timing(const Trace& trace, const TimingDrawing& how) {
    return TimingDiagram(trace, how).make();
}

}  // namespace grafwire
