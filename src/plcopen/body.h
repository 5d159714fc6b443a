#pragma once

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace grafwire::plcopen {

/// A point of a drawing in a PLCopen project, in its own units (about pixels).
struct Point {
    int x = 0;
    int y = 0;
};

/// Where power, a token or a value comes from.
struct Outlet {
    std::uint64_t id = 0;   ///< localId
    std::string parameter;  ///< of a block with several outputs; else empty
    Point at;
};

/// Writes graphical elements into a body (LD or SFC): numbers them, and says how they are
/// connected.
class Body {
  public:
    explicit Body(pugi::xml_node body) : body_(body) {}

    /// An element with its localId, place and size.
    pugi::xml_node element(const char* name, Point corner, int width, int height);
    std::uint64_t new_id() { return next_id_++; }
    static std::uint64_t id_of(pugi::xml_node element);
    /// A connectionPointIn at `at`, with wires to where it is fed from.
    static void inlet(pugi::xml_node owner, Point corner, Point at,
                      const std::vector<Outlet>& sources, const char* name = "connectionPointIn");
    /// A connectionPointOut; `named` ones carry an (empty) formalParameter, as the schema wants it
    /// of some elements.
    static void outlet(pugi::xml_node owner, Point corner, Point at, bool named = false,
                       const char* name = "connectionPointOut");
    void comment(Point corner, int width, const std::string& text);
    /// An inVariable with an expression, its outlet at `end`.
    Outlet value(Point end, const std::string& expression);

  private:
    pugi::xml_node body_;
    std::uint64_t next_id_ = 1;
};

/// `<xhtml:p>text</xhtml:p>` in a documentation or content element.
void add_text(pugi::xml_node parent, const std::string& text);

}  // namespace grafwire::plcopen
