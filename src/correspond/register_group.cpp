#include "foramen/correspond/register_group.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "correspond/member_archive.hpp"
#include "correspond/member_steps.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/sampling/torus_grid.hpp"

namespace foramen {
namespace {

PreparedTemplate reference_template(const Reference& reference, const RegisterGroupOptions& options,
                                    const RunContext& ctx) {
  return {remeshed_template(reference.mesh(), reference.shape_map.map, options.mean.vertices, ctx), options};
}

// Of the options those that decide a member's first registration; the others have their defaults.
RegisterGroupOptions options_of_first(RegisterGroupOptions options) {
  const RegisterGroupOptions defaults;
  if (options.bending == Bending::cohort) options.bending = Bending::smooth;  // nothing is learnt yet
  options.cohort = defaults.cohort;
  options.again = defaults.again;
  options.round_limit = defaults.round_limit;
  options.still_mm = defaults.still_mm;
  options.description_rounds = defaults.description_rounds;
  options.description = defaults.description;
  options.mean.grid_points = defaults.mean.grid_points;
  return options;
}

// The same of a later registration, to a template that is given.
RegisterGroupOptions options_of_later(RegisterGroupOptions options) {
  const RegisterGroupOptions defaults;
  options.initial_map = defaults.initial_map;
  options.edge_cost = defaults.edge_cost;
  options.first = defaults.first;
  options.mean = defaults.mean;
  options.round_limit = defaults.round_limit;
  options.still_mm = defaults.still_mm;
  options.description_rounds = defaults.description_rounds;
  return options;
}

class GroupRegistrar {
 public:
  GroupRegistrar(const std::vector<Mesh>& shapes, const Reference& reference, int reference_index,
                 const RunContext& ctx, const RegisterGroupOptions& options)
      : reference_(reference),
        reference_index_(reference_index),
        ctx_(ctx),
        options_(options),
        steps_(reference, ctx, options),
        members_(shapes.size()) {
    for (std::size_t i = 0; i < shapes.size(); ++i) members_[i].input = &shapes[i];
    result_.members.resize(shapes.size());
  }

  GroupRegistration run() {
    const PreparedTemplate first = reference_template(reference_, options_, ctx_);
    for_each_member("simplify", [&](int i) {
      Member& member = members_[i];
      const StageKey key(ctx_, "working mesh", *member.input, options_.working_vertices);
      member.working = kept<WorkingMesh>(ctx_, key, [&] { return steps_.simplified(*member.input); });
      member.made_from = key;
    });
    const StageKey to_reference(ctx_, "group's reference", reference_, options_of_first(options_));
    advance_each_member("register", to_reference, [&](int i) {
      Member& member = members_[i];
      steps_.begin(member, alignment_of(i), first);
    });
    const PreparedTemplate* last = &first;
    StageKey to_last(ctx_, "group's template", to_reference, options_of_later(options_));
    std::unique_ptr<PreparedTemplate> mean;
    GroupTemplate& group = result_.last_template;
    // In the first round the prior comes from maps that were computed without it, so a second round is always
    // made.
    const int least_rounds = options_.bending == Bending::cohort ? 2 : 1;
    for (int round = 0; round < options_.round_limit; ++round) {
      MeanTemplate next = next_mean();
      if (round > 0) result_.template_motion_mm.push_back(distance_of_means(group.grid, next.grid));
      // If the mean has converged, the rounds end before it replaces the template, because the bent shapes
      // are still in the old template's frame.
      if (round >= least_rounds && result_.template_motion_mm.back() < options_.still_mm) break;
      take_transforms(next.transforms);
      to_last = StageKey(ctx_, "group's mean", all_made_from(), options_.mean, options_of_later(options_));
      mean = std::make_unique<PreparedTemplate>(next.surface, options_);
      last = mean.get();
      group = {round + 1, std::move(next.surface), std::move(next.grid), {}};
      for_each_member("place", [&](int i) { steps_.place(members_[i], *mean); });
      if (options_.bending == Bending::cohort) learn_priors(*mean);
      group.prior = priors_.of_newcomer();
      advance_each_member("round " + std::to_string(round + 1), to_last, [&](int i) {
        Member& member = members_[i];
        steps_.again(member, *mean, priors_.of_member(member.place_in_priors));
      });
    }
    for (int round = 0; round < options_.description_rounds; ++round) {
      const StageKey described(ctx_, "group's description", to_last, all_made_from());
      describe(*last);
      advance_each_member("describe " + std::to_string(round + 1), described, [&](int i) {
        Member& member = members_[i];
        steps_.improve(member, transformed(member.working.mesh, member.to_template), *last);
      });
    }
    const StageKey finished = options_.description_rounds > 0
                                  ? StageKey(ctx_, "group's description", to_last, all_made_from())
                                  : to_last;
    if (options_.description_rounds > 0) describe(*last);
    advance_each_member("finish", finished, [&](int i) { steps_.finish(members_[i], *last); });
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (result_.members[i].failure.empty()) result_.members[i].registered = std::move(members_[i].result);
    return std::move(result_);
  }

 private:
  // One shape at a time on each thread: a thread pool inside a thread pool gains nothing here.
  void for_each_member(const std::string& stage, const std::function<void(int)>& body) {
    std::atomic<int> done{0};
    parallel_for(static_cast<int>(members_.size()), ctx_, [&](int i) {
      GroupMember& member = result_.members[i];
      if (!member.failure.empty()) return;
      const auto start = std::chrono::steady_clock::now();
      try {
        body(i);
      } catch (const Cancelled&) {
        throw;
      } catch (const std::exception& e) {  // a defect of ours, too, must not cost the other shapes
        member.failure = e.what();
      }
      member.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const int finished = ++done;
      ctx_.step(stage, static_cast<double>(finished) / static_cast<double>(members_.size()),
                "shape " + std::to_string(finished) + " of " + std::to_string(members_.size()));
    });
  }

