// What CaDiCaL asks of the machine. In a page there are no files, no signals and no clock, and the
// solver needs none: times and sizes go into statistics alone, and its random numbers begin with a
// number of its own.

#include "internal.hpp"

namespace CaDiCaL {

double absolute_real_time() {
    return 0;
}
double absolute_process_time() {
    return 0;
}
uint64_t maximum_resident_set_size() {
    return 0;
}
uint64_t current_resident_set_size() {
    return 0;
}

const char* version() {
    return "1.5.3";
}
const char* copyright() {
    return "";
}
const char* authors() {
    return "";
}
const char* affiliations() {
    return "";
}
const char* signature() {
    return "cadical-1.5.3";
}
const char* identifier() {
    return "";
}
const char* compiler() {
    return "";
}
const char* date() {
    return "";
}
const char* flags() {
    return "";
}

bool File::exists(const char*) {
    return false;
}
bool File::writable(const char*) {
    return false;
}
File* File::read(Internal*, FILE*, const char*) {
    return nullptr;
}
File* File::read(Internal*, const char*) {
    return nullptr;
}
File* File::write(Internal*, FILE*, const char*) {
    return nullptr;
}
File* File::write(Internal*, const char*) {
    return nullptr;
}
File::~File() = default;
void File::close() {}
void File::flush() {}

}  // namespace CaDiCaL
