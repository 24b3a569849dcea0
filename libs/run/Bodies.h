#pragma once

#include "model/Model.h"

#include <set>

namespace fpm {

/// Parts that hang together by common nodes, and what acts on them.
class Bodies
{
public:
    explicit Bodies(const Model& model);
    std::size_t count() const { return parts_.size(); }
    const std::vector<std::size_t>& parts(std::size_t body) const { return parts_[body]; }
    const std::vector<Index>& nodes(std::size_t body) const { return nodes_[body]; } ///< ascending
    /// Nodes of it are held or driven.
    bool isHeld(std::size_t body) const { return held_[body]; }
    /// It is held, driven, loaded, has an initial velocity or may touch something.
    bool isConcerned(std::size_t body) const { return concerned_[body]; }
    /// Contact between the two is defined.
    bool mayMeet(std::size_t a, std::size_t b) const;
    /// "part a", "parts a, b"
    std::string name(std::size_t body) const;

private:
    void join();
    void addConditions();
    void addContact();
    void concern(const std::vector<Index>& nodes, bool holds);
    void concern(std::size_t body, bool holds);
    std::set<std::size_t> bodiesOf(const std::vector<ElementSide>& sides) const;

    const Model& model_;
    std::vector<std::size_t> bodyOf_;   ///< of a part
    std::vector<std::size_t> nodeBody_; ///< of a node
    std::vector<std::vector<std::size_t>> parts_;
    std::vector<std::vector<Index>> nodes_;
    std::vector<bool> held_, concerned_;
    bool general_ = false; ///< all may meet all
    std::set<std::pair<std::size_t, std::size_t>> meet_;
};

} // namespace fpm
