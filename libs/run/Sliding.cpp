#include "run/Sliding.h"

#include "mesh/Vector.h"

#include <cmath>

namespace fpm {

namespace {

double coefficient(const ContactLaw& law, double speed)
{
    if (law.dynamicFriction < 0) return law.friction;
    return law.dynamicFriction
           + (law.friction - law.dynamicFriction) * std::exp(-law.frictionDecay * speed);
}

} // namespace

void Sliding::sample(double time, const PairStatus& status, const ContactPair& pair)
{
    const double step = lastTime_ < 0 ? 0 : time - lastTime_;
    lastTime_ = time;
    const double speed = vector::length(status.slip);
    if (!(status.normal > 0) || !(speed >= together * status.speed)) {
        window_ = {};
        return;
    }
    if (!(step > 0)) return;
    // Of what stands still for a while the slow part is no sliding.
    const double mean = window_.duration > 0 ? window_.path / window_.duration : 0;
    if (speed < 0.2 * mean) return;
    window_.path += speed * step;
    window_.duration += step;
    window_.asked += coefficient(pair, speed) * status.normal * step;
    window_.slip = vector::sum(window_.slip, vector::scaled(status.slip, step));
    window_.impulse = vector::sum(window_.impulse, vector::scaled(status.friction, step));
    const double elasticSlip =
        pair.friction * status.meanDepth * pair.normalScale / pair.tangentialScale;
    if (window_.path > manySprings * elasticSlip) close();
}

void Sliding::close()
{
    const double slip = vector::length(window_.slip);
    if (slip > straightShare * window_.path) {
        ++windows_;
        asked_ += window_.asked;
        const double delivered = -vector::dot(window_.impulse, window_.slip) / slip;
        delivered_ += delivered;
        if (window_.asked > 0 && delivered / window_.asked < worst_) {
            worst_ = delivered / window_.asked;
            worstTime_ = lastTime_;
        }
    }
    window_ = {};
}

void Sliding::keep(Archive& archive)
{
    for (double* value : {&window_.path, &window_.duration, &window_.asked, &lastTime_, &asked_,
                          &delivered_, &worst_, &worstTime_})
        archive(*value);
    archive(window_.slip);
    archive(window_.impulse);
    archive(windows_);
}

} // namespace fpm
