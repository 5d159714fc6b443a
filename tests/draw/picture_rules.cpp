#include "draw/picture_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace grafwire::testing {

namespace {

constexpr double half_pixel = 0.5;

std::string transition_name(const Transition& transition) {
    return '(' + transition.name + ')';
}

/// The name under which a step stands in the block of a transition: its own, or that of the
/// macro-step whose entry or exit it is.
std::string name_in_block(const Grafcet& grafcet, StepId step, BlockId block, bool by_entry) {
    if (grafcet.steps[step].block == block) return grafcet.steps[step].name;
    for (const Macro& macro : grafcet.macros) {
        if (macro.block == block && (by_entry ? macro.entry : macro.exit) == step) {
            return macro.name;
        }
    }
    return "?";
}

struct ChartLink {
    std::string from, to;
    auto operator<=>(const ChartLink&) const = default;
};

std::vector<ChartLink> links_of(const Grafcet& grafcet) {
    std::vector<ChartLink> links;
    for (const Transition& transition : grafcet.transitions) {
        const std::string name = transition_name(transition);
        for (const StepId step : grafcet.preceding(transition)) {
            links.push_back({name_in_block(grafcet, step, transition.block, false), name});
        }
        for (const StepId step : grafcet.following(transition)) {
            links.push_back({name, name_in_block(grafcet, step, transition.block, true)});
        }
    }
    return links;
}

const PictureGroup* step_named(const Picture& picture, const std::string& name) {
    const PictureGroup* step = picture.only("step", "step", name);
    return step != nullptr ? step : picture.only("macro-step", "macro", name);
}

bool is_link(const PictureGroup& group) {
    static const std::set<std::string> kinds = {"link", "cut", "divergence", "convergence"};
    return kinds.contains(group.kind);
}

/// The bar of a transition: its only heavy line.
const Stroke& bar_of(const PictureGroup& transition) {
    return *std::find_if(transition.strokes.begin(), transition.strokes.end(),
                         [](const Stroke& stroke) { return stroke.is_heavy; });
}

double x_of_bar(const PictureGroup& transition) {
    return (bar_of(transition).x1 + bar_of(transition).x2) / 2;
}

Area widened(Area area, double by) {
    return {area.left - by, area.top - by, area.right + by, area.bottom + by};
}

}  // namespace

std::string told(const Faults& faults) {
    return fmt::format("{}", fmt::join(faults, "\n"));
}

Faults missing_parts(const Grafcet& grafcet, const Picture& picture) {
    Faults faults;
    const auto expect = [&](const std::string& kind, const std::string& name) {
        if (picture.only(kind, kind == "macro-step" ? "macro" : kind, name) == nullptr) {
            faults.push_back(fmt::format("{} {} is not there once", kind, name));
        }
    };
    for (const Step& step : grafcet.steps) expect("step", step.name);
    for (const Macro& macro : grafcet.macros) expect("macro-step", macro.name);
    for (const Transition& transition : grafcet.transitions) {
        expect("transition", transition_name(transition));
    }
    const auto count = [&](const std::string& kind, std::size_t expected) {
        const std::size_t there = picture.all(kind).size();
        if (there != expected) {
            faults.push_back(fmt::format("{} of kind {} rather than {}", there, kind, expected));
        }
    };
    count("step", grafcet.steps.size());
    count("macro-step", grafcet.macros.size());
    count("transition", grafcet.transitions.size());
    count("action", grafcet.actions.size() + grafcet.clearing_actions.size());
    return faults;
}

Faults missing_links(const Grafcet& grafcet, const Picture& picture) {
    std::set<ChartLink> drawn;
    for (const PictureGroup& group : picture.groups) {
        if (is_link(group)) drawn.insert({group.fact("from"), group.fact("to")});
    }
    Faults faults;
    for (const ChartLink& link : links_of(grafcet)) {
        if (!drawn.contains(link)) {
            faults.push_back(fmt::format("no link from {} to {}", link.from, link.to));
        }
    }
    return faults;
}

Faults crowded_texts(const Picture& picture) {
    struct Item {
        Area area;
        const PictureGroup* group;
        std::string name;
    };
    std::vector<Item> texts;
    std::vector<Item> others;
    Faults faults;
    for (const PictureGroup& group : picture.groups) {
        for (std::size_t i = 0; i < group.texts.size(); ++i) {
            texts.push_back({group.texts[i], &group, "'" + group.words[i] + "'"});
        }
        for (const Stroke& stroke : group.strokes) {
            // An oblique line, in short pieces.
            const int pieces = stroke.is_level() || stroke.is_upright() ? 1 : 20;
            for (int i = 0; i < pieces; ++i) {
                const auto at = [&](double from, double to, int n) {
                    return from + (to - from) * n / pieces;
                };
                const Stroke piece{at(stroke.x1, stroke.x2, i), at(stroke.y1, stroke.y2, i),
                                   at(stroke.x1, stroke.x2, i + 1),
                                   at(stroke.y1, stroke.y2, i + 1)};
                others.push_back({widened(piece.area(), 0.8), &group, "a line of " + group.kind});
            }
        }
        for (const Area& mark : group.marks) {
            others.push_back({mark, &group, "a mark of " + group.kind});
        }
        // Frames hold texts of their own group only.
        for (const Area& box : group.boxes)
            others.push_back({box, &group, "a box of " + group.kind});
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const Item& text = texts[i];
        const Area& area = text.area;
        if (area.left < 0 || area.top < 0 || area.right > picture.width ||
            area.bottom > picture.height) {
            faults.push_back(text.name + " is outside");
        }
        for (std::size_t j = i + 1; j < texts.size(); ++j) {
            if (overlap(area, texts[j].area)) {
                faults.push_back(text.name + " lies on " + texts[j].name);
            }
        }
        for (const Item& other : others) {
            if (other.group != text.group && overlap(area, other.area)) {
                faults.push_back(text.name + " lies on " + other.name);
            }
        }
    }
    return faults;
}

