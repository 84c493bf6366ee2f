#include "engine/Links.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "base/Interrupts.h"
#include "base/Memory.h"

namespace radlab::engine {

namespace {

constexpr double gatherRays = 96.0;  // for each patch, over its links by what they carry

// The links of every node, those of one node together.
struct Sorted {
    struct End {
        std::uint32_t other;
        double exchange, share;
    };
    std::vector<std::size_t> first;  // of each node, and the end
    std::vector<End> ends;

    Sorted(const std::vector<Link>& links, std::size_t nodes) : first(nodes + 1), ends(2 * links.size()) {
        for (const Link& link : links) ++first[link.a + 1], ++first[link.b + 1];
        for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for (const Link& link : links) {
            ends[next[link.a]++] = {link.b, link.exchange, link.share};
            ends[next[link.b]++] = {link.a, link.exchange, link.share};
        }
    }
};

}  // namespace

Links::Links(const PatchTree& patches, const Options& options)
    : tree(patches), exchanges(tree.shapes().patches, options.tolerance) {
    if (options.occlusion) visibility = std::make_unique<Visibility>(tree.shapes(), options.rays);
    const auto faces = static_cast<double>(tree.roots().size());
    requireMemory(faces * faces / 2.0 * (sizeof(Pair) + 2 * sizeof(Link)),
                  "the links between " + std::to_string(tree.roots().size()) + " faces",
                  "expected a scene of fewer faces, or shots (render: --unshot)");
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < tree.roots().size(); ++i)
        for (std::size_t j = i + 1; j < tree.roots().size(); ++j)
            pairs.push_back({tree.roots()[i], tree.roots()[j], Sight::partly});
    for (const Link& link : measured(pairs))
        if (link.exchange > 0.0) links.push_back(link);
    settle(links);
}

// A hull may be larger than the patches in it.
double Links::unhidden(std::uint32_t a, std::uint32_t b) const {
    const std::vector<Polygon>& shapes = tree.shapes().patches;
    return exchanges(a, b) * (tree.area(a) / shapes[a].area) * (tree.area(b) / shapes[b].area);
}

Link Links::measured(const Pair& pair) const {
    Link link{pair.a, pair.b, Sight::clear, unhidden(pair.a, pair.b), 1.0};
    if (link.exchange > 0.0 && visibility && pair.sight != Sight::clear) link.sight = visibility->sight(pair.a, pair.b);
    if (link.sight == Sight::hidden) link.exchange = 0.0;
    return link;
}

std::vector<Link> Links::measured(const std::vector<Pair>& pairs) const {
    std::vector<Link> made(pairs.size());
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        Interrupts::check();
        made[i] = measured(pairs[i]);
    });
    return made;
}

// Finds the visible share of links that stay.
void Links::settle(std::vector<Link>& fresh) const {
    tbb::parallel_for(std::size_t{0}, fresh.size(), [&](std::size_t i) {
        Interrupts::check();
        if (fresh[i].sight == Sight::partly) fresh[i].share = visibility->visibleShare(fresh[i].a, fresh[i].b);
    });
}

std::array<Links::Pair, 2> Links::halves(const Link& link) const {
    const std::vector<Polygon>& shapes = tree.shapes().patches;
    const bool splitA = !tree.isLeaf(link.a) && (tree.isLeaf(link.b) || shapes[link.a].radius >= shapes[link.b].radius);
    const PatchTree::Node& node = tree.node(splitA ? link.a : link.b);
    if (splitA) return {Pair{node.first, link.b, link.sight}, Pair{node.second, link.b, link.sight}};
    return {Pair{link.a, node.first, link.sight}, Pair{link.a, node.second, link.sight}};
}

bool Links::refine(const std::function<bool(const Link&)>& wantedFiner) {
    const auto isSplit = [&](const Link& link) { return !isFinal(link) && wantedFiner(link); };
    std::vector<Link> kept, fresh, current = std::move(links);
    bool first = true, any = false;
    while (!current.empty()) {
        std::vector<Pair> pairs;
        for (const Link& link : current) {
            Interrupts::check();
            if (isSplit(link))
                for (const Pair& half : halves(link)) pairs.push_back(half);
            else if (link.exchange > 0.0)
                (first ? kept : fresh).push_back(link);
        }
        any = any || !pairs.empty();
        current = measured(pairs);
        first = false;
    }
    settle(fresh);
    links = std::move(kept);
    links.insert(links.end(), fresh.begin(), fresh.end());
    return any;
}

