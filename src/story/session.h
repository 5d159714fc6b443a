#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "story/stepped_run.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What a session says to a line.
struct SessionReply {
    std::string text;          ///< to be shown, whole lines
    bool is_refusal = false;   ///< the text says why the line was not obeyed; nothing has changed
    bool is_over = false;      ///< no more lines are expected
    std::string save_path;     ///< not empty: the file that is asked for …
    std::string save_stimuli;  ///< … and its text, a `.stim`
};

/// A GRAFCET stepped through line by line: lines in, words out. It reads and writes nothing itself.
///
///     a=1 b=0          inputs change: an instant of its own; by scans, what the next scan reads
///     +500ms           time passes; delays end meanwhile, scans are done
///     2s : a=0         a line as in a `.stim` text
///     scan             the next scan; without scans, the instant at which the next delay ends
///     back             takes back the last line that had an effect, any number of times
///     show             situation, inputs, outputs, what the enabled transitions wait for
///     save FILE        all of this as stimuli
///     help, quit
///
/// Inputs that break an assumption of the GRAFCET are obeyed, with a warning.
///
/// Without scans, the first inputs are those of the instant 0, and later ones without a time change
/// a millisecond after the last instant. The GRAFCET must outlive the session.
class Session {
  public:
    /// By scans with that period, or until stable (none).
    Session(const Grafcet& grafcet, std::optional<Time> period, Language language);

    /// What a user at a terminal sees first.
    std::string greeting() const;
    /// What stands before a line that is expected: `500 ms> `.
    std::string prompt() const;
    /// What a line may begin with, in the language of the session: commands and `input=`.
    std::vector<std::string> beginnings() const;

    SessionReply answer(std::string_view line);

  private:
    enum class Word { scan, back, show, save, help, quit };

    std::optional<Word> command_of(std::string_view line, std::string_view& rest) const;
    SessionReply obey(Word word, std::string_view rest);
    SessionReply scan();
    SessionReply back();
    SessionReply save(std::string_view path) const;
    SessionReply change(std::string_view line);
    /// Goes on to a moment, with the inputs changed at its end (SteppedRun::advance).
    SessionReply advance(Time to, const std::vector<Stimuli::Assignment>& assignments,
                         bool has_instant);
    std::string broken_assumptions() const;
    std::string shown() const;

    const Grafcet& grafcet_;
    Language language_;
    SteppedRun run_;
};

}  // namespace grafwire
