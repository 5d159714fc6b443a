// BLIF after "Berkeley Logic Interchange Format (BLIF)", University of California, Berkeley, 1992,
// with the `.param`, `.attr`, `.cname` and `.blackbox` lines of Yosys and ABC.
//
// The format goes line by line, but what belongs together does not: the rows of a cover follow its
// `.names`, and the parameters of a black box its `.subckt`. So the reader keeps the cover or the
// box that is open, and closes it at the next line that cannot belong to it. Outputs are told to
// the netlist at the end, when all nets are known.

#include "formats/blif/read_blif.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "formats/blif/blif_lines.h"
#include "formats/shared/cover.h"
#include "formats/shared/helper_cells.h"
#include "formats/shared/messages.h"
#include "formats/shared/net_spelling.h"
#include "formats/shared/netlist_assembly.h"
#include "text/time.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::formats;

using Words = std::vector<BlifWord>;

/// A black box whose `.attr` or `.param` lines may still follow.
struct OpenBox {
    CellType type = CellType::latch;
    NetId output = no_net;
    std::vector<NetId> pins;
    CellDetails details;
    Location where;
};

/// The netlist, line by line.
class BlifReader {
  public:
    BlifReader(const SourceFile& source, Diagnostics& diagnostics)
        : lines_(source.text), diagnostics_(diagnostics), assembly_(diagnostics) {}

    std::optional<Netlist> read();

  private:
    void read_line(const Words& words);
    void read_directive(const Words& words);
    void read_model(const Words& words);
    void read_outputs(const Words& words);
    void read_names(const Words& words);
    void read_row(const Words& words);
    void read_latch(const Words& words);
    void add_latch(const Words& words, std::string_view kind, const BlifWord* control,
                   Logic initial);
    void read_black_box(const Words& words);
    void read_parameter(const Words& words);
    void read_initial_value(const Words& words);
    void close();
    void refuse(Location where, Localized message) {
        diagnostics_.error(code::bad_netlist, where, std::move(message));
    }
    NetId net(const BlifWord& word) {
        return assembly_.net(percent_decoded(word.text), word.where);
    }

    BlifLines lines_;
    Diagnostics& diagnostics_;
    NetlistAssembly assembly_;
    std::string model_;
    int model_count_ = 0;
    bool complained_of_models_ = false;
    // The cover that is open, if one is.
    bool in_names_ = false;
    Cover cover_;
    NetId cover_output_ = no_net;
    Location cover_where_;
    std::optional<OpenBox> box_;  ///< that is open
    std::vector<Words> outputs_;
    std::vector<std::pair<NetId, bool>> initial_values_;
};

std::optional<Netlist> BlifReader::read() {
    Words words;
    while (lines_.next(words)) read_line(words);
    close();
    if (model_count_ == 0) refuse({}, say::no_model());
    for (const Words& line : outputs_) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            assembly_.add_output(percent_decoded(line[i].text), net(line[i]), line[i].where);
        }
    }
    for (const auto& [id, value] : initial_values_) assembly_.set_initial(id, value);
    return assembly_.finish(std::move(model_));
}

/// Of several models the first is the netlist; others may only declare black boxes.
void BlifReader::read_line(const Words& words) {
    const std::string_view first = words[0].text;
    if (first.starts_with("#@")) {
        if (model_count_ == 1) read_initial_value(words);
        return;
    }
    if (first == ".model") return read_model(words);
    if (model_count_ == 0) {
        if (!first.starts_with('.')) {
            return refuse(words[0].where, say::expected_model());
        }
        model_count_ = 1;  // BLIF allows the first .model to be left out
    }
    if (model_count_ == 1) {
        if (first.starts_with('.')) return read_directive(words);
        if (in_names_) return read_row(words);
        return refuse(words[0].where, say::no_command(shortened(first)));
    }
    const bool is_cell =
        first == ".names" || first == ".latch" || first == ".subckt" || first == ".gate";
    if (is_cell && !complained_of_models_) {
        complained_of_models_ = true;
        refuse(words[0].where, say::second_model());
    }
}

void BlifReader::read_model(const Words& words) {
    close();
    if (++model_count_ != 1) return;
    model_ = words.size() > 1 ? percent_decoded(words[1].text) : "netlist";
    assembly_.check_name(model_, words.back().where);
}

/// Adds the cover or the box that is open.
void BlifReader::close() {
    if (in_names_) add_cover(assembly_, cover_, cover_output_, cover_where_);
    in_names_ = false;
    if (box_) assembly_.add_cell(box_->type, box_->output, box_->pins, box_->where, box_->details);
    box_.reset();
}

void BlifReader::read_directive(const Words& words) {
    const std::string_view name = words[0].text;
    if (name == ".param" || name == ".attr") return read_parameter(words);
    if (name == ".cname") return;
    close();
    if (name == ".inputs" || name == ".clock") {
        for (std::size_t i = 1; i < words.size(); ++i) {
            // The clock may also stand among the inputs.
            if (name == ".clock" && assembly_.is_input(percent_decoded(words[i].text))) continue;
            assembly_.add_input(percent_decoded(words[i].text), net(words[i]), words[i].where);
        }
    } else if (name == ".outputs") {
        outputs_.push_back(words);
    } else if (name == ".names") {
        read_names(words);
    } else if (name == ".latch") {
        read_latch(words);
    } else if (name == ".subckt") {
        read_black_box(words);
    } else if (name == ".gate" || name == ".mlatch") {
        refuse(words[0].where, say::library_cell(shortened(words.size() > 1 ? words[1].text : "")));
    } else if (name != ".end" && name != ".area" && name != ".delay" &&
               name.find("_load") == std::string_view::npos &&
               name.find("_drive") == std::string_view::npos &&
               name.find("_arrival") == std::string_view::npos &&
               name.find("_required") == std::string_view::npos) {
        refuse(words[0].where, say::not_supported(shortened(name)));
    }
}

