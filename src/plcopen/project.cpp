// PLCopen TC6 XML 2.01: the frame of a project.

#include "plcopen/project.h"

#include <cstddef>
#include <utility>

#include "iec/identifiers.h"
#include "text/version.h"

namespace grafwire::plcopen {

namespace {

/// Collects what pugixml writes; a stream would bring all of the C++ locales into a page.
class TextWriter final : public pugi::xml_writer {
  public:
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
    }
    std::string text;
};

/// The file says nothing of when it was made: the same chart gives the same bytes.
constexpr const char* some_date = "1970-01-01T00:00:00";

void add_headers(pugi::xml_node project, const std::string& name, const std::string& title) {
    pugi::xml_node file = project.append_child("fileHeader");
    file.append_attribute("companyName") = "grafwire";
    file.append_attribute("productName") = "grafwire";
    file.append_attribute("productVersion") = std::string(version()).c_str();
    file.append_attribute("creationDateTime") = some_date;
    pugi::xml_node content = project.append_child("contentHeader");
    content.append_attribute("name") = name.c_str();
    if (!title.empty()) {
        content.append_child("Comment").append_child(pugi::node_pcdata).set_value(title.c_str());
    }
    pugi::xml_node coordinates = content.append_child("coordinateInfo");
    for (const char* language : {"fbd", "ld", "sfc"}) {
        pugi::xml_node scaling = coordinates.append_child(language).append_child("scaling");
        scaling.append_attribute("x") = 8;
        scaling.append_attribute("y") = 8;
    }
}

void add_instance(pugi::xml_node project, const std::string& program) {
    pugi::xml_node configuration = project.append_child("instances")
                                       .append_child("configurations")
                                       .append_child("configuration");
    configuration.append_attribute("name") = "config";
    pugi::xml_node resource = configuration.append_child("resource");
    resource.append_attribute("name") = "plc";
    pugi::xml_node task = resource.append_child("task");
    task.append_attribute("name") = "scan";
    task.append_attribute("interval") = "T#10ms";
    task.append_attribute("priority") = 0;
    pugi::xml_node instance = task.append_child("pouInstance");
    instance.append_attribute("name") = "main";
    instance.append_attribute("typeName") = program.c_str();
}

}  // namespace

Project::Project(const std::string& name, const std::string& title) {
    iec::Identifiers programs;
    const std::string program = programs.add({name}).front();
    pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node project = document_.append_child("project");
    project.append_attribute("xmlns") = "http://www.plcopen.org/xml/tc6_0201";
    project.append_attribute("xmlns:xhtml") = "http://www.w3.org/1999/xhtml";
    add_headers(project, name, title);
    pugi::xml_node types = project.append_child("types");
    types.append_child("dataTypes");
    program_ = types.append_child("pous").append_child("pou");
    program_.append_attribute("name") = program.c_str();
    program_.append_attribute("pouType") = "program";
    add_instance(project, program);
}

std::string Project::text() const {
    TextWriter writer;
    document_.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(writer.text);
}

}  // namespace grafwire::plcopen
