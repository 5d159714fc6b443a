#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace grafwire {

/// A name of a chart as words of letters, digits and single underscores, still readable: `V+` gives
/// `V_plus`, `Marche Moteur` gives `Marche_Moteur`, `étape` gives `etape`; letters of other scripts
/// are written as their code points, `温` as `u6E29`. Begins with a letter. Different names may
/// give the same word; SafeNames keeps them apart.
std::string ascii_word(std::string_view name);

/// Names for one program: each is given once, and none is a word of the language. The first to ask
/// for a name has it; later ones get it with a number, `V_2`.
class SafeNames {
  public:
    /// `is_reserved` is asked about names as they are compared: in lower case where case does not
    /// matter in the language.
    SafeNames(bool case_matters, std::function<bool(std::string_view)> is_reserved)
        : case_matters_(case_matters), is_reserved_(std::move(is_reserved)) {}

    std::string claim(std::string_view wanted);
    /// The same for what is a word of the language already.
    std::string claim_word(std::string word);
    /// Takes a name, which must be a word of the language, as it is; false where it is reserved or
    /// taken already.
    bool keep(const std::string& name);

  private:
    std::string folded(std::string name) const;

    bool case_matters_;
    std::function<bool(std::string_view)> is_reserved_;
    /// The names given, as they are compared, each with the number tried last to tell it from
    /// others.
    std::unordered_map<std::string, std::uint32_t> taken_;
};

}  // namespace grafwire
