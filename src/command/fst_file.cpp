// The VCD text is read back word by word and told to the library: what `vcd2fst` of GTKWave does.
// So there is one writer of waveforms, and both formats say the same.

#include "command/fst_file.h"

#include <cerrno>

#include "command/system_error.h"

#ifdef GRAFWIRE_HAS_FST

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <unordered_map>

#include "command/fst_library.h"
#include "command/new_file.h"
#include "gtkwave/fstapi.h"

namespace grafwire {

namespace {

/// The words of a VCD text, one after the other.
class VcdWords {
  public:
    explicit VcdWords(std::string_view text) : text_(text) {}

    /// Empty at the end.
    std::string_view next() {
        const std::size_t begin = text_.find_first_not_of(blanks, at_);
        if (begin == std::string_view::npos) return {};
        at_ = std::min(text_.find_first_of(blanks, begin), text_.size());
        return text_.substr(begin, at_ - begin);
    }
    /// All up to `$end`, without the blanks round it.
    std::string until_end() {
        const std::size_t begin = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        const std::size_t end = std::min(text_.find(" $end", begin), text_.size());
        at_ = std::min(end + 5, text_.size());
        return std::string(text_.substr(begin, end - begin));
    }

  private:
    static constexpr std::string_view blanks = " \n";

    std::string_view text_;
    std::size_t at_ = 0;
};

/// Tells the library what a VCD text says.
class FstWriter {
  public:
    /// A new file; is_open() says whether it could be made.
    explicit FstWriter(const std::string& path) : file_(fstWriterCreate(path.c_str(), 1)) {
        if (file_ == nullptr) return;
        fstWriterSetDate(file_, "");  // the same waveform, the same bytes
    }
    ~FstWriter() {
        if (file_ != nullptr) fstWriterClose(file_);
    }
    FstWriter(const FstWriter&) = delete;
    FstWriter& operator=(const FstWriter&) = delete;

    bool is_open() const { return file_ != nullptr; }

    void tell(std::string_view vcd) {
        VcdWords words(vcd);
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            if (word.front() == '$') {
                declare(word, words);
            } else if (word.front() == '#') {
                fstWriterEmitTimeChange(file_, std::stoull(std::string(word.substr(1))));
            } else if (word.front() == 'b') {
                change(words.next(), word.substr(1));
            } else {
                change(word.substr(1), word.substr(0, 1));
            }
        }
    }

  private:
    struct Signal {
        fstHandle handle = 0;
        std::size_t width = 1;
    };

    void declare(std::string_view keyword, VcdWords& words) {
        if (keyword == "$var") {
            declare_signal(words);
            return;
        }
        const std::string text = words.until_end();
        if (keyword == "$version") fstWriterSetVersion(file_, text.c_str());
        if (keyword == "$timescale") fstWriterSetTimescaleFromString(file_, text.c_str());
        if (keyword == "$comment") fstWriterSetComment(file_, text.c_str());
        if (keyword == "$upscope") fstWriterSetUpscope(file_);
        if (keyword == "$scope") {
            const std::string name = text.substr(text.find(' ') + 1);
            fstWriterSetScope(file_, FST_ST_VCD_MODULE, name.c_str(), nullptr);
        }
    }

    void declare_signal(VcdWords& words) {
        words.next();  // wire
        Signal signal;
        signal.width = std::stoul(std::string(words.next()));
        const std::string id(words.next());
        std::string name = words.until_end();
        if (signal.width > 1) name += " [" + std::to_string(signal.width - 1) + ":0]";
        signal.handle =
            fstWriterCreateVar(file_, FST_VT_VCD_WIRE, FST_VD_IMPLICIT,
                               static_cast<std::uint32_t>(signal.width), name.c_str(), 0);
        signals_[id] = signal;
    }

    /// Every bit of an unknown number is unknown.
    void change(std::string_view id, std::string_view value) {
        const Signal& signal = signals_[std::string(id)];
        std::string bits(value);
        if (bits == "x") bits.assign(signal.width, 'x');
        fstWriterEmitValueChange(file_, signal.handle, bits.c_str());
    }

    void* file_;
    std::unordered_map<std::string, Signal> signals_;
};

}  // namespace

bool can_write_fst() {
    return true;
}

std::optional<Localized> make_fst(std::string_view vcd, std::string& fst) {
    // The library keeps the names of signals in a file of its own until the end.
    const TemporaryFolder folder({"waveform.fst", "waveform.fst.hier"});
    if (!folder.is_made()) return reason_of(errno);
    const std::string path = folder.path_of("waveform.fst");
    fst_writing_error();
    {
        FstWriter writer(path);
        if (!writer.is_open()) return reason_of(errno);
        writer.tell(vcd);
    }
    if (const int error = fst_writing_error()) return reason_of(error);
    std::ifstream file(path, std::ios::binary);
    fst.assign(std::istreambuf_iterator<char>(file), {});
    if (!file || fst.empty()) return reason_of(EIO);
    return std::nullopt;
}

}  // namespace grafwire

#else

namespace grafwire {

bool can_write_fst() {
    return false;
}

std::optional<Localized> make_fst(std::string_view, std::string&) {
    return reason_of(ENOTSUP);
}

}  // namespace grafwire

#endif