/// Opens a cover.
void BlifReader::read_names(const Words& words) {
    if (words.size() < 2) return refuse(words[0].where, say::names_without_output());
    in_names_ = true;
    cover_ = {};
    cover_where_ = words[0].where;
    for (std::size_t i = 1; i + 1 < words.size(); ++i) cover_.inputs.push_back(net(words[i]));
    cover_output_ = net(words.back());
}

/// `1-0 1`; of a constant only the last digit.
void BlifReader::read_row(const Words& words) {
    const std::size_t width = cover_.inputs.size();
    const std::string_view plane = width == 0 ? std::string_view() : words[0].text;
    const std::string_view value = words.back().text;
    const bool is_plane =
        plane.size() == width && plane.find_first_not_of("01-") == std::string_view::npos;
    if (words.size() != (width == 0 ? 1U : 2U) || !is_plane || (value != "0" && value != "1")) {
        return refuse(words[0].where, say::expected_row(width));
    }
    if (!cover_.rows.empty() && cover_.value != (value == "1")) {
        return refuse(words.back().where, say::rows_differ());
    }
    cover_.value = value == "1";
    cover_.rows.emplace_back(plane);
}

void BlifReader::read_latch(const Words& words) {
    // .latch input output [type control] [initial]
    std::size_t count = words.size();
    if (count < 3 || count > 6) {
        return refuse(words[0].where, say::expected_latch());
    }
    Logic initial = Logic::unknown;
    if (count == 4 || count == 6) {
        const std::string_view digit = words[--count].text;
        if (digit.size() != 1 || digit[0] < '0' || digit[0] > '3') {
            return refuse(words[count].where, say::latch_initial_value());
        }
        if (digit == "0") initial = Logic::zero;
        if (digit == "1") initial = Logic::one;
    }
    if (count == 3) return add_latch(words, "re", nullptr, initial);
    add_latch(words, words[3].text, &words[4], initial);
}

/// `re` is a flip-flop, `ah` a latch that is transparent while its control is 1.
void BlifReader::add_latch(const Words& words, std::string_view kind, const BlifWord* control,
                           Logic initial) {
    if (kind != "re" && kind != "ah") {
        return refuse(words[3].where, say::latch_type(shortened(kind)));
    }
    NetId control_net = no_net;
    if (control != nullptr && control->text != "NIL") {
        control_net = net(*control);
    } else {
        if (!assembly_.is_input("clk")) {
            assembly_.add_input("clk", assembly_.net("clk", words[0].where), words[0].where);
        }
        control_net = assembly_.net("clk", words[0].where);
    }
    const std::array<NetId, 2> pins{net(words[1]), control_net};
    assembly_.add_cell(kind == "re" ? CellType::flip_flop : CellType::hold_latch, net(words[2]),
                       pins, words[0].where, {initial, {}});
}

/// `.subckt grafwire_timer a=X1 q=t` opens a box; all pins must be connected.
void BlifReader::read_black_box(const Words& words) {
    if (words.size() < 2) return refuse(words[0].where, say::subcircuit_without_model());
    const std::optional<CellType> type = helper_type_named(words[1].text);
    if (!type) {
        return refuse(words[1].where, say::unknown_subcircuit(shortened(words[1].text)));
    }
    OpenBox box{
        *type, no_net, std::vector<NetId>(row_of(*type).min_pins, no_net), {}, words[0].where};
    const auto names = helper_pins(*type);
    for (std::size_t i = 2; i < words.size(); ++i) {
        const std::size_t equals = words[i].text.find('=');
        const std::string_view formal = words[i].text.substr(0, equals);
        const auto pin = std::find(names.begin(), names.end(), formal);
        const bool is_output = formal == "q";
        if (equals == std::string_view::npos || (!is_output && pin == names.end())) {
            return refuse(words[i].where, say::no_connection(shortened(words[i].text),
                                                             row_of(*type).description()));
        }
        const NetId actual = net({words[i].text.substr(equals + 1), words[i].where});
        (is_output ? box.output : box.pins[static_cast<std::size_t>(pin - names.begin())]) = actual;
    }
    if (box.output == no_net ||
        std::find(box.pins.begin(), box.pins.end(), no_net) != box.pins.end()) {
        return refuse(words[0].where, say::connection_missing(row_of(*type).description()));
    }
    box_ = std::move(box);
}

/// Says more about the cell before; only black boxes have something to say that matters.
void BlifReader::read_parameter(const Words& words) {
    const std::string_view name = words.size() > 1 ? words[1].text : std::string_view();
    const auto known = helper_parameter_names();
    if (!box_ || std::find(known.begin(), known.end(), name) == known.end()) return;
    std::string_view value = words.size() == 3 ? words[2].text : std::string_view();
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
        value = value.substr(1, value.size() - 2);
    }
    if (!set_helper_parameter(box_->details.initial, box_->details.timing, name, value)) {
        refuse(words[0].where, say::parameter_does_not_fit(name));
    }
}

/// `#@initially NET 0`: a comment to others, the initial value of a net to us.
void BlifReader::read_initial_value(const Words& words) {
    if (words[0].text != "#@initially" || words.size() != 3) return;
    if (words[2].text != "0" && words[2].text != "1") return;
    initial_values_.emplace_back(net(words[1]), words[2].text == "1");
}

}  // namespace

std::optional<Netlist> read_blif(const SourceFile& source, Diagnostics& diagnostics) {
    if (!check_utf8(source.text, diagnostics)) return std::nullopt;
    return BlifReader(source, diagnostics).read();
}

}  // namespace grafwire