Faults wrong_steps(const Grafcet& grafcet, const Picture& picture) {
    Faults faults;
    for (const Step& step : grafcet.steps) {
        const PictureGroup* drawn = picture.only("step", "step", step.name);
        if (drawn == nullptr) continue;
        const Area& frame = drawn->boxes.front();
        if (std::abs(frame.height() - 40) > half_pixel ||
            frame.right - frame.left < 40 - half_pixel) {
            faults.push_back(fmt::format("step {} is no square", step.name));
        }
        if (drawn->boxes.size() != (step.initial ? 2U : 1U)) {
            faults.push_back(fmt::format("step {} has {} squares", step.name, drawn->boxes.size()));
        }
    }
    for (const PictureGroup* link : picture.all("action-link")) {
        const std::string name = link->fact("step");
        const PictureGroup* step = name.empty() ? nullptr : picture.only("step", "step", name);
        if (step == nullptr) continue;
        const Area& frame = step->boxes.front();
        const Stroke& first = link->strokes.front();
        if (std::abs(first.y1 - (frame.top + frame.bottom) / 2) > half_pixel ||
            std::abs(first.x1 - frame.right) > half_pixel || first.x2 <= first.x1) {
            faults.push_back(fmt::format("the action of step {} is not level with it", name));
        }
    }
    return faults;
}

Faults wrong_bars(const Grafcet& grafcet, const Picture& picture) {
    Faults faults;
    for (const Transition& transition : grafcet.transitions) {
        const std::string name = transition_name(transition);
        const PictureGroup* drawn = picture.only("transition", "transition", name);
        if (drawn == nullptr) continue;
        const Stroke& bar = bar_of(*drawn);
        const double middle = x_of_bar(*drawn);
        if (!bar.is_level() || drawn->texts.front().right > bar.x1) {
            faults.push_back(fmt::format("the name of {} is not left of its bar", name));
        }
        for (std::size_t i = 1; i < drawn->texts.size(); ++i) {
            if (drawn->texts[i].left < bar.x2) {
                faults.push_back(fmt::format("the condition of {} is not right of it", name));
            }
        }
        if (grafcet.preceding(transition).size() != 1 ||
            grafcet.following(transition).size() != 1) {
            continue;
        }
        const std::string before =
            name_in_block(grafcet, grafcet.preceding(transition)[0], transition.block, false);
        const std::string after =
            name_in_block(grafcet, grafcet.following(transition)[0], transition.block, true);
        const PictureGroup* above = step_named(picture, before);
        const PictureGroup* below = step_named(picture, after);
        if (above == nullptr || below == nullptr) continue;
        const Area& from = above->boxes.front();
        const Area& to = below->boxes.front();
        const bool is_straight = std::abs(from.middle() - middle) < half_pixel &&
                                 std::abs(to.middle() - middle) < half_pixel;
        // Where the link is plain on both sides: no other link begins or ends between them.
        const auto plain = [&](const std::string& a, const std::string& b) {
            for (const PictureGroup* link : picture.all("link")) {
                if (link->fact("from") == a && link->fact("to") == b) {
                    return link->strokes.size() == 1;
                }
            }
            return false;
        };
        bool has_lines = false;
        for (const PictureGroup* link : picture.all("link")) {
            // The branches beside it are longer, and so is the link.
            has_lines = has_lines || (link->fact("from").empty() && link->fact("to") == after);
        }
        for (const char* kind : {"divergence", "convergence"}) {
            for (const PictureGroup* line : picture.all(kind)) {
                has_lines = has_lines || line->fact("from") == before || line->fact("to") == after;
            }
        }
        if (!is_straight || has_lines || !plain(before, name) || !plain(name, after)) continue;
        const double midway = (from.bottom + to.top) / 2;
        if (std::abs(midway - bar.y1) > 1) {
            faults.push_back(fmt::format("the bar of {} is not midway", name));
        }
    }
    return faults;
}