Transport Links::transport() const {
    const auto sorted = std::make_shared<Sorted>(links, tree.size());
    std::vector<double> areas;
    for (std::size_t i = 0; i < tree.leaves(); ++i) areas.push_back(tree.area(i));
    return {areas, [this, sorted](const std::vector<double>& x, std::vector<double>& result) {
                std::vector<double> sent = x, arrived(tree.size());
                tree.pull(sent);
                tbb::parallel_for(std::size_t{0}, tree.size(), [&](std::size_t i) {
                    double sum = 0.0;
                    for (std::size_t k = sorted->first[i]; k < sorted->first[i + 1]; ++k)
                        sum += sorted->ends[k].exchange * sorted->ends[k].share * sent[sorted->ends[k].other];
                    if (sum != 0.0) arrived[i] = sum / tree.area(i);
                });
                tree.push(arrived);
                for (std::size_t i = 0; i < result.size(); ++i) result[i] = tree.area(i) * arrived[i];
            }};
}

// What arrives at patches over the links of their clusters, each taken for the patch alone.
class Links::Gathering {
public:
    Gathering(const Links& between, const std::vector<Point>& radiosity)
        : links(between),
          tree(links.tree),
          sorted(links.links, tree.size()),
          sent(radiosity),
          hiding(sorted.ends.size()) {
        tree.pull(sent);
        tbb::parallel_for(tree.leaves(), tree.size(), [&](std::size_t cluster) {
            Interrupts::check();
            for (std::size_t k = sorted.first[cluster]; k < sorted.first[cluster + 1]; ++k)
                if (isPartly(k)) links.visibility->sight(cluster, sorted.ends[k].other, hiding[k]);
        });
    }

    Point arrivingAt(std::uint32_t patch) const {
        thread_local std::vector<Hidden> hidden;
        hidden.clear();
        Point sum = overOwn(patch);
        double partly = 0.0;
        for (std::uint32_t up = tree.node(patch).parent; up != PatchTree::none; up = tree.node(up).parent)
            for (std::size_t k = sorted.first[up]; k < sorted.first[up + 1]; ++k) {
                const Point light = links.unhidden(patch, sorted.ends[k].other) * sent[sorted.ends[k].other];
                if (!isPartly(k))
                    sum += light;
                else if (light != Point(0.0)) {
                    hidden.push_back({k, light});
                    partly += added(light);
                }
            }
        const double raysByLight = gatherRays / (added(sum) + partly);
        for (const Hidden& one : hidden)
            sum += one.light *
                   links.visibility->sharePast(hiding[one.end], patch, sorted.ends[one.end].other,
                                               static_cast<std::size_t>(std::ceil(raysByLight * added(one.light))));
        return sum / tree.area(patch);
    }

private:
    struct Hidden {
        std::size_t end;
        Point light;  // if nothing hid it
    };

    static double added(const Point& light) { return light.x + light.y + light.z; }
    bool isPartly(std::size_t end) const { return sorted.ends[end].share < 1.0; }

    Point overOwn(std::uint32_t patch) const {
        Point sum(0.0);
        for (std::size_t k = sorted.first[patch]; k < sorted.first[patch + 1]; ++k)
            sum += sorted.ends[k].exchange * sorted.ends[k].share * sent[sorted.ends[k].other];
        return sum;
    }

    const Links& links;
    const PatchTree& tree;
    Sorted sorted;
    std::vector<Point> sent;
    std::vector<Blockers> hiding;  // of each link that is not clear
};

std::vector<Point> Links::gathered(const std::vector<Point>& radiosity) const {
    const Gathering gathering(*this, radiosity);
    std::vector<Point> arrived(tree.leaves(), Point(0.0));
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(tree.leaves()), [&](std::uint32_t patch) {
        Interrupts::check();
        if (tree.area(patch) > 0.0) arrived[patch] = gathering.arrivingAt(patch);
    });
    return arrived;
}

}  // namespace radlab::engine
