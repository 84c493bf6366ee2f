#include "study/Plot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace radlab::study {

std::vector<double> spreadOut(std::vector<double> places, double gap, double low, double high) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
    double free = low;
    for (const std::size_t i : order) {  // up from below,
        places[i] = std::max(places[i], free);
        free = places[i] + gap;
    }
    double most = std::max(high, low + gap * static_cast<double>(places.size() - 1));
    for (auto i = order.rbegin(); i != order.rend(); ++i) {  // and down again what is now too high
        places[*i] = std::min(places[*i], most);
        most = places[*i] - gap;
    }
    return places;
}

std::vector<double> ticsBetween(double low, double high) {
    const bool few = std::log10(high / low) < 2.0;
    std::vector<double> tics;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10.0)
        for (const double times : {1.0, 2.0, 5.0})
            if ((few || times == 1.0) && power * times >= low && power * times <= high) tics.push_back(power * times);
    return tics;
}

}  // namespace radlab::study