  // The same for a step that brings the members on: what each has come to is kept, or was and is taken up.
  // \param to  what the step takes beside the member
  void advance_each_member(const std::string& stage, const StageKey& to,
                           const std::function<void(int)>& step) {
    for_each_member(stage, [&](int i) {
      Member& member = members_[i];
      MemberState& state = member;
      member.made_from =
          StageKey(ctx_, stage.substr(0, stage.find(' ')), member.made_from, to, i == reference_index_);
      state = kept<MemberState>(ctx_, member.made_from, [&] {
        step(i);
        return std::move(state);
      });
    });
  }

  // What all members that are still there were made from.
  std::vector<StageKey> all_made_from() {
    std::vector<StageKey> keys;
    for (const Member* member : present()) keys.push_back(member->made_from);
    return keys;
  }

  Alignment alignment_of(int i) const {
    if (i != reference_index_) return align(*members_[i].input, reference_.mesh(), ctx_.with_threads(1));
    Alignment identity;
    identity.converged = true;
    return identity;
  }

  MeanTemplate next_mean() {
    std::vector<std::unique_ptr<TorusLocator>> locators(members_.size());
    for_each_member("mean", [&](int i) {
      const std::size_t k = i;
      locators[k] = std::make_unique<TorusLocator>(members_[k].working.mesh, members_[k].map.map);
    });
    std::vector<const TorusLocator*> of_present;
    for (const auto& locator : locators)
      if (locator) of_present.push_back(locator.get());
    return mean_template(of_present, reference_.shape_map.map.lattice, ctx_, options_.mean);
  }

  std::vector<Member*> present() {
    std::vector<Member*> in;
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (result_.members[i].failure.empty()) in.push_back(&members_[i]);
    return in;
  }

  void take_transforms(const std::vector<SimilarityTransform>& transforms) {
    const std::vector<Member*> members = present();
    for (std::size_t k = 0; k < members.size(); ++k) members[k]->to_template = rigid(transforms[k]);
  }

  // What the members that are still there tell of each other.
  void learn_priors(const PreparedTemplate& to) {
    std::vector<std::vector<Vec3>> placed;
    for (Member* member : present()) {
      member->place_in_priors = static_cast<int>(placed.size());
      placed.push_back(member->bent);
    }
    priors_ = cohort_priors(to.surface.mesh, to.displacements, placed, options_.cohort);
    result_.unexplained_shares.push_back(priors_.unexplained_share);
  }

  // The cohort as its maps have it now, and what its description length draws every shape to.
  void describe(const PreparedTemplate& to) {
    const std::vector<Member*> members = present();
    std::vector<std::vector<Vec3>> lifted;
    for (const Member* member : members) {
      const TorusLocator locator(member->working.mesh, member->map.map);
      lifted.push_back(lift_to_surface(locator, to.surface.map.turns.values()));
    }
    const std::vector<double> areas = vertex_areas(to.surface.mesh).values();
    const ProcrustesResult aligned = procrustes(lifted, ScaleMode::keep, areas);
    DescriptionLength length = description_length(aligned.aligned, areas, options_.description);
    result_.description_lengths.push_back(length.value);
    take_transforms(aligned.transforms);
    for (std::size_t k = 0; k < members.size(); ++k) members[k]->attractor = std::move(length.attractors[k]);
  }

  static double distance_of_means(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
    const SimilarityTransform motion = fit_similarity(after, before, ScaleMode::keep);
    double squares = 0;
    for (std::size_t k = 0; k < before.size(); ++k) squares += (motion(after[k]) - before[k]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(before.size()));
  }

  const Reference& reference_;
  int reference_index_;
  RunContext ctx_;
  const RegisterGroupOptions& options_;
  MemberSteps steps_;
  std::vector<Member> members_;
  CohortPriors priors_;  // of the present round; without Bending::cohort the smooth process
  GroupRegistration result_;
};

}  // namespace

GroupRegistration register_group(const std::vector<Mesh>& shapes, const Reference& reference,
                                 int reference_index, const RunContext& ctx,
                                 const RegisterGroupOptions& options) {
  FORAMEN_ASSERT(reference_index >= 0 && reference_index < static_cast<int>(shapes.size()));
  return GroupRegistrar(shapes, reference, reference_index, ctx, options).run();
}

RegisteredShape register_to_group(const Mesh& shape, const Reference& reference, const GroupTemplate& group,
                                  const RunContext& ctx, const RegisterGroupOptions& options) {
  if (options.description_rounds > 0)
    throw InvalidInput(
        "a shape cannot be registered to a group that was made with description_rounds > 0: their targets "
        "are "
        "those of the group's own shapes");
  const RunContext single = ctx.with_threads(1);
  const MemberSteps steps(reference, single, options);
  Member member;
  member.input = &shape;
  member.working = steps.simplified(shape);
  const PreparedTemplate first = reference_template(reference, options, single);
  steps.begin(member, align(shape, reference.mesh(), single), first);
  if (group.rounds == 0) {
    steps.finish(member, first);
    return std::move(member.result);
  }
  const PreparedTemplate mean(group.surface, options);
  const TorusGrid grid = make_torus_grid(reference.shape_map.map.lattice, options.mean.grid_points);
  for (int round = 0; round < group.rounds; ++round) {
    steps.newcomer_round(member, grid.turns, group.grid, mean, group.prior);
  }
  steps.finish(member, mean);
  return std::move(member.result);
}

}  // namespace foramen
