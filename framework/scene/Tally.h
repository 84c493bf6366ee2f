#pragma once

#include <map>
#include <string>
#include <vector>

namespace radlab {

/// Names with the number of times that each was seen, for one line of text.
class Tally {
public:
    void add(const std::string& name, int times = 1) {
        const auto [entry, isNew] = counts.try_emplace(name, 0);
        if (isNew) order.push_back(name);
        entry->second += times;
    }

    bool empty() const { return order.empty(); }

    /// The names in the order they were first seen: "Sphere (2), ImageTexture (1)"; past 20, how many more.
    std::string text() const {
        constexpr std::size_t most = 20;
        std::string result;
        for (std::size_t i = 0; i < order.size() && i < most; ++i)
            result += (i ? ", " : "") + order[i] + " (" + std::to_string(counts.at(order[i])) + ")";
        if (order.size() > most) result += " and " + std::to_string(order.size() - most) + " more names";
        return result;
    }

private:
    std::map<std::string, int> counts;
    std::vector<std::string> order;
};

}  // namespace radlab
