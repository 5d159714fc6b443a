#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "story/instant_story.h"
#include "text/message.h"

namespace grafwire {

/// An instant in words, with the rule of IEC 60848 at work behind each sentence:
///
///     At 1000 ms: start=1
///       (0) 1 -> 2 is cleared (rule 2): X1 is active and start.top is 1 (start=1 top=1)
///       deactivated: X1; activated: X2 (rule 3)
///       stable situation: X2
///       outputs at 1: SPINDLE, DOWN
///       enabled: (1) 2 -> 3, waits for bottom
std::string write_story(const Grafcet& grafcet, const InstantStory& story, Language language);

/// A whole run, its instants with an empty line between them.
std::string write_stories(const Grafcet& grafcet, const std::vector<InstantStory>& stories,
                          Language language);

/// How an instant ends, without what led there: situation, outputs and what is enabled.
std::string write_end(const Grafcet& grafcet, const InstantStory& story, Language language);

}  // namespace grafwire
