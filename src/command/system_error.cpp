// The C library has these texts in French too, but only where that locale is installed, and then in
// the one language of the locale.

#include "command/system_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace grafwire {

Localized reason_of(int error) {
    struct Row {
        int error;
        const char* french;
    };
    static constexpr Row rows[] = {
        {EPERM, "opération non permise"},
        {ENOENT, "aucun fichier ou dossier de ce nom"},
        {EIO, "erreur d'entrée/sortie"},
        {ENXIO, "aucun périphérique ou aucune adresse de ce nom"},
        {EACCES, "permission non accordée"},
        {EBUSY, "périphérique ou ressource occupé"},
        {EEXIST, "le fichier existe"},
        {ENODEV, "aucun périphérique de ce type"},
        {ENOTDIR, "n'est pas un dossier"},
        {EISDIR, "est un dossier"},
        {EINVAL, "argument invalide"},
        {ENFILE, "trop de fichiers ouverts dans le système"},
        {EMFILE, "trop de fichiers ouverts"},
        {ETXTBSY, "fichier exécutable en cours d'usage"},
        {EFBIG, "fichier trop grand"},
        {ENOSPC, "aucun espace disponible sur le périphérique"},
        {EROFS, "système de fichiers en lecture seule"},
        {EPIPE, "tube cassé"},
        {ENAMETOOLONG, "nom de fichier trop long"},
        {ELOOP, "trop de niveaux de liens symboliques"},
        {EDQUOT, "quota d'espace disque dépassé"},
    };
    std::string english = std::strerror(error);
    for (const Row& row : rows) {
        if (row.error == error) return {std::move(english), row.french};
    }
    return {english, fmt::format("erreur {} du système", error)};
}

}  // namespace grafwire
