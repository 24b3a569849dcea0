#pragma once

#include "base/Log.h"
#include "dictionary/Dictionary.h"
#include "model/Model.h"

namespace fpm {

/// `algorithm paper`: what Wang et al. 2023 print, in all parts and pairs: rotation by arcsines
/// (eqs. 4-5), strain at the geometry the step starts from, connected lists and the closest
/// particle of 27 cells at every step, projection on all faces around it, friction of eqs. 17-18.
/// Warns of every entry that says otherwise; throws for elements and contact that the paper lacks.
void applyPaperAlgorithm(Model& model,
                         const Dictionary& control,
                         const Dictionary& parts,
                         const Dictionary& contact,
                         Log& log);

/// The same choices in a model without a dictionary.
void takePaperForms(Model& model);

} // namespace fpm
