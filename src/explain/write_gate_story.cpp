// In the words of the story of the reference (src/story), where both have the same to say; the
// sentences about gates are those of the catalogue of this folder.

#include "explain/write_gate_story.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "explain/messages.h"
#include "grafcet/write_grafcet.h"
#include "story/messages.h"
#include "text/joined.h"
#include "text/time.h"

namespace grafwire {

namespace {

namespace words = messages::explain;
namespace story_words = messages::story;

constexpr std::size_t most_named = 12;  ///< nets that are named

class GateStoryWriter {
  public:
    GateStoryWriter(const Grafcet& grafcet, const Netlist& netlist, Language language)
        : grafcet_(grafcet), netlist_(netlist), language_(language) {}

    void tell(const GateStory& story);
    std::string take() { return std::move(text_); }

  private:
    void tell_beginning(const GateStory& story);
    void tell_change(const GateChange& change);
    void tell_end(const GateStory& story);
    std::string way_of(const GateChange& change) const;
    std::string shown(const GateLink& link) const;
    std::string oscillating(const std::vector<NetId>& nets) const;

    static std::string list(const std::vector<std::string>& names) { return joined(names, ", "); }
    template <class... Arguments>
    void say(const Message<Arguments...>& message,
             const std::type_identity_t<Arguments>&... arguments) {
        text_ += "  " + message.in(language_, arguments...);
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    Language language_;
    std::string text_;
};

void GateStoryWriter::tell(const GateStory& story) {
    if (!text_.empty()) text_ += '\n';
    if (story.repeated > 0) {
        text_ += story_words::nothing_changes_until.in(language_, format_milliseconds(story.at),
                                                       format_milliseconds(story.last),
                                                       story.repeated + 1);
        return;
    }
    tell_beginning(story);
    if (story.is_quiet) return;
    for (const GateChange& change : story.changes) tell_change(change);
    if (story.untold > 0) text_ += "  " + words::more_changes.in(language_, story.untold);
    if (story.oscillating.empty()) {
        tell_end(story);
    } else {
        say(words::nets_keep_changing, oscillating(story.oscillating));
    }
}

void GateStoryWriter::tell_beginning(const GateStory& story) {
    std::vector<std::string> parts;
    std::vector<std::string> inputs;
    for (const Stimuli::Assignment& set : story.inputs) {
        inputs.push_back(fmt::format("{}={}", quoted_where_needed(input_name(grafcet_, set.input)),
                                     set.value ? 1 : 0));
    }
    if (!inputs.empty()) parts.push_back(joined(inputs, " "));
    for (const std::string& condition : story.ended) {
        parts.push_back(story_words::delay_is_over.in(language_, condition));
    }
    if (parts.empty()) {
        const Message<>& nothing = story.is_quiet   ? story_words::nothing_changes
                                   : story.is_first ? story_words::all_inputs_0
                                                    : story_words::no_input_changes;
        parts.push_back(nothing.in(language_));
    }
    const std::string separator = story_words::separator.in(language_);
    text_ += story_words::at.in(language_, format_milliseconds(story.at), joined(parts, separator));
}

void GateStoryWriter::tell_change(const GateChange& change) {
    say(change.value == Logic::one    ? words::becomes_1_by
        : change.value == Logic::zero ? words::becomes_0_by
                                      : words::becomes_undefined_by,
        change.name, format_nanoseconds(change.after), way_of(change));
}

std::string GateStoryWriter::way_of(const GateChange& change) const {
    if (change.way.empty()) return words::by_itself.in(language_);
    std::vector<std::string> links;
    for (const GateLink& link : change.way) links.push_back(shown(link));
    if (change.left_out > 0) links.insert(links.begin() + 1, "…");
    return list(links);
}

/// Of an input and of what has a line of its own, the value is enough.
std::string GateStoryWriter::shown(const GateLink& link) const {
    const std::string name(netlist_.names[link.net]);
    const char value = digit_of(link.value);
    if (link.cell == no_cell || link.is_target) return fmt::format("{}={}", name, value);
    const CellTypeRow& type = row_of(netlist_.cells[link.cell].type);
    return words::gate_on_the_way.in(language_, type.description(), name, value,
                                     format_nanoseconds(link.after));
}

void GateStoryWriter::tell_end(const GateStory& story) {
    const std::string situation =
        story.active.empty() ? story_words::no_step.in(language_) : list(story.active);
    if (story.by_scans) {
        say(story_words::situation, situation);
    } else if (story.settled_after == 0) {
        say(story_words::stable_situation, situation);
    } else {
        say(words::stable_after, format_nanoseconds(story.settled_after), situation);
    }
    if (!grafcet_.outputs.empty()) {
        say(story_words::outputs,
            story.outputs.empty() ? story_words::no_output.in(language_) : list(story.outputs));
    }
    if (!story.undefined.empty()) say(words::are_undefined, list(story.undefined));
}

std::string GateStoryWriter::oscillating(const std::vector<NetId>& nets) const {
    std::vector<std::string> names;
    for (const NetId net : nets) {
        if (names.size() == most_named) {
            names.emplace_back("…");
            break;
        }
        names.emplace_back(netlist_.names[net]);
    }
    return list(names);
}

}  // namespace

std::string write_gate_stories(const Grafcet& grafcet, const Netlist& netlist,
                               const std::vector<GateStory>& stories, Language language) {
    GateStoryWriter writer(grafcet, netlist, language);
    for (const GateStory& story : stories) writer.tell(story);
    return writer.take();
}

}  // namespace grafwire
