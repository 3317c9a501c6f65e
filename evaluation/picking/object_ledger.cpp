#include "object_ledger.hpp"

#include "clutter/found_mesh.hpp"

namespace symscene {
namespace {

void count(PickRun::Cleared& cleared, bool is_in_bin) {
  ++cleared.placed;
  if (is_in_bin) ++cleared.in_bin;
}

}  // namespace

ObjectLedger::ObjectLedger(const PickTable& table, const Gripper& gripper) : table_(table) {
  for (const PlacedObject& placed : table.tabletop.objects) {
    Entry entry;
    entry.graspable = graspability(world_mesh(placed), table.tabletop.plane(), gripper);
    entries_.push_back(std::move(entry));
  }
}

void ObjectLedger::note(const TableBelief& belief, const std::vector<BeliefFate>& fates,
                        const std::vector<std::size_t>& present,
                        const std::vector<TriangleMesh>& surfaces) {
  const TrueSurface truth(surfaces);
  for (Entry& entry : entries_) entry.fate.reset();
  true_objects_.assign(fates.size(), std::nullopt);
  for (std::size_t k = 0; k < fates.size(); ++k) {
    const Index mesh =
        found_mesh(belief.scene.objects[k].observed.positions, truth, surfaces.size());
    if (mesh == TrueSurface::Nearest::nothing) continue;
    true_objects_[k] = present[mesh];
    // Objects come in descending order of confidence: the first one says why.
    std::optional<BeliefFate>& fate = entries_[present[mesh]].fate;
    if (!fate) fate = fates[k];
  }
}

void ObjectLedger::note_attempt(const PickAttempt& attempt, const std::optional<std::size_t>& aim) {
  if (aim) entries_[*aim].attempts.push_back(attempt);
}

std::string ObjectLedger::reason(const Entry& entry, const std::string& not_looked_at) const {
  if (entry.is_fallen) return reason_fallen(entry.attempts);
  if (!not_looked_at.empty()) return "it was not looked at: " + not_looked_at;
  return reason_left(entry.fate, entry.attempts);
}

void ObjectLedger::finish(PickRun& run, const std::string& not_looked_at) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    count(run.all, entry.is_in_bin);
    if (entry.graspable.as_it_lies) count(run.graspable, entry.is_in_bin);
    if (entry.graspable.at_all) count(run.graspable_in_some_pose, entry.is_in_bin);
    if (entry.is_fallen) ++run.fallen;
    if (!entry.is_in_bin)
      run.left.push_back(
          {table_.tabletop.objects[i].object.name, entry.graspable, reason(entry, not_looked_at)});
  }
}

}  // namespace symscene
