#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <memory>

#include "grader/protocol/State.h"

namespace radlab::grader {

/// A number that stands for what went into it, in its order.
class Fingerprint {
public:
    void add(std::uint64_t word) { hash = std::rotl((hash ^ word) * 0x9e3779b97f4a7c15u, 29); }
    void add(int value) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(value))); }
    void add(float value) { add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value))); }
    void add(const Vec3f& v) {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    /// Where patches and corners are; not what light does on them.
    void addShape(const State& state) {
        for (const MyPolygon& patch : state.patches) {
            add(patch.vertices);
            for (int i = 0; i < patch.vertices; ++i) add(patch.vertex[i]);
        }
        for (const MyVertex& corner : state.corners) add(corner.position);
    }
    std::uint64_t value() const { return hash; }

private:
    std::uint64_t hash = 0x243f6a8885a308d3u;
};

/// Values that take long to make, kept by the fingerprint of what they follow from: mistakes share most of their pictures.
///
/// @tparam most  values that are kept, by default enough for a stage's 25 pictures; the largest take 5 MB
template <class Value, std::size_t most = 64>
class Remembered {
public:
    template <class Make>
    std::shared_ptr<const Value> get(const Fingerprint& key, const Make& make) {
        if (const auto found = values.find(key.value()); found != values.end()) return found->second;
        if (values.size() >= most) values.clear();
        const auto made = std::make_shared<const Value>(make());
        values[key.value()] = made;
        return made;
    }

private:
    std::map<std::uint64_t, std::shared_ptr<const Value>> values;
};

}  // namespace radlab::grader