Faults uneven_branches(const Grafcet& grafcet, const Picture& picture) {
    std::map<std::string, int> entered;  // how many links lead to a node
    for (const ChartLink& link : links_of(grafcet)) ++entered[link.to];
    std::map<std::string, std::set<int>> bars_below;
    std::map<std::string, std::set<int>> steps_below;
    for (const PictureGroup* line : picture.all("divergence")) {
        const std::string from = line->fact("from");
        for (const PictureGroup* link : picture.all("link")) {
            const std::string to = link->fact("to");
            // Where several come together may stand further down.
            if (link->is("up") || link->fact("from") != from || entered[to] != 1) continue;
            if (const PictureGroup* bar = picture.only("transition", "transition", to)) {
                bars_below[from].insert(static_cast<int>(std::lround(bar_of(*bar).y1)));
            } else if (const PictureGroup* step = step_named(picture, to)) {
                steps_below[from].insert(static_cast<int>(std::lround(step->boxes.front().top)));
            }
        }
    }
    Faults faults;
    for (const auto& [from, heights] : bars_below) {
        if (heights.size() > 1) faults.push_back("bars below " + from + " stand at two heights");
    }
    for (const auto& [from, heights] : steps_below) {
        if (heights.size() > 1) faults.push_back("steps below " + from + " stand at two heights");
    }
    return faults;
}

Faults wrong_double_lines(const Picture& picture) {
    Faults faults;
    for (const PictureGroup& group : picture.groups) {
        if (!group.is("and")) continue;
        const bool is_right = group.strokes.size() == 2 && group.strokes[0].is_level() &&
                              group.strokes[1].is_level() &&
                              group.strokes[0].x1 == group.strokes[1].x1 &&
                              group.strokes[0].x2 == group.strokes[1].x2 &&
                              std::abs(group.strokes[1].y1 - group.strokes[0].y1 - 4) < half_pixel;
        if (!is_right) faults.push_back("a double line is not two parallels");
    }
    return faults;
}

Faults wrong_links(const Picture& picture) {
    Faults faults;
    for (const PictureGroup& group : picture.groups) {
        if (!is_link(group)) continue;
        const std::string name =
            fmt::format("{} from {} to {}", group.kind, group.fact("from"), group.fact("to"));
        for (const Stroke& stroke : group.strokes) {
            if (!stroke.is_level() && !stroke.is_upright()) faults.push_back(name + " is oblique");
        }
        if (group.is("up")) {
            // One that ends in another link goes on with its arrow.
            if (group.strokes.size() > 1 && group.marks.size() != 1) {
                faults.push_back(name + " has no arrow");
            }
        } else if (group.kind == "link" && !group.marks.empty()) {
            faults.push_back(name + " has an arrow");
        }
        if (group.kind == "link" && !group.is("up")) {
            for (const Stroke& stroke : group.strokes) {
                if (stroke.y2 < stroke.y1) faults.push_back(name + " leads up");
            }
        }
    }
    return faults;
}

Faults links_through_parts(const Picture& picture) {
    Faults faults;
    for (const PictureGroup& part : picture.groups) {
        const bool is_part =
            part.kind == "step" || part.kind == "macro-step" || part.kind == "action";
        if (!is_part) continue;
        for (const Area& box : part.boxes) {
            for (const PictureGroup& group : picture.groups) {
                if (!is_link(group)) continue;
                for (const Stroke& stroke : group.strokes) {
                    if (overlap(widened(stroke.area(), 0.6), widened(box, -1), 0)) {
                        faults.push_back(fmt::format("a {} from {} to {} passes through {} {}",
                                                     group.kind, group.fact("from"),
                                                     group.fact("to"), part.kind,
                                                     part.words.empty() ? "" : part.words[0]));
                    }
                }
            }
        }
    }
    return faults;
}

std::size_t crossings(const Picture& picture) {
    std::size_t count = 0;
    const auto crosses = [](const Stroke& a, const Stroke& b) {
        if (!a.is_level() || !b.is_upright()) return false;
        const Area level = a.area();
        const Area upright = b.area();
        return upright.left > level.left + 1 && upright.left < level.right - 1 &&
               level.top > upright.top + 1 && level.top < upright.bottom - 1;
    };
    for (const PictureGroup& a : picture.groups) {
        if (!is_link(a)) continue;
        for (const PictureGroup& b : picture.groups) {
            if (!is_link(b) || &a == &b) continue;
            for (const Stroke& level : a.strokes) {
                for (const Stroke& upright : b.strokes) count += crosses(level, upright) ? 1 : 0;
            }
        }
    }
    return count;
}

Faults all_faults(const Grafcet& grafcet, const Picture& picture) {
    Faults all;
    const auto add = [&](const Faults& faults) {
        all.insert(all.end(), faults.begin(), faults.end());
    };
    add(missing_parts(grafcet, picture));
    add(missing_links(grafcet, picture));
    add(crowded_texts(picture));
    add(wrong_steps(grafcet, picture));
    add(wrong_bars(grafcet, picture));
    add(uneven_branches(grafcet, picture));
    add(wrong_double_lines(picture));
    add(wrong_links(picture));
    add(links_through_parts(picture));
    return all;
}

}  // namespace grafwire::testing
