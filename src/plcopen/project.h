#pragma once

#include <pugixml.hpp>
#include <string>

namespace grafwire::plcopen {

/// A PLCopen TC6 XML 2.01 project with one program, which a task calls every 10 ms.
class Project {
  public:
    /// Of the chart's name and title; the program's name is an identifier made of it.
    Project(const std::string& name, const std::string& title);

    /// The program, still empty.
    pugi::xml_node program() { return program_; }
    std::string text() const;

  private:
    pugi::xml_document document_;
    pugi::xml_node program_;
};

}  // namespace grafwire::plcopen
