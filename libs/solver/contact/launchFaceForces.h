#pragma once

#include "kernels/contact/distribute/ContactForce.h"
#include "solver/contact/ContactLaunches.h"
#include "solver/contact/PassView.h"

namespace fpm {

template <class Numbers, bool friction, class Executor>
void launchFaceForces(const LaunchContext<Executor>& on, std::size_t pass)
{
    PassFields& fields = *on.fields.contact.passes[pass];
    on.executor.parallelBlocks(
        NodeBlocks::blocks(Index(fields.contactor.size())), 0,
        ContactForce<Numbers, friction>{passView<Numbers>(on, pass),
                                        cellsOf(on.setUp.contact.passes[pass], fields)});
}

} // namespace fpm
