#pragma once

#include "kernels/contact/distribute/ContactForce.h"
#include "parallel/CpuExecutor.h"

#include <vector>

namespace fpm::test {

using V = Vec3<double>;
inline constexpr double normalStiffness = 100, tangentialRatio = 0.5, step = 1e-3;

/// As in ContactPassView.
struct Faces {
    std::vector<Index> faceNode, nextAround, neighbour;
};
/// Two side by side.
inline Faces twoFaces()
{
    return {{1, 2, 5, 4, 2, 3, 6, 5},
            {0, 4, 7, 3, 1, 5, 6, 2},
            {freeEdge, 7, freeEdge, freeEdge, freeEdge, freeEdge, freeEdge, 1}};
}

/// What faces and contactor are, where it matters.
struct Setting {
    std::vector<double> faceStiffness{}; ///< empty: normalStiffness
    std::vector<float> faceThickness{};  ///< empty: 10
    std::vector<double> faceMass{};
    double contactorMass = 0, damping = 0;
    V ownNormal{0, 0, 0}; ///< unit normal of the contactor's own faces; 0: none
    std::vector<double> mirrorNormals{};
};

/// One contactor, node 0, against faces.
class OneContactor
{
public:
    explicit OneContactor(double friction,
                          std::vector<V> nodes,
                          Index face = 0,
                          Faces faces = twoFaces(),
                          Setting setting = {})
        : x_(std::move(nodes)),
          v_(x_.size(), V{0, 0, 0}),
          position_(3 * x_.size()),
          velocity_(3 * x_.size()),
          faces_(std::move(faces)),
          setting_(std::move(setting)),
          face_(face)
    {
        const std::size_t count = faces_.faceNode.size() / 4;
        if (setting_.faceStiffness.empty()) setting_.faceStiffness.assign(count, normalStiffness);
        if (setting_.faceThickness.empty()) setting_.faceThickness.assign(count, 10);
        for (Index node = 0; node < Index(x_.size()); ++node) contactNumber_.push_back(node);
        law_.count = 1;
        law_.tangentialForce = tangentialForce_;
        law_.frictionFace = &frictionFace_;
        law_.springEnergy = &springEnergy_;
        law_.dissipated = &dissipated_;
        law_.limitFactor = 1;
        law_.dampingRatio = setting_.damping;
        law_.contactorMass = &setting_.contactorMass;
        law_.dampingForce = &dampingForce_;
        law_.damped = &damped_;
        view().setOwnNormal(0, setting_.ownNormal);
        clock_.step = step;
        press(); // finds the projection point
        law_.friction = {friction, friction, 0, tangentialRatio, false};
        press();
    }

    /// Moves the nodes in one step.
    void move(const std::vector<V>& way)
    {
        for (std::size_t i = 0; i < x_.size(); ++i) {
            x_[i] += way[i];
            v_[i] = (1 / step) * way[i];
        }
        press();
    }
    /// Stores a tangential force.
    void hold(const V& force)
    {
        const FaceCorners<double> corners = view().corners(face_, contactor_);
        const V held = componentsIn(FaceFrame<double>(corners),
                                    intoPlane(force, gapAtClosest(corners, xi_, eta_).normal));
        tangentialForce_[0] = held.x;
        tangentialForce_[1] = held.y;
        tangentialForce_[2] = held.z;
        frictionFace_ = face_;
    }
    const std::vector<V>& nodes() const { return x_; }
    V force(std::size_t node) const
    {
        const auto at = [&](std::size_t c) { return scale_.toForce(sums_[4 * node + c]); };
        return {at(0), at(1), at(2)};
    }
    V moment() const
    {
        V sum{0, 0, 0};
        for (std::size_t i = 0; i < x_.size(); ++i) sum += cross(x_[i], force(i));
        return sum;
    }
    /// Energy of the tangential spring.
    double held() const
    {
        return (tangentialForce_[0] * tangentialForce_[0]
                + tangentialForce_[1] * tangentialForce_[1]
                + tangentialForce_[2] * tangentialForce_[2])
               / (2 * tangentialRatio * normalStiffness);
    }
    double lost() const { return dissipated_; }
    Index face() const { return face_; }
    double springEnergy() const { return springEnergy_; }
    bool onBorder() const { return std::abs(xi_) >= 1 || std::abs(eta_) >= 1; }

    ContactPassView<DoublePrecision> view()
    {
        ContactPassView<DoublePrecision> pair{};
        pair.contactorCount = pair.nodeCount = 1;
        pair.faceCount = Index(setting_.faceStiffness.size());
        pair.contactor = &contactor_;
        pair.contactNumber = contactNumber_.data();
        pair.faceNode = faces_.faceNode.data();
        pair.nextAround = faces_.nextAround.data();
        pair.neighbour = faces_.neighbour.data();
        pair.faceStiffness = setting_.faceStiffness.data();
        pair.faceThickness = setting_.faceThickness.data();
        pair.faceMass = setting_.faceMass.data();
        pair.mirrorNormal = setting_.mirrorNormals.data();
        pair.ownNormal = ownNormal_;
        pair.face = &face_;
        pair.xi = &xi_;
        pair.eta = &eta_;
        pair.around = &around_;
        pair.force = force_;
        pair.counts = counts_;
        pair.overlap = &overlap_;
        pair.heldStiffness = &heldStiffness_;
        pair.position = position_.data();
        pair.velocity = velocity_.data();
        pair.nodeStride = x_.size();
        pair.sums = {sums_.data(), scale_, true, nullptr};
        pair.clock = &clock_;
        pair.reach = 1;
        pair.law = law_;
        return pair;
    }

private:
    void press()
    {
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < x_.size(); ++i) {
                position_[c * x_.size() + i] = c == 0 ? x_[i].x : c == 1 ? x_[i].y : x_[i].z;
                velocity_[c * x_.size() + i] = c == 0 ? v_[i].x : c == 1 ? v_[i].y : v_[i].z;
            }
        sums_.assign(4 * x_.size(), 0);
        ContactForce<DoublePrecision, true>{view(), {noEntries_, nullptr, 0, 1, 0}}(
            CpuTeam<64>(nullptr), 0);
    }
    std::vector<V> x_, v_;
    std::vector<double> position_, velocity_;
    Faces faces_;
    Setting setting_;
    std::vector<Index> contactNumber_;
    PassLaw<double> law_{};
    StepClock clock_;
    ForceScale scale_{0x1p40, 0x1p-40, 0x1p20, 0x1p-20};
    std::vector<std::int64_t> sums_;
    Index contactor_ = 0, face_, frictionFace_ = 0;
    double xi_ = 0, eta_ = 0, tangentialForce_[3]{}, springEnergy_ = 0, dissipated_ = 0;
    double dampingForce_ = 0, damped_ = 0, heldStiffness_ = 0;
    float overlap_ = 0;
    Index noEntries_[2]{-1, -1}; ///< cell lists without faces
    std::int16_t ownNormal_[3]{};
    std::uint8_t around_ = aroundCurved;
    std::int64_t counts_[passCounts]{}, force_[BlockForce::values]{};
};

} // namespace fpm::test
