#pragma once

#include "model/ContactReader.h"

namespace fpm {

/// The sides of the mesh that `key` ("contactor" or "target") of a pair means, ascending: a surface
/// of contactDict, else the skin of a part, else a side set. `contactDict` lends its places. Throws
/// InputError for an unknown name and for a surface of which nothing is left.
std::vector<ElementSide> contactSides(const Mesh& mesh,
                                      const ContactEntries& entries,
                                      const PairEntry& pair,
                                      const std::string& key,
                                      const Dictionary& contactDict);

} // namespace fpm
