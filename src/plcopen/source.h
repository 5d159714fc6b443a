#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace grafwire::plcopen {

/// A PLCopen file while it is read: the document, and the places of its elements.
class Source {
  public:
    /// `code` is what the reader calls a fault of the contents.
    Source(const SourceFile& source, Code code, Diagnostics& diagnostics);

    /// False where the text is no XML; that has been reported.
    bool is_read() const { return is_read_; }
    pugi::xml_node root() const { return document_.document_element(); }
    Location place_of(pugi::xml_node node) const;
    void error(pugi::xml_node node, Localized message) const {
        diagnostics_.error(code_, place_of(node), std::move(message));
    }
    void error(Location where, Localized message) const {
        diagnostics_.error(code_, where, std::move(message));
    }

    std::size_t error_count() const { return diagnostics_.error_count(); }

    /// Reports a name that holds a control character.
    void check_name(std::string_view name, pugi::xml_node node) const;

  private:
    Location place_at(std::size_t byte) const;

    const std::string& text_;
    Code code_;
    Diagnostics& diagnostics_;
    pugi::xml_document document_;
    std::vector<std::size_t> lines_;  ///< where they begin
    bool is_read_ = false;
};

/// The name of an element without a namespace prefix.
std::string_view local_name(pugi::xml_node node);
/// The first child of that local name; null where there is none.
pugi::xml_node child_named(pugi::xml_node parent, std::string_view name);
/// All the text in an element and below it, blanks at the ends removed and those between lines
/// folded, control characters replaced.
std::string text_of(pugi::xml_node node);

}  // namespace grafwire::plcopen
