#include "evaluation_peers.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_PEERS
#include "symscene/peers/euclidean_clusters.hpp"
#include "symscene/peers/felzenszwalb.hpp"
#include "symscene/peers/lccp.hpp"
#endif

namespace symscene::app {
namespace {

struct NamedPeer {
  std::string name;
  PeerMethod method;
};

#ifdef SYMSCENE_HAS_PEERS

PeerMasks to_masks(PeerSweep sweep) {
  return {std::move(sweep.method), std::move(sweep.parameter), std::move(sweep.values),
          std::move(sweep.segments)};
}

std::vector<NamedPeer> known_peers() {
  std::vector<NamedPeer> peers = {
      {"felzenszwalb", [](const PointCloud& cloud) { return to_masks(felzenszwalb_sweep(cloud)); }},
      {"euclidean", [](const PointCloud& cloud) { return to_masks(euclidean_sweep(cloud)); }}};
  if (has_lccp())
    peers.push_back({"lccp", [](const PointCloud& cloud) { return to_masks(lccp_sweep(cloud)); }});
  return peers;
}

#else

std::vector<NamedPeer> known_peers() { return {}; }

#endif

}  // namespace

std::string peer_names() {
  std::string names = "all, none";
  for (const NamedPeer& peer : known_peers()) names += ", " + peer.name;
  return names;
}

std::vector<PeerMethod> peer_methods(const std::string& names) {
  const std::vector<NamedPeer> known = known_peers();
  std::vector<PeerMethod> chosen;
  if (names == "none") return chosen;
  if (names == "all") {
    for (const NamedPeer& peer : known) chosen.push_back(peer.method);
    return chosen;
  }
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto peer = std::find_if(known.begin(), known.end(), [&](const NamedPeer& candidate) {
      return candidate.name == name;
    });
    if (peer == known.end()) {
      throw InputError("--peers", fmt::format("some of {}", peer_names()),
                       fmt::format("\"{}\"", name));
    }
    chosen.push_back(peer->method);
  }
  return chosen;
}

}  // namespace symscene::app
