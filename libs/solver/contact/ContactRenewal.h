#pragma once

#include "solver/SolverFields.h"
#include "solver/contact/SurfaceErosion.h"

namespace fpm {

/// Contact after elements were deleted: surfaces without them, and of the contactors that stay
/// whatever is known of them: face, friction, forces of this time. What springs of vanished faces
/// held is booked as lost. By the host between steps: a step itself allocates nothing.
class ContactRenewal
{
public:
    ContactRenewal(const Model& model, SolverSetUp& setUp, SolverFields& fields);
    /// False where no surface changes. Lists have to be renewed after it.
    bool follow(const std::vector<bool>& deleted);
    /// The same for a run that goes on where these are deleted already: fields of the surfaces that
    /// are left, without values.
    bool rebuild(const std::vector<bool>& deleted);

private:
    void renewPass(std::size_t pass, const PassRenewal& from, const ForceScale& before);
    void renewForce(PassFields& renewed,
                    const PassFields& old,
                    const std::vector<Index>& touching,
                    const ForceScale& before) const;
    void
    bookLost(const PassFields& old, const PassRenewal& from, const std::vector<Index>& touching);
    void renewNodes(const std::vector<Index>& numbers, const ForceScale& before);
    void renewMovers();

    SolverSetUp& setUp_;
    SolverFields& fields_;
    SurfaceErosion erosion_;
};

} // namespace fpm
